#include "estimator/dead_reckoning/vertical_filter.h"

namespace drydock {

VerticalFilter::VerticalFilter(const Config& config) : config_(config) {
  const Eigen::Vector3d sigma(config.initial_height, config.initial_speed, config.initial_bias);
  covariance_ = sigma.cwiseAbs2().asDiagonal();
}

void VerticalFilter::Predict(double dt) {
  Eigen::Matrix3d transition;
  transition << 1, dt, 0.5 * dt * dt, 0, 1, dt, 0, 0, 1;
  covariance_ = transition * covariance_ * transition.transpose();
  covariance_(1, 1) += config_.acceleration_noise * config_.acceleration_noise * dt;
  covariance_(2, 2) += config_.bias_walk * config_.bias_walk * dt;
}

Eigen::Vector3d VerticalFilter::Update(double measured_minus_predicted) {
  const double innovation_variance = covariance_(0, 0) + config_.depth_noise * config_.depth_noise;
  const Eigen::Vector3d gain = covariance_.col(0) / innovation_variance;
  // Joseph's form keeps the covariance symmetric and positive.
  Eigen::Matrix3d keep = Eigen::Matrix3d::Identity();
  keep.col(0) -= gain;
  covariance_ = keep * covariance_ * keep.transpose() +
                config_.depth_noise * config_.depth_noise * gain * gain.transpose();
  return gain * measured_minus_predicted;
}

}  // namespace drydock
