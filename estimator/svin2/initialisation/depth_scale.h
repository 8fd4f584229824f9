// What the pressure sensor says about the scale of vision (paper eq. 10, 11).
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "sensors_models/base/pose.h"
#include "sensors_models/base/time.h"
#include "sensors_models/measurement/rig.h"

namespace drydock::svin2 {

struct TimedDepth {
  Time t;
  double depth = 0.0;  ///< [m, positive downwards], of the pressure port.
};

/// A factor with its standard deviation.
struct ScaleEstimate {
  double value = 1.0;
  double sigma = 0.0;
};

/// The product of two independent beliefs about the same factor.
ScaleEstimate Combine(const ScaleEstimate& a, const ScaleEstimate& b);

struct DepthScaleConfig {
  double min_excursion_m = 0.15;  ///< Of the camera's height, between readings; with less: nothing.
  /// Standard deviation of a reading against the camera's height, beside the sensor's own [m]:
  /// vision's noise, and the interpolation between its frames.
  double height_sigma_m = 0.002;
};

/// What vision says of the heights that the readings are held against.
struct VisualHeights {
  std::vector<Time> t;                              ///< Rising.
  std::vector<Pose> T_VI;                           ///< By the rig's own scale.
  Eigen::Vector3d up_V = Eigen::Vector3d::UnitZ();  ///< Of length 1.
  double tilt_sigma_rad = 0.0;                      ///< Of up_V, about each horizontal axis.
};

/// The factor s that vision must be multiplied by for its heights to go along with the readings,
/// by least squares over s and the readings' unknown offset:
///   -d = offset + up (s c(t) + R(t) (p_ID - p_IC))
/// with c the camera's position. The paper's quotient of one height by the other divides by nearly
/// 0 at the start, and takes the surface for known. A reading counts for when it was true: its time
/// less the sensor's lag. Readings outside of vision's frames do not count; between frames c goes
/// by Catmull and Rom's cubic. `sigma` covers the readings' noise and the tilt. Nothing with less
/// than two readings or too small an excursion.
std::optional<ScaleEstimate> ScaleFromDepth(std::span<const TimedDepth> readings,
                                            const VisualHeights& vision,
                                            const Eigen::Vector3d& p_IC, const DepthSheet& sheet,
                                            const DepthScaleConfig& config);

}  // namespace drydock::svin2
