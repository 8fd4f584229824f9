// Light of the lamps that a rig carries: on surfaces, with shadows, and in the water.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "sensors_models/base/pose.h"
#include "sim/optics/lamp_config.h"
#include "sim/optics/lamp_rows.h"
#include "sim/optics/lamp_shadows.h"
#include "sim/optics/lamp_veil.h"

namespace drydock::sim {

/// All lamps as one camera has them. For a channel, with rho a surface's reflectance, n its normal,
/// l the unit vector to the lamp at distance d, r the range to the camera, S the share of the lamp
/// that the surface sees (LampShadows), and I as LampConfig has it:
///   J = rho sum I(theta) max(0, n . l) S exp(-c (d + r)) / d^2
/// attenuated along both ways. LampVeil has what the water itself sends back.
class LampLight {
 public:
  /// `T_IC` is the camera's pose on the body. `rays`, if not null, casts the shadows and must
  /// outlive this.
  LampLight(const std::vector<LampConfig>& lamps, const Pose& T_IC, const WaterConfig& water,
            const Pinhole& pinhole, const RayScene* rays);

  /// Prepares a view: `depth` is CV_32FC1 [m], taken at `T_WC`.
  void Look(const cv::Mat& depth, const Pose& T_WC);

  /// One row of the image.
  struct Row {
    int v;
    const cv::Mat& depth;
    const float* range;                               ///< Along each ray [m].
    const std::array<std::vector<float>, 3>& albedo;  ///< Linear.
  };
  /// Adds the light on what row `v` sees to `direct` and that of the water to `veil`. Channel i
  /// goes to planes [i] with weights[i]; the planes may be one and the same.
  void AddRow(const rows::RowView& view, const Row& row, const Eigen::Array3f& weights,
              const std::array<float*, 3>& direct, const std::array<float*, 3>& veil);

  /// Illuminance of a surface at `p_C` [m, in C] that squarely faces each lamp, per channel, as a
  /// share of full sun. Nothing throws shadows.
  Eigen::Array3d IlluminanceAt(const Eigen::Vector3d& p_C) const;

 private:
  std::vector<LampInCamera> lamps_;
  Eigen::Array3d attenuation_;  ///< c [1/m]
  LampVeil veil_;
  std::optional<LampShadows> shadows_;
  std::array<std::vector<float>, 3> normal_;
  std::vector<float> share_, way_;
  std::vector<float> open_;  ///< Ones: nothing is in shadow.
};

}  // namespace drydock::sim
