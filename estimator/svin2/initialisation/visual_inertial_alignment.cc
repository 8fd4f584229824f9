#include "estimator/svin2/initialisation/visual_inertial_alignment.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "estimator/inertial/imu_integration.h"

namespace drydock::svin2 {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Vector9d = Eigen::Matrix<double, 9, 1>;

struct State {
  std::vector<Pose> T_VI;  // By vision's scale.
  std::vector<Vector3d> v_V;
  Vector3d gravity_V = Vector3d::Zero();
  double scale = 1.0;
  ImuBias bias;
};

// Directions in which gravity may move: all three, or the two across it.
MatrixXd FreeDirections(const Vector3d& gravity, bool on_sphere) {
  if (!on_sphere) return Matrix3d::Identity();
  const Vector3d along = gravity.normalized();
  const Vector3d other = std::abs(along.z()) < 0.7 ? Vector3d::UnitZ() : Vector3d::UnitX();
  MatrixXd across(3, 2);
  const Vector3d first = along.cross(other).normalized();
  across << first, along.cross(first);
  return across;
}

class Aligner {
 public:
  Aligner(const VisualMotion& motion, std::span<const ImuPreintegration> imu, const Vector3d& p_IC,
          const AlignmentPriors& priors)
      : motion_(motion), imu_(imu), p_IC_(p_IC), priors_(priors) {
    for (const ImuPreintegration& delta : imu_) {
      whitening_.push_back(delta.covariance().topLeftCorner<9, 9>().llt().matrixL().solve(
          Eigen::Matrix<double, 9, 9>::Identity()));
    }
  }

  std::optional<Alignment> Run() {
    state_ = Guess();
    for (int round = 0; round < 2; ++round) {
      if (!Improve(false)) return std::nullopt;
    }
    Alignment result;
    result.free_gravity = state_.gravity_V.norm();
    state_.gravity_V *= kGravity.norm() / result.free_gravity;
    for (int round = 0; round < 3; ++round) {
      if (!Improve(true)) return std::nullopt;
    }
    Linearise(true);
    Summarise(result);
    return result;
  }

 private:
  int Frames() const { return static_cast<int>(motion_.T_VI.size()); }
  // Columns; the first pose has none.
  int PoseAt(int k) const { return 6 * (k - 1); }
  int SpeedAt(int k) const { return 6 * (Frames() - 1) + 3 * k; }
  int BiasAt() const { return SpeedAt(Frames()); }
  int ScaleAt() const { return BiasAt() + 6; }
  int GravityAt() const { return ScaleAt() + 1; }

  Vector3d LeverArm(int k) const { return state_.T_VI[k].q() * p_IC_; }
  // The body, by the present scale.
  Vector3d PositionOf(int k) const {
    return state_.scale * (state_.T_VI[k].p() + LeverArm(k)) - LeverArm(k);
  }

  State Guess() const {
    State state;
    state.T_VI = motion_.T_VI;
    state.scale = priors_.scale.value;
    state.bias = imu_[0].bias();
    Vector3d gravity = Vector3d::Zero();
    for (int k = 0; k < Frames(); ++k) {
      const int i = std::max(k - 1, 0), j = std::min(k + 1, Frames() - 1);
      const double T = (motion_.t[j] - motion_.t[i]).Seconds();
      state.v_V.push_back((motion_.T_VI[j].p() - motion_.T_VI[i].p()) / T);
    }
    for (std::size_t k = 0; k < imu_.size(); ++k) {
      const double T = imu_[k].length().Seconds();
      gravity += (state.v_V[k + 1] - state.v_V[k] - motion_.T_VI[k].q() * imu_[k].delta().v) / T;
    }
    state.gravity_V = gravity / static_cast<double>(imu_.size());
    return state;
  }

