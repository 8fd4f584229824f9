// A sonar's range against the landmarks near its echo (paper eq. 4-7).
#pragma once

#include <cstddef>
#include <vector>

#include <ceres/cost_function.h>

#include "sensors_models/base/pose.h"

namespace drydock::svin2 {

/// One ping and what is known about it.
struct SonarRangeObservation {
  double range = 0.0;  ///< [m]
  /// The sonar's head in the body's frame at the time of the ping [m].
  Eigen::Vector3d p_IS = Eigen::Vector3d::Zero();
  /// The body at the time of the ping, in the body's frame at the time of the pose that the factor
  /// is tied to: from the IMU, constant in the optimisation. Over 1/30 s at 0.25 m/s the body moves
  /// by 8 mm, of which the velocity's error is a small share.
  Pose T_frame_ping;
  double sigma_range = 0.0;  ///< Standard deviation of the range [m], > 0.
  /// Of what the patch stands off from the face that gave the echo [m]: its roughness, in which
  /// errors of single landmarks show. What they have in common moves with the anchor.
  double sigma_patch = 0.0;
  /// Landmarks of the patch that are no longer estimated [m, in the body's frame at the anchor].
  std::vector<Eigen::Vector3d> held_landmarks;
};

/// Parameters: pose T_WI (7); where landmarks are held, the anchor's pose T_WA (7); then those
/// landmarks of the patch that are estimated [m, in W] (3 each). With the sonar's head at p_S =
/// T_WI T_frame_ping p_IS and m the mean of all N landmarks of the patch, the held ones l_A at T_WA
/// l_A:
///   e = (range - |p_S - m|) / sigma,   1 / sigma^2 = 1 / (sigma_range^2 + sigma_patch^2)
/// Tangents: [dp, da], exp(da) q; dl. With u = (p_S - m) / |p_S - m| and s = sum R_WA l_A of the H
/// that are held:
///   de/dp = -u',      de/da = u' [R T_frame_ping p_IS]x,   de/dl = u' / N,
///   de/dp_A = H u' / N,   de/da_A = -u' [s]x / N           (each over sigma)
///
/// Held landmarks go with an earlier pose of the body, whose error they share. Held in W they would
/// be known absolutely, and ping upon ping take away doubts about position and yaw that nothing can
/// see.
///
/// Differs from the paper where its printed form does not follow from its model: the range is that
/// of the sonar's head, not of the body; the landmarks are parameters, without which the factor
/// could not correct scale; the information is that of the measurement, where eq. 5 prints the
/// covariance of the innovation, which trusts the sonar least when the pose is least known.
///
/// At |p_S - m| < 1 um the direction is unknown and the derivatives are 0.
class SonarRangeFactor final : public ceres::CostFunction {
 public:
  /// `landmarks`: how many of the patch are estimated; it has at least one, held ones included.
  SonarRangeFactor(const SonarRangeObservation& observation, std::size_t landmarks);

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  Eigen::Vector3d PatchMean(double const* const* parameters) const;
  std::size_t FirstLandmark() const { return held_ > 0 ? 2 : 1; }

  double range_;
  Eigen::Vector3d p_IS_;  ///< The head at the ping, in the body's frame at the pose.
  double sigma_;
  std::size_t landmarks_;
  std::size_t held_;                                    ///< H.
  Eigen::Vector3d held_sum_ = Eigen::Vector3d::Zero();  ///< At the anchor.
  double count_;                                        ///< N.
};

}  // namespace drydock::svin2
