// From light on the sensor to grey levels.
#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

#include "sensors_models/base/yaml_reader.h"

namespace drydock::sim {

struct ImageSensorConfig {
  bool color = false;     ///< Deliver BGR rather than grey.
  double exposure = 1.6;  ///< Radiance times this saturates at 1.
  double gamma = 2.2;     ///< Code = 255 * (exposed light)^(1/gamma).
};

/// Reads its keys of the mapping `sensors.stereo` of a scenario.
ImageSensorConfig ReadImageSensor(YamlReader& yaml);

/// Exposes, codes and quantises a radiance image.
class ImageSensor {
 public:
  explicit ImageSensor(const ImageSensorConfig& config);

  /// `radiance`: CV_32FC3, red, green, blue; or CV_32FC1. `image`: CV_8UC3 (BGR) or CV_8UC1, as the
  /// input has channels.
  void Expose(const cv::Mat& radiance, cv::Mat& image) const;

 private:
  static constexpr int kCodes = 4096;
  float scale_;
  std::vector<unsigned char> code_;  ///< Grey level of exposed light i / kCodes.
};

}  // namespace drydock::sim
