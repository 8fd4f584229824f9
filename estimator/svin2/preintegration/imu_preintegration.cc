#include "estimator/svin2/preintegration/imu_preintegration.h"

#include <utility>

#include "sensors_models/base/check.h"
#include "sensors_models/base/pose.h"

namespace drydock::svin2 {
namespace {

/// One step of the trapezoidal rule from `start`, and how errors go through it.
struct Step {
  ImuDelta end;
  Eigen::Matrix<double, 9, 9> by_start;  ///< d(end)/d(start), order p, q, v.
  ImuBiasJacobian by_bias;               ///< d(end)/d(bias), with `start` held.
};

Step IntegrateSegment(const ImuDelta& start, const ImuSegment& segment, const ImuBias& bias) {
  const double dt = segment.length.Seconds();
  const Eigen::Vector3d turn =
      (0.5 * (segment.from.angular_rate + segment.to.angular_rate) - bias.gyro) * dt;
  Step step;
  step.end.q = (start.q * ExpSO3(turn)).normalized();
  const Eigen::Matrix3d R_before = start.q.toRotationMatrix();
  const Eigen::Matrix3d R_after = step.end.q.toRotationMatrix();
  const Eigen::Vector3d force_before = R_before * (segment.from.specific_force - bias.accel);
  const Eigen::Vector3d force_after = R_after * (segment.to.specific_force - bias.accel);
  const Eigen::Vector3d force = 0.5 * (force_before + force_after);
  step.end.v = start.v + force * dt;
  step.end.p = start.p + start.v * dt + 0.5 * force * dt * dt;

  // A rotation's error on the left stays as it is when turned on the right, and moves a force f by
  // -[f]x times itself.
  const Eigen::Matrix3d turn_by_gyro = -R_before * LeftJacobianSO3(turn) * dt;
  const Eigen::Matrix3d force_by_turn = -Skew(force);
  const Eigen::Matrix3d force_by_gyro = -0.5 * Skew(force_after) * turn_by_gyro;
  const Eigen::Matrix3d force_by_accel = -0.5 * (R_before + R_after);
  step.by_start.setIdentity();
  step.by_start.block<3, 3>(0, 3) = 0.5 * dt * dt * force_by_turn;
  step.by_start.block<3, 3>(0, 6).diagonal().setConstant(dt);
  step.by_start.block<3, 3>(6, 3) = dt * force_by_turn;
  step.by_bias.setZero();
  step.by_bias.block<3, 3>(0, 0) = 0.5 * dt * dt * force_by_gyro;
  step.by_bias.block<3, 3>(0, 3) = 0.5 * dt * dt * force_by_accel;
  step.by_bias.block<3, 3>(3, 0) = turn_by_gyro;
  step.by_bias.block<3, 3>(6, 0) = dt * force_by_gyro;
  step.by_bias.block<3, 3>(6, 3) = dt * force_by_accel;
  return step;
}

/// What white noise adds to the covariance of p, q, v in a step: on average over the step it acts
/// like a bias with variance density^2 / dt; its course within the step also moves the position,
/// which keeps the covariance regular after a single step.
Eigen::Matrix<double, 9, 9> WhiteNoise(const Step& step, const ImuSegment& segment) {
  const double dt = segment.length.Seconds();
  const double gyro = segment.gyro_noise_density * segment.gyro_noise_density;
  const double accel = segment.accel_noise_density * segment.accel_noise_density;
  const auto by_gyro = step.by_bias.leftCols<3>();
  const auto by_accel = step.by_bias.rightCols<3>();
  Eigen::Matrix<double, 9, 9> added =
      gyro / dt * by_gyro * by_gyro.transpose() + accel / dt * by_accel * by_accel.transpose();
  added.diagonal().head<3>().array() += accel * dt * dt * dt / 12.0;
  return added;
}

}  // namespace

std::optional<ImuPreintegration> ImuPreintegration::Over(std::span<const TimedImuSample> samples,
                                                         Time begin, Time end, const ImuBias& bias,
                                                         const ImuNoiseModel& noise) {
  Check(noise.gyro_noise_density > 0 && noise.accel_noise_density > 0 && noise.gyro_bias_walk > 0 &&
            noise.accel_bias_walk > 0,
        "IMU noise densities and walks must be above 0");
  std::vector<ImuSegment> segments = CutImuSegments(samples, begin, end, noise);
  if (segments.empty() && end != begin) return std::nullopt;
  return ImuPreintegration(begin, end, std::move(segments), noise, bias);
}

ImuPreintegration::ImuPreintegration(Time begin, Time end, std::vector<ImuSegment> segments,
                                     const ImuNoiseModel& noise, const ImuBias& bias)
    : begin_(begin), end_(end), segments_(std::move(segments)), noise_(noise), bias_(bias) {
  for (const ImuSegment& segment : segments_) AddSegment(segment);
}

void ImuPreintegration::AddSegment(const ImuSegment& segment) {
  const Step step = IntegrateSegment(delta_, segment, bias_);
  delta_ = step.end;
  bias_jacobian_ = step.by_start * bias_jacobian_ + step.by_bias;

  ImuCovariance transition = ImuCovariance::Identity();
  transition.topLeftCorner<9, 9>() = step.by_start;
  transition.topRightCorner<9, 6>() = step.by_bias;
  covariance_ = transition * covariance_ * transition.transpose();
  covariance_.topLeftCorner<9, 9>() += WhiteNoise(step, segment);
  const double dt = segment.length.Seconds();
  covariance_.diagonal().segment<3>(9).array() +=
      noise_.gyro_bias_walk * noise_.gyro_bias_walk * dt;
  covariance_.diagonal().tail<3>().array() += noise_.accel_bias_walk * noise_.accel_bias_walk * dt;
}

ImuDelta ImuPreintegration::DeltaAt(const ImuBias& bias) const {
  Eigen::Matrix<double, 6, 1> change;
  change << bias.gyro - bias_.gyro, bias.accel - bias_.accel;
  const Eigen::Matrix<double, 9, 1> moved = bias_jacobian_ * change;
  return {delta_.p + moved.head<3>(), ExpSO3(moved.segment<3>(3)) * delta_.q,
          delta_.v + moved.tail<3>()};
}

bool ImuPreintegration::NeedsReintegration(const ImuBias& bias) const {
  constexpr double kLargestTurn = 1e-4;
  return (bias.gyro - bias_.gyro).norm() * length().Seconds() > kLargestTurn;
}

ImuPreintegration ImuPreintegration::IntegratedAt(const ImuBias& bias) const {
  return {begin_, end_, segments_, noise_, bias};
}

}  // namespace drydock::svin2
