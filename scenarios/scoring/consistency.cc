#include "scenarios/scoring/consistency.h"

#include <Eigen/Cholesky>
#include <cmath>

#include "scenarios/scoring/alignment.h"

namespace drydock::score {
namespace {

/// e^T P^-1 e per degree of freedom; nothing where P is no covariance.
std::optional<double> NeesPerDof(const Eigen::Vector3d& error, const Eigen::Matrix3d& covariance) {
  const Eigen::LLT<Eigen::Matrix3d> factor(covariance);
  if (factor.info() != Eigen::Success) return std::nullopt;
  const double nees = factor.matrixL().solve(error).squaredNorm() / 3.0;
  return std::isfinite(nees) ? std::optional(nees) : std::nullopt;
}

}  // namespace

std::optional<Anees> ComputeAnees(const Trajectory& truth, const std::vector<Belief>& beliefs) {
  Anees sum;
  std::optional<int> map_id;
  Pose alignment;
  for (const Belief& belief : beliefs) {
    const auto true_pose = Interpolate(truth, belief.t);
    if (!true_pose) continue;
    if (map_id != belief.map_id) {
      map_id = belief.map_id;
      alignment = AlignPositionAndYaw({belief.t, *true_pose, belief.T_WI}).rigid;
      continue;
    }
    const Vector6d error = (alignment * belief.T_WI).BoxMinus(*true_pose);
    // Turned back into the estimator's world, where the covariance is at home.
    const Eigen::Quaterniond back = alignment.q().conjugate();
    const auto position =
        NeesPerDof(back * error.head<3>(), belief.covariance.topLeftCorner<3, 3>());
    const auto orientation =
        NeesPerDof(back * error.tail<3>(), belief.covariance.bottomRightCorner<3, 3>());
    if (!position || !orientation) continue;
    sum.position += *position;
    sum.orientation += *orientation;
    ++sum.count;
  }
  if (sum.count == 0) return std::nullopt;
  const auto count = static_cast<double>(sum.count);
  return Anees{sum.position / count, sum.orientation / count, sum.count};
}

}  // namespace drydock::score
