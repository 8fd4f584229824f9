// Clouds of stirred-up silt, as a scenario describes them.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "sensors_models/base/yaml_reader.h"

namespace drydock::sim {

/// One cloud: silt that is densest in the middle and thins out as a Gaussian, on average; it is
/// made of smaller such blobs, which give it a shape.
struct SiltCloud {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  ///< Of the middle at from_s, in W.
  double radius_m = 1.0;                                 ///< One standard deviation, at from_s.
  double attenuation_1_m = 4.0;  ///< What the middle adds to the beam attenuation, on average.
  int puffs = 8;                 ///< How many blobs it is made of; 1 is just the Gaussian.
  /// It comes up within rise_s from from_s on and settles within settle_s from to_s on.
  double from_s = 0.0;
  double to_s = 1e6;
  double rise_s = 3.0;
  double settle_s = 30.0;
  Eigen::Vector3d current_m_s = Eigen::Vector3d::Zero();  ///< It drifts with this, in W,
  double growth_m_s = 0.0;  ///< and its radius grows by this; it thins out as much.
  /// Radiance of a dense cloud against that of a white ball in the same light: red, green, blue.
  Eigen::Vector3d albedo = {0.24, 0.21, 0.15};
};

/// Reads one mapping of the list `silt` of a scenario's water.
SiltCloud ReadSiltCloud(YamlReader& yaml);

/// A Gaussian of silt at one time.
struct SiltBlob {
  Eigen::Vector3d centre_W = Eigen::Vector3d::Zero();  ///< [m]
  double sigma = 1.0;                                  ///< [m]
  double attenuation = 0.0;                            ///< In the middle [1/m].
};

/// The whole cloud as one blob; nothing where there is no silt yet or no more at `t_s`.
std::optional<SiltBlob> BlobAt(const SiltCloud& cloud, double t_s);

/// What lies on the straight way between two places [m], in nepers: the integral of the
/// attenuation, in closed form.
double OpticalDepth(const SiltBlob& blob, const Eigen::Vector3d& from_W,
                    const Eigen::Vector3d& to_W);

}  // namespace drydock::sim
