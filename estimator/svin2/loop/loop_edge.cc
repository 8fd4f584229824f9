#include "estimator/svin2/loop/loop_edge.h"

namespace drydock::svin2 {
namespace {

using Matrix6d = Eigen::Matrix<double, 6, 6>;

Matrix6d Carried(const Matrix6d& by_tangent, const Matrix6d& covariance) {
  return by_tangent * covariance * by_tangent.transpose();
}

}  // namespace

Pose Drift(const Pose& T_graph_then, const Pose& T_then_now, const Pose& T_W_now) {
  return T_graph_then * T_then_now * T_W_now.Inverse();
}

// The inverse is (-q^-1 p, q^-1). With (p + dp, exp(da) q) its position changes by q^-1 (-dp + da x
// p), its rotation by exp(-q^-1 da) on the left.
Matrix6d CovarianceOfInverse(const Pose& T_then_now, const Matrix6d& covariance) {
  const Eigen::Matrix3d R = T_then_now.R().transpose();
  Matrix6d by_tangent = Matrix6d::Zero();
  by_tangent.topLeftCorner<3, 3>() = -R;
  by_tangent.topRightCorner<3, 3>() = -R * Skew(T_then_now.p());
  by_tangent.bottomRightCorner<3, 3>() = -R;
  return Carried(by_tangent, covariance);
}

// T_then_before = T_then_now T_now_before: what turns `now` swings `before` about it, and what
// moves or turns `before` in now's frame is turned into then's.
LoopEdge AtKeyframeBefore(const LoopEdge& loop, const OdometryLink& link) {
  const Pose T_now_before = link.T_before_now.Inverse();
  Matrix6d by_loop = Matrix6d::Identity(), by_link = Matrix6d::Zero();
  by_loop.topRightCorner<3, 3>() = -Skew(loop.T_then_now.q() * T_now_before.p());
  by_link.topLeftCorner<3, 3>() = by_link.bottomRightCorner<3, 3>() = loop.T_then_now.R();
  return {loop.T_then_now * T_now_before,
          Carried(by_loop, loop.covariance) +
              Carried(by_link, CovarianceOfInverse(link.T_before_now, link.covariance))};
}

}  // namespace drydock::svin2
