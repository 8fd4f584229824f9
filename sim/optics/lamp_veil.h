// The cone of light that a lamp makes of the water before the camera.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "sim/optics/lamp_in_camera.h"
#include "sim/optics/water_config.h"
#include "sim/render/pinhole.h"

namespace drydock::sim {

/// Share of scattered light per solid angle [1/sr] that is turned by an angle with this cosine, by
/// Henyey and Greenstein (Astrophysical Journal 93, 1941) with g = 0.924, which scatters 1.7 % of
/// it backwards, as measured in natural waters.
double PhaseFunction(double cosine);

/// Light of lamps that water scatters once towards the camera:
///   L(r) = pi int_0^r b p(psi) E(t) exp(-c t) dt,  E(t) = I(theta) exp(-c d) / d^2,
/// with d the distance from the lamp to the place t along the pixel's ray, psi the angle by which
/// the light is turned there, and pi by the choice of radiance 1. Nothing throws shadows in it. The
/// lamps are fixed to the camera: it is worked out once, on a raster of pixels and of ranges.
class LampVeil {
 public:
  LampVeil(const WaterConfig& water, const Pinhole& pinhole,
           const std::vector<LampInCamera>& lamps);

  /// Adds what is seen up to each pixel's range [m] of row `v`: weights.x red + weights.y green +
  /// weights.z blue.
  void AddRow(int v, const float* range, const Eigen::Array3f& weights, float* veil);

  /// The same at one place of the image, by the integral itself, per channel.
  Eigen::Array3d Integrate(double u, double v, double range) const;

 private:
  static constexpr int kRaster = 32;  ///< [px]
  static constexpr int kPieces = 10;  ///< Of each ray.

  Eigen::Array3d SourceAt(const Eigen::Vector3d& ray_C, double range) const;
  Eigen::Array3d IntegrateAlong(const Eigen::Vector3d& ray_C, double begin, double end) const;

  Pinhole pinhole_;
  std::vector<LampInCamera> lamps_;
  Eigen::Array3d attenuation_;  ///< c [1/m]
  Eigen::Array3d scattering_;   ///< b [1/m]
  std::array<float, kPieces + 1> ends_ = {};
  /// Light of each piece: CV_32FC3, one for each ray, a row and a column more than there are cells.
  std::array<cv::Mat, kPieces> pieces_;
  std::vector<float> coarse_, fine_;
};

}  // namespace drydock::sim
