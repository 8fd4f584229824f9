#include "estimator/svin2/factors/sonar_range_factor.h"

#include <cmath>

#include "estimator/svin2/factors/pose_jacobian.h"
#include "sensors_models/base/check.h"

namespace drydock::svin2 {

SonarRangeFactor::SonarRangeFactor(const SonarRangeObservation& observation, std::size_t landmarks)
    : range_(observation.range),
      p_IS_(observation.T_frame_ping * observation.p_IS),
      sigma_(std::hypot(observation.sigma_range, observation.sigma_patch)),
      landmarks_(landmarks),
      held_(observation.held_landmarks.size()),
      count_(static_cast<double>(landmarks + held_)) {
  Check(observation.sigma_range > 0.0, "a range's standard deviation must be above 0, not {}",
        observation.sigma_range);
  Check(count_ > 0.0, "a sonar patch needs a landmark");
  for (const Eigen::Vector3d& held : observation.held_landmarks) held_sum_ += held;
  set_num_residuals(1);
  std::vector<int>& sizes = *mutable_parameter_block_sizes();
  sizes.assign(FirstLandmark(), 7);
  sizes.insert(sizes.end(), landmarks, 3);
}

Eigen::Vector3d SonarRangeFactor::PatchMean(double const* const* parameters) const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  if (held_ > 0) {
    const Pose T_WA = FromParameters(parameters[1]);
    sum = T_WA.q() * held_sum_ + static_cast<double>(held_) * T_WA.p();
  }
  for (std::size_t k = FirstLandmark(); k < FirstLandmark() + landmarks_; ++k)
    sum += Eigen::Map<const Eigen::Vector3d>(parameters[k]);
  return sum / count_;
}

bool SonarRangeFactor::Evaluate(double const* const* parameters, double* residuals,
                                double** jacobians) const {
  constexpr double kNearest = 1e-6;
  const Pose T_WI = FromParameters(parameters[0]);
  const Eigen::Vector3d lever_W = T_WI.q() * p_IS_;
  const Eigen::Vector3d from_patch = T_WI.p() + lever_W - PatchMean(parameters);
  const double distance = from_patch.norm();
  residuals[0] = (range_ - distance) / sigma_;
  if (jacobians == nullptr) return true;

  Eigen::RowVector3d u = Eigen::RowVector3d::Zero();
  if (distance >= kNearest) u = from_patch.transpose() / (distance * sigma_);
  if (jacobians[0] != nullptr) {
    Eigen::Matrix<double, 1, 6> by_pose;
    by_pose << -u, u * Skew(lever_W);
    StorePoseJacobian<1>(parameters[0], by_pose, jacobians[0]);
  }
  if (held_ > 0 && jacobians[1] != nullptr) {
    Eigen::Matrix<double, 1, 6> by_anchor;
    by_anchor << static_cast<double>(held_) * u,
        -u * Skew(FromParameters(parameters[1]).q() * held_sum_);
    StorePoseJacobian<1>(parameters[1], by_anchor / count_, jacobians[1]);
  }
  for (std::size_t k = FirstLandmark(); k < FirstLandmark() + landmarks_; ++k) {
    if (jacobians[k] == nullptr) continue;
    Eigen::Map<Eigen::RowVector3d> block(jacobians[k]);
    block = u / count_;
  }
  return true;
}

}  // namespace drydock::svin2