  // One step of Gauss-Newton.
  bool Improve(bool on_sphere) {
    Linearise(on_sphere);
    const Eigen::LDLT<MatrixXd> solver(normal_);
    if (solver.info() != Eigen::Success || !(solver.vectorD().minCoeff() > 0.0)) return false;
    const VectorXd step = solver.solve(right_);
    if (!step.allFinite()) return false;
    for (int k = 0; k < Frames(); ++k) {
      if (k > 0) state_.T_VI[k] = state_.T_VI[k].BoxPlus(step.segment<6>(PoseAt(k)));
      state_.v_V[k] += step.segment<3>(SpeedAt(k));
    }
    state_.bias.gyro += step.segment<3>(BiasAt());
    state_.bias.accel += step.segment<3>(BiasAt() + 3);
    state_.scale += step[ScaleAt()];
    state_.gravity_V += directions_ * step.tail(directions_.cols());
    if (on_sphere) state_.gravity_V *= kGravity.norm() / state_.gravity_V.norm();
    return state_.scale > 0.0 && state_.gravity_V.norm() > 0.0;
  }

  // Normal equations for what is left to improve, and what is left to explain.
  void Linearise(bool on_sphere) {
    directions_ = FreeDirections(state_.gravity_V, on_sphere);
    const int size = GravityAt() + static_cast<int>(directions_.cols());
    normal_ = MatrixXd::Zero(size, size);
    right_ = VectorXd::Zero(size);
    chi2_ = 0.0;
    AddPriors();
    AddVision();
    for (int k = 0; k + 1 < Frames(); ++k) AddInterval(k);
  }

  void AddPriors() {
    const auto add = [this](int at, double error, double sigma) {
      const double information = 1.0 / (sigma * sigma);
      normal_(at, at) += information;
      right_[at] += information * error;
      chi2_ += information * error * error;
    };
    add(ScaleAt(), priors_.scale.value - state_.scale, priors_.scale.sigma);
    for (int axis = 0; axis < 3; ++axis) {
      add(BiasAt() + axis, -state_.bias.gyro[axis], priors_.gyro_bias_sigma);
      add(BiasAt() + 3 + axis, -state_.bias.accel[axis], priors_.accel_bias_sigma);
    }
  }

  void AddVision() {
    const int size = 6 * (Frames() - 1);
    VectorXd error(size);
    for (int k = 1; k < Frames(); ++k) {
      error.segment<6>(PoseAt(k)) = motion_.T_VI[k].BoxMinus(state_.T_VI[k]);
    }
    const VectorXd weighted = motion_.information * error;
    normal_.topLeftCorner(size, size) += motion_.information;
    right_.head(size) += weighted;
    chi2_ += error.dot(weighted);
  }

  // Errors are pre-integrated less predicted; signs of the derivatives are of the prediction.
  void AddInterval(int i) {
    const int j = i + 1;
    const ImuPreintegration& imu = imu_[i];
    const double T = imu.length().Seconds();
    const ImuDelta delta = imu.DeltaAt(state_.bias);
    const Matrix3d R_iV = state_.T_VI[i].R().transpose();
    const Vector3d& g = state_.gravity_V;
    const Vector3d way = PositionOf(j) - PositionOf(i) - state_.v_V[i] * T - 0.5 * T * T * g;
    const Vector3d change = state_.v_V[j] - state_.v_V[i] - T * g;
    const Vector3d turn =
        LogSO3(state_.T_VI[i].q().conjugate() * state_.T_VI[j].q() * delta.q.conjugate());
    Vector9d error;
    error << delta.p - R_iV * way, -turn, delta.v - R_iV * change;

    // Of the columns below, those that this interval touches: two poses, two velocities, the rest.
    constexpr int kPoseI = 0, kPoseJ = 6, kSpeedI = 12, kSpeedJ = 15, kBias = 18, kScale = 24;
    constexpr int kGravityAt = 25;
    const int free = static_cast<int>(directions_.cols());
    MatrixXd jacobian = MatrixXd::Zero(9, kGravityAt + free);
    const Matrix3d turned = LeftJacobianInverseSO3(turn) * R_iV;
    const Matrix3d arm_i = (1.0 - state_.scale) * R_iV * Skew(LeverArm(i));
    const Matrix3d arm_j = (1.0 - state_.scale) * R_iV * Skew(LeverArm(j));
    jacobian.block<3, 3>(0, kPoseI) = -state_.scale * R_iV;
    jacobian.block<3, 3>(0, kPoseI + 3) = R_iV * Skew(way) - arm_i;
    jacobian.block<3, 3>(3, kPoseI + 3) = -turned;
    jacobian.block<3, 3>(6, kPoseI + 3) = R_iV * Skew(change);
    jacobian.block<3, 3>(0, kPoseJ) = state_.scale * R_iV;
    jacobian.block<3, 3>(0, kPoseJ + 3) = arm_j;
    jacobian.block<3, 3>(3, kPoseJ + 3) = turned;
    jacobian.block<3, 3>(0, kSpeedI) = -T * R_iV;
    jacobian.block<3, 3>(6, kSpeedI) = -R_iV;
    jacobian.block<3, 3>(6, kSpeedJ) = R_iV;
    jacobian.block<9, 6>(0, kBias) = -imu.bias_jacobian();
    jacobian.block<3, 3>(3, kBias) =
        -LeftJacobianInverseSO3(-turn) * imu.bias_jacobian().block<3, 3>(3, 0);
    jacobian.block<3, 1>(0, kScale) =
        R_iV * (state_.T_VI[j].p() + LeverArm(j) - state_.T_VI[i].p() - LeverArm(i));
    jacobian.block(0, kGravityAt, 3, free) = -0.5 * T * T * R_iV * directions_;
    jacobian.block(6, kGravityAt, 3, free) = -T * R_iV * directions_;
    // The first pose has no columns.
    const int first = i > 0 ? kPoseI : kPoseJ;
    AddEquations(i, jacobian, error,
                 {Columns{first, PoseAt(i > 0 ? i : j), kSpeedI - first},
                  Columns{kSpeedI, SpeedAt(i), kBias - kSpeedI},
                  Columns{kBias, BiasAt(), kGravityAt + free - kBias}});
  }

