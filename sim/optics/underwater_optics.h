// Light under water: from what surfaces reflect to what reaches the camera.
#pragma once

#include <array>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "sensors_models/base/pose.h"
#include "sim/optics/water_config.h"
#include "sim/render/renderer.h"

namespace drydock::sim {

enum class ImageChannels {
  kMonochrome,  ///< CV_32FC1: what a sensor without colour filters makes of red, green and blue.
  kColor,       ///< CV_32FC3: red, green, blue.
};

/// Lights a raw image per pixel, in linear light, by daylight that fades with depth, and sends it
/// through the water.
///
/// For each channel, with r the range along the ray, s the ray's upward slope, rho the surface's
/// reflectance and the daylight at the camera as unit:
///   J = rho exp(Kd s r) (sun_share max(0, n . sun) + (1 - sun_share) sky(n))    lit surface
///   I = J exp(-c r) + B (1 - exp(-beta r))                                      seen through water
/// Daylight scattered once towards the camera along the ray gives the veil its own coefficient,
/// beta = c - Kd s (it is brighter upwards), and its radiance in deep water, B = veil (b/c) c /
/// beta. beta is kept above 0.3 c: the surface is never far. Radiance 1 is what a white card sends
/// out that lies flat at the camera's depth.
class UnderwaterOptics {
 public:
  UnderwaterOptics(const WaterConfig& water, const Pinhole& pinhole);

  /// `raw` is of this optics' pinhole, taken at `T_WC`. `radiance` is reused if it fits.
  void Apply(const RawImage& raw, const Pose& T_WC, ImageChannels channels, cv::Mat& radiance);

  /// One number a channel.
  using Channels = std::array<float, 3>;

 private:
  void DecodeAlbedo(const cv::Mat& albedo, int row);

  Pinhole pinhole_;
  float sun_share_;
  Eigen::Vector3d sun_W_;               ///< Unit vector towards the sun.
  Channels beam_attenuation_;           ///< c
  Channels diffuse_attenuation_;        ///< Kd
  Channels veil_;                       ///< veil b/c
  std::array<float, 256> linear_ = {};  ///< sRGB code to linear light.

  // Rows in work, kept from call to call.
  std::vector<float> columns_;                ///< (u - cx) / focal
  std::array<std::vector<float>, 3> albedo_;  ///< Linear.
  std::array<std::vector<float>, 3> radiance_;
  std::vector<float> light_;
  std::vector<float> range_;
  std::vector<float> slope_;
};

}  // namespace drydock::sim
