#include "estimator/svin2/pose_graph/odometry_chain.h"

#include <algorithm>

#include "sensors_models/base/check.h"

namespace drydock::svin2 {

Matrix6d ToFrame(const Eigen::Matrix3d& R_PA, const Eigen::Vector3d& p_P,
                 const Matrix6d& covariance) {
  // A turn about the pose itself is one about P's origin and a shift that undoes its lever arm.
  Matrix6d by_pose = Matrix6d::Zero();
  by_pose.topLeftCorner<3, 3>() = R_PA;
  by_pose.bottomRightCorner<3, 3>() = R_PA;
  by_pose.topRightCorner<3, 3>() = Skew(p_P) * R_PA;
  return by_pose * covariance * by_pose.transpose();
}

Matrix6d AtPoint(const Eigen::Vector3d& p_P, const Matrix6d& covariance_P) {
  return ToFrame(Eigen::Matrix3d::Identity(), -p_P, covariance_P);
}

Matrix6d Transported(const Pose& T_QP, const Matrix6d& covariance_P) {
  return ToFrame(T_QP.R(), T_QP.p(), covariance_P);
}

void OdometryChain::AddNode() {
  Node node;
  if (!nodes_.empty()) node.piece = nodes_.back().piece + 1;
  nodes_.push_back(node);
}

void OdometryChain::Link(const Pose& T_before_now, const Matrix6d& covariance) {
  Check(nodes_.size() > 1, "a chain of {} nodes has nothing to tie", nodes_.size());
  const Node& before = nodes_[nodes_.size() - 2];
  Node& now = nodes_.back();
  if (now.piece == before.piece) return;
  now.piece = before.piece;
  now.T_PI = before.T_PI * T_before_now;
  now.covariance = before.covariance + ToFrame(before.T_PI.R(), now.T_PI.p(), covariance);
}

Matrix6d OdometryChain::DriftBetween(std::size_t a, std::size_t b) const {
  const auto [first, last] = std::minmax(a, b);
  return nodes_[last].covariance - nodes_[first].covariance;
}

}  // namespace drydock::svin2
