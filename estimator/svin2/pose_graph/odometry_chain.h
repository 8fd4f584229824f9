// How far odometry can have drifted between any two keyframes.
#pragma once

#include <vector>

#include "estimator/svin2/pose_graph/pose_graph_types.h"

namespace drydock::svin2 {

/// A small motion of frame P as [rho; phi], x -> x + rho + phi x x: the tangent in which errors of
/// different places can be added up.
///
/// The covariance of such a motion, for a pose at (R, p) whose own [dp; da], left perturbation in
/// the frame with orientation `R_PA`, has `covariance`.
Matrix6d ToFrame(const Eigen::Matrix3d& R_PA, const Eigen::Vector3d& p_P,
                 const Matrix6d& covariance);
/// Back: the covariance of [dp; da] in P of a pose at `p_P`.
Matrix6d AtPoint(const Eigen::Vector3d& p_P, const Matrix6d& covariance_P);
/// From frame P into Q = T_QP P.
Matrix6d Transported(const Pose& T_QP, const Matrix6d& covariance_P);

/// Keyframes strung on the sequence edges between neighbours, with the errors added up from the
/// start, so that any stretch is a difference. A node without an edge from the node before it
/// starts a piece, with a frame P of its own.
class OdometryChain {
 public:
  /// A new node, for now a piece by itself.
  void AddNode();
  /// Ties the newest node to the one before it, unless it is.
  void Link(const Pose& T_before_now, const Matrix6d& covariance);

  std::size_t size() const { return nodes_.size(); }
  /// Count up from 0.
  std::size_t PieceOf(std::size_t node) const { return nodes_[node].piece; }
  const Pose& T_PI(std::size_t node) const { return nodes_[node].T_PI; }
  /// Of the motion in P by which the later of two nodes of one piece is off as the other sees it.
  Matrix6d DriftBetween(std::size_t a, std::size_t b) const;

 private:
  struct Node {
    std::size_t piece = 0;
    Pose T_PI;
    Matrix6d covariance = Matrix6d::Zero();  // From the piece's first node on.
  };

  std::vector<Node> nodes_;
};

}  // namespace drydock::svin2
