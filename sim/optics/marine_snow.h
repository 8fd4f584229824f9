// Marine snow: flakes that drift past the camera.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include <opencv2/core/mat.hpp>

#include "sensors_models/base/pose.h"
#include "sensors_models/base/time.h"
#include "sim/optics/light_at.h"
#include "sim/optics/marine_snow_config.h"
#include "sim/optics/silt.h"
#include "sim/optics/snow_field.h"
#include "sim/optics/soft_spot.h"
#include "sim/optics/underwater_optics.h"
#include "sim/optics/water_config.h"
#include "sim/render/pinhole.h"

namespace drydock::sim {

/// Draws the flakes of a SnowField over the finished radiance of the water, as one camera sees
/// them, the farthest first.
///
/// A flake at range r, depth z along the axis covers an ellipse of f size / z px, with edges as
/// wide as pixel and lens make them (2.5 px) and as the circle of confusion,
///   f aperture |1 / r - 1 / focus| px  (thin lens, far beyond its focal length).
/// Where it covers the share a of a pixel,
///   I' = I + a exp(-c r) (albedo E - I):
/// its own light fades on the way, and the veil in front of it stays. That veil is taken as the
/// share 1 - exp(-c r) of I, which it is in open water, whatever lights it.
class MarineSnow {
 public:
  MarineSnow(const MarineSnowConfig& snow, const WaterConfig& water, const Pinhole& pinhole,
             std::uint64_t seed);

  /// Adds the flakes to `radiance`, CV_32FC1 or CV_32FC3 by `channels`, as seen from `T_WC` at `t`
  /// with `depth` along the axis [CV_32FC1, m; infinite where nothing is]. `silt`, if not null, has
  /// been added before: flakes are seen through what of it is in front of them.
  void AddTo(const cv::Mat& depth, const Pose& T_WC, Time t, ImageChannels channels,
             const LightAt& light, cv::Mat& radiance, const Silt* silt = nullptr) const;

  const SnowField& field() const { return field_; }

  static constexpr double kNearest = 0.05;  ///< The camera's port keeps flakes this far [m].

 private:
  SoftSpot SpotOf(const SnowFlake& flake, const Eigen::Vector3d& p_C, const Pose& T_CW) const;
  SpotLight LightOf(const SnowFlake& flake, double range, ImageChannels channels,
                    const LightAt& light) const;

  MarineSnowConfig snow_;
  Pinhole pinhole_;
  Eigen::Array3f beam_attenuation_;  ///< c of the water [1/m].
  SnowField field_;
};

}  // namespace drydock::sim