  // Which columns of an interval are which of all.
  struct Columns {
    int here, there, count;
  };
  void AddEquations(int interval, const MatrixXd& jacobian, const Vector9d& error,
                    const std::array<Columns, 3>& columns) {
    const MatrixXd white = whitening_[interval] * jacobian;
    const Vector9d white_error = whitening_[interval] * error;
    const MatrixXd squares = white.transpose() * white;
    const VectorXd products = white.transpose() * white_error;
    for (const Columns& row : columns) {
      right_.segment(row.there, row.count) += products.segment(row.here, row.count);
      for (const Columns& column : columns) {
        normal_.block(row.there, column.there, row.count, column.count) +=
            squares.block(row.here, column.here, row.count, column.count);
      }
    }
    chi2_ += white_error.squaredNorm();
  }

  void Summarise(Alignment& result) const {
    for (int k = 0; k < Frames(); ++k) {
      result.T_VI.emplace_back(state_.T_VI[k].q(), PositionOf(k));
    }
    result.v_V = state_.v_V;
    result.gravity_V = state_.gravity_V;
    result.bias = state_.bias;
    const MatrixXd covariance =
        normal_.ldlt().solve(MatrixXd::Identity(normal_.rows(), normal_.cols()));
    const auto sigma = [&covariance](int at) { return std::sqrt(covariance(at, at)); };
    result.scale = {state_.scale, sigma(ScaleAt())};
    result.tilt_sigma_rad = std::max(sigma(GravityAt()), sigma(GravityAt() + 1)) / kGravity.norm();
    const int speed = SpeedAt(Frames() - 1);
    result.speed_sigma = std::max({sigma(speed), sigma(speed + 1), sigma(speed + 2)});
    result.chi2 = chi2_;
    // Equations of the IMU and of vision, and seven priors, less unknowns.
    result.freedom = (9 + 6) * (Frames() - 1) + 7 - static_cast<int>(normal_.rows());
  }

  const VisualMotion& motion_;
  std::span<const ImuPreintegration> imu_;
  Vector3d p_IC_;
  AlignmentPriors priors_;
  std::vector<Eigen::Matrix<double, 9, 9>> whitening_;
  State state_;
  MatrixXd directions_;  // Of gravity's steps, as columns.
  MatrixXd normal_;
  VectorXd right_;
  double chi2_ = 0.0;
};

}  // namespace

std::optional<Alignment> Align(const VisualMotion& motion, std::span<const ImuPreintegration> imu,
                               const Vector3d& p_IC, const AlignmentPriors& priors) {
  if (imu.empty() || imu.size() + 1 != motion.T_VI.size()) return std::nullopt;
  return Aligner(motion, imu, p_IC, priors).Run();
}

}  // namespace drydock::svin2
