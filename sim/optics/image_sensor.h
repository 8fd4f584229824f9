// From light on the sensor to grey levels.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "sensors_models/base/random_stream.h"
#include "sensors_models/base/yaml_reader.h"
#include "sensors_models/measurement/rig.h"

namespace drydock::sim {

struct ImageSensorConfig {
  bool color = false;  ///< Deliver BGR rather than grey.
  /// Radiance times this fills the well, through the whole dive; without it the camera exposes by
  /// itself.
  std::optional<double> exposure;
  bool noise = true;       ///< Shot and read noise.
  bool vignetting = true;  ///< Light falling off towards the corners.
};

/// Reads its keys of the mapping `sensors.stereo` of a scenario.
ImageSensorConfig ReadImageSensor(YamlReader& yaml);

/// How an image is exposed: a radiance times sensitivity, shutter and gain is a share of full
/// scale.
struct Exposure {
  double shutter_s = 0.0;
  double gain = 1.0;  ///< Of the amplifier, linear.

  /// Radiance times this saturates at 1.
  double Scale(const ImagerSheet& imager) const {
    return imager.sensitivity_per_s * shutter_s * gain;
  }
};

/// The exposure with this scale: by the shutter as far as it goes, then by gain, within what the
/// sheet allows.
Exposure ExposureOfScale(double scale, const ImagerSheet& imager);

/// One eye's sensor: vignetting, exposure, shot and read noise, gamma curve, 8 bits.
///
/// With x the light's share of full scale, the reading is x + N(0, x a + s^2), a = gain / full
/// well, s = read noise * a: shot noise is Poisson's, which is normal at the hundreds of electrons
/// that matter.
class ImageSensor {
 public:
  /// `stream` names this eye's noise.
  ImageSensor(const ImagerSheet& imager, const ImageSensorConfig& config,
              const CameraIntrinsics& camera, std::uint64_t seed, const std::string& stream);

  /// `radiance`: CV_32FC3, red, green, blue; or CV_32FC1, of the camera's size. `image`: CV_8UC3
  /// (BGR) or CV_8UC1, as the input has channels. Noise is that of frame `index` of the rig.
  void Expose(const cv::Mat& radiance, const Exposure& exposure, std::int64_t index,
              cv::Mat& image) const;

 private:
  static constexpr int kCodes = 4096;

  ImagerSheet imager_;
  bool noise_;
  RandomStream stream_;
  cv::Mat falloff_;  ///< CV_32FC1, share of the light that reaches each pixel.
  /// Grey level of light (i / (kCodes - 1))^2: squares, so that the dark end has codes enough.
  std::array<unsigned char, kCodes> code_ = {};
};

}  // namespace drydock::sim
