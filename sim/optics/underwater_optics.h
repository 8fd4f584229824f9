// Light under water: from what surfaces reflect to what reaches the camera.
#pragma once

#include <array>

#include <opencv2/core/mat.hpp>

#include "sensors_models/base/pose.h"
#include "sim/optics/water_config.h"
#include "sim/render/renderer.h"

namespace drydock::sim {

/// Lights a raw image per pixel, in linear light, by daylight that fades with depth, and sends it
/// through the water.
///
/// For each channel, with r the range along the ray, E(z) = exp(-Kd * depth(z)) the daylight and
/// rho the surface's reflectance:
///   J = rho * E(surface) * (sun_share * max(0, n . sun) + (1 - sun_share) * sky(n))   lit surface
///   I = J exp(-c r) + B (1 - exp(-beta_B r))                                           seen
///   through water
/// Single scattering of daylight along the ray gives beta_B = c + Kd * s with s the ray's downward
/// slope (it gets darker downwards) and B = veil * (b/c) * E(camera) * c / beta_B. Radiance 1 is
/// what a white card sends out that lies flat at the camera's depth: exposure is relative to the
/// light that is there.
class UnderwaterOptics {
 public:
  UnderwaterOptics(const WaterConfig& water, const Pinhole& pinhole);

  /// Red, green, blue radiance, CV_32FC3.
  void Apply(const RawImage& raw, const Pose& T_WC, cv::Mat& radiance);

 private:
  void ComputeNormals(const cv::Mat& depth, const Eigen::Matrix3d& R_WC);

  Pinhole pinhole_;
  double surface_z_;
  double sun_share_;
  Eigen::Vector3f sun_W_;                     ///< Unit vector towards the sun.
  std::array<float, 3> beam_attenuation_;     ///< c
  std::array<float, 3> diffuse_attenuation_;  ///< Kd
  std::array<float, 3> veil_;                 ///< veil * b/c
  std::array<float, 256> linear_;             ///< sRGB code to linear light.
  cv::Mat normals_;                           ///< CV_32FC3, in W; reused from frame to frame.
};

}  // namespace drydock::sim
