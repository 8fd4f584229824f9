#include "estimator/svin2/factors/imu_factor.h"

#include <Eigen/Cholesky>
#include <optional>
#include <utility>

#include "estimator/svin2/factors/pose_jacobian.h"
#include "sensors_models/base/check.h"

namespace drydock::svin2 {
namespace {

using Vector15d = Eigen::Matrix<double, 15, 1>;
using ByPose = Eigen::Matrix<double, 15, 6>;
using BySpeedBias = Eigen::Matrix<double, 15, 9>;

// Where each error stands in the residual, and each part in the speed-bias block.
constexpr int kP = 0, kA = 3, kV = 6, kBias = 9;

void StoreSpeedBiasJacobian(const BySpeedBias& by_parameters, double* jacobian) {
  Eigen::Map<Eigen::Matrix<double, 15, 9, Eigen::RowMajor>> block(jacobian);
  block = by_parameters;
}

}  // namespace

/// The errors, not whitened, and what their derivatives are made of.
struct ImuFactor::Errors {
  Vector15d e;
  Eigen::Matrix3d R_iW;
  Eigen::Vector3d move, gain;     ///< e_p + p and e_v + v: what the states say the deltas are.
  Eigen::Matrix3d log_by_left;    ///< d(e_a) / d(rotation on the left of e_a's argument).
  Eigen::Matrix3d log_by_right;   ///< The same on its right.
  ImuBiasJacobian delta_by_bias;  ///< At the biases of i, q on the left.
};

ImuFactor::ImuFactor(ImuPreintegration preintegration, const Eigen::Vector3d& gravity_W)
    : preintegration_(std::move(preintegration)), gravity_W_(gravity_W) {
  Check(preintegration_.length().ns > 0, "an IMU factor needs an interval longer than 0, not {} ns",
        preintegration_.length().ns);
  const Eigen::LLT<ImuCovariance> cholesky(preintegration_.covariance());
  Check(cholesky.info() == Eigen::Success, "the pre-integration's covariance is not positive");
  whitening_.setIdentity();
  cholesky.matrixL().solveInPlace(whitening_);
}

ImuFactor::Errors ImuFactor::ErrorsAt(const Pose& T_i, const SpeedBias& s_i, const Pose& T_j,
                                      const SpeedBias& s_j) const {
  std::optional<ImuPreintegration> anew;
  if (preintegration_.NeedsReintegration(s_i.bias)) anew = preintegration_.IntegratedAt(s_i.bias);
  const ImuPreintegration& deltas = anew ? *anew : preintegration_;
  const ImuDelta delta = deltas.DeltaAt(s_i.bias);
  const double T = deltas.length().Seconds();

  Errors errors;
  errors.R_iW = T_i.R().transpose();
  errors.move = errors.R_iW * (T_j.p() - T_i.p() - s_i.v_W * T - (0.5 * T * T) * gravity_W_);
  errors.gain = errors.R_iW * (s_j.v_W - s_i.v_W - T * gravity_W_);
  const Eigen::Quaterniond turn = T_i.q().conjugate() * T_j.q() * delta.q.conjugate();
  const Eigen::Vector3d e_a = LogSO3(turn);
  errors.e << errors.move - delta.p, e_a, errors.gain - delta.v, s_j.bias.gyro - s_i.bias.gyro,
      s_j.bias.accel - s_i.bias.accel;

  errors.log_by_left = LeftJacobianInverseSO3(e_a);
  errors.log_by_right = errors.log_by_left * turn.toRotationMatrix();
  // DeltaAt() turns q by Exp(J db): its derivative away from db = 0 is Jl(J db) J.
  errors.delta_by_bias = deltas.bias_jacobian();
  const Eigen::Vector3d turned =
      errors.delta_by_bias.block<3, 3>(3, 0) * (s_i.bias.gyro - deltas.bias().gyro);
  errors.delta_by_bias.middleRows<3>(3) =
      LeftJacobianSO3(turned) * errors.delta_by_bias.middleRows<3>(3).eval();
  return errors;
}

bool ImuFactor::Evaluate(double const* const* parameters, double* residuals,
                         double** jacobians) const {
  const Errors errors =
      ErrorsAt(FromParameters(parameters[0]), SpeedBiasFromParameters(parameters[1]),
               FromParameters(parameters[2]), SpeedBiasFromParameters(parameters[3]));
  Eigen::Map<Vector15d>(residuals, 15) = whitening_ * errors.e;
  if (jacobians == nullptr) return true;

  const double T = preintegration_.length().Seconds();
  const Eigen::Matrix3d& R_iW = errors.R_iW;
  if (jacobians[0] != nullptr) {
    // R' x becomes R' x + R' [x]x da, which is [R' x]x R' da.
    ByPose by_pose = ByPose::Zero();
    by_pose.block<3, 3>(kP, 0) = -R_iW;
    by_pose.block<3, 3>(kP, 3) = Skew(errors.move) * R_iW;
    by_pose.block<3, 3>(kA, 3) = -errors.log_by_left * R_iW;
    by_pose.block<3, 3>(kV, 3) = Skew(errors.gain) * R_iW;
    StorePoseJacobian<15>(parameters[0], whitening_ * by_pose, jacobians[0]);
  }
  if (jacobians[1] != nullptr) {
    BySpeedBias by_speed = BySpeedBias::Zero();
    by_speed.block<3, 3>(kP, 0) = -T * R_iW;
    by_speed.block<3, 3>(kV, 0) = -R_iW;
    by_speed.block<9, 6>(0, 3) = -errors.delta_by_bias;
    by_speed.block<3, 6>(kA, 3) = -errors.log_by_right * errors.delta_by_bias.middleRows<3>(3);
    by_speed.block<6, 6>(kBias, 3).diagonal().setConstant(-1.0);
    StoreSpeedBiasJacobian(whitening_ * by_speed, jacobians[1]);
  }
  if (jacobians[2] != nullptr) {
    ByPose by_pose = ByPose::Zero();
    by_pose.block<3, 3>(kP, 0) = R_iW;
    by_pose.block<3, 3>(kA, 3) = errors.log_by_left * R_iW;
    StorePoseJacobian<15>(parameters[2], whitening_ * by_pose, jacobians[2]);
  }
  if (jacobians[3] != nullptr) {
    BySpeedBias by_speed = BySpeedBias::Zero();
    by_speed.block<3, 3>(kV, 0) = R_iW;
    by_speed.block<6, 6>(kBias, 3).setIdentity();
    StoreSpeedBiasJacobian(whitening_ * by_speed, jacobians[3]);
  }
  return true;
}

}  // namespace drydock::svin2
