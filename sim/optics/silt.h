// Clouds of silt between the camera and what it sees.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "sensors_models/base/pose.h"
#include "sensors_models/base/time.h"
#include "sim/optics/light_at.h"
#include "sim/optics/silt_config.h"
#include "sim/optics/silt_painter.h"
#include "sim/optics/underwater_optics.h"
#include "sim/optics/water_config.h"
#include "sim/render/pinhole.h"

namespace drydock::sim {

/// Lays silt over the finished radiance of the water and what is in it, cloud by cloud, the
/// farthest first. With tau the optical depth of a cloud up to the pixel's range,
///   I' = I + (1 - exp(-tau)) exp(-c r) (albedo E - I).
/// E is the light at the near side of the cloud: at the range r from in front of which half of
/// the cloud's own light comes; for a thin cloud that is its middle, for a dense one where tau
/// is ln 2. exp(-c r) is what the clear water before that leaves; the veil of that water, which the
/// cloud does not hide, is taken as the share 1 - exp(-c r) of I, which it is in open water.
/// A reflectance stands for all the scattering within a cloud.
///
/// A cloud of several puffs has them at random places, normally distributed, with the cloud's
/// middle and so wide that together they have its sigma. Each has 0.4 of that sigma and its part of
/// the silt.
class Silt {
 public:
  /// The seed shapes the clouds.
  Silt(const std::vector<SiltCloud>& clouds, const WaterConfig& water, const Pinhole& pinhole,
       std::uint64_t seed);

  /// Adds the clouds to `radiance`, CV_32FC1 or CV_32FC3 by `channels`, as seen from `T_WC` at `t`
  /// with `depth` along the axis [CV_32FC1, m; infinite where nothing is]. Changes nothing where
  /// there is no silt (SiltPainter::kLeast).
  void AddTo(const cv::Mat& depth, const Pose& T_WC, Time t, ImageChannels channels,
             const LightAt& light, cv::Mat& radiance) const;

  /// The optical depth of all clouds between two places [m, in W].
  double DepthBetween(const Eigen::Vector3d& from_W, const Eigen::Vector3d& to_W, Time t) const;

  /// The share of the daylight that the silt above leaves at `p_W`, of clouds as single blobs. Most
  /// of what a beam loses to silt goes on downwards: diffuse light fades 0.15 times as fast
  /// (diffusion theory with a scattering albedo of 0.95 and a mean cosine of 0.9).
  double DaylightLeft(const Eigen::Vector3d& p_W, Time t) const;

 private:
  struct Cloud {
    SiltCloud config;
    std::vector<Eigen::Vector3d> places;  ///< Of its puffs, for sigma 1; none if it is one blob.
  };

  static std::vector<SiltBlob> PuffsOf(const Cloud& cloud, const SiltBlob& whole);

  std::vector<Cloud> clouds_;
  Pinhole pinhole_;
  double surface_z_;  ///< [m, in W]
  SiltPainter painter_;
};

}  // namespace drydock::sim
