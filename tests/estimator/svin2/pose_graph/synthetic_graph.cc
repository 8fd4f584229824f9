#include "tests/estimator/svin2/pose_graph/synthetic_graph.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace drydock::svin2::testing {

using Eigen::Vector3d;

namespace {

/// An ellipse of 24 x 12 m, looking ahead, with some height and tilt; 58 m a lap.
Pose OnTheWay(double laps) {
  const double angle = 2.0 * std::numbers::pi * laps;
  const double yaw = std::atan2(6.0 * std::cos(angle), -12.0 * std::sin(angle));
  return {FromYawPitchRoll(yaw, 0.1 * std::sin(3.0 * angle), 0.05 * std::cos(2.0 * angle)),
          {12.0 * std::cos(angle), 6.0 * std::sin(angle), 0.5 * std::sin(2.0 * angle)}};
}

}  // namespace

Matrix6d Covariance(double sigma_position, double sigma_angle) {
  Vector6d variances;
  variances << Vector3d::Constant(sigma_position * sigma_position),
      Vector3d::Constant(sigma_angle * sigma_angle);
  return variances.asDiagonal();
}

SyntheticDive::SyntheticDive(const SyntheticDiveConfig& config)
    : config_(config), random_(config.seed, "synthetic graph") {
  const std::int64_t count = config.laps * config.per_lap;
  for (std::int64_t k = 0; k < count; ++k)
    truth_.push_back(OnTheWay(static_cast<double>(k) / static_cast<double>(config.per_lap)));
  steps_.resize(truth_.size());
  for (std::int64_t k = 1; k < count; ++k) {
    PoseGraphEdge& step = steps_[static_cast<std::size_t>(k)];
    step.from = k - 1;
    step.to = k;
    step.T_from_to =
        Noisy(Truth(k - 1).Inverse() * Truth(k), config.sigma_position, config.sigma_angle);
    step.covariance = Covariance(config.sigma_position, config.sigma_angle);
  }
  Integrate();
}

void SyntheticDive::Integrate() {
  odometry_.assign(1, truth_.front());
  for (std::size_t k = 1; k < truth_.size(); ++k)
    odometry_.push_back(odometry_[k - 1] * steps_[k].T_from_to);
}

void SyntheticDive::GoBlind(std::int64_t first, std::int64_t last, const Vector3d& drift,
                            double sigma) {
  for (std::int64_t k = first + 1; k <= last; ++k) {
    PoseGraphEdge& step = steps_[static_cast<std::size_t>(k)];
    const Vector3d astray =
        Truth(k - 1).q().conjugate() * drift / static_cast<double>(last - first);
    step.T_from_to = {step.T_from_to.q(), step.T_from_to.p() + astray};
    step.covariance = Covariance(sigma, config_.sigma_angle);
  }
  Integrate();
}

PoseGraphNode SyntheticDive::Node(std::int64_t k) const {
  PoseGraphNode node;
  node.index = k;
  node.t = Time{k * kNanosecondsPerSecond};
  node.T_WI = odometry_[static_cast<std::size_t>(k)];
  return node;
}

void SyntheticDive::AddTo(PoseGraph& graph, std::int64_t k) const {
  graph.AddNode(Node(k));
  if (k > 0) graph.AddEdge(Step(k));
}

void SyntheticDive::AddTo(PoseGraph& graph) const {
  for (std::int64_t k = 0; k < size(); ++k) AddTo(graph, k);
}

Pose SyntheticDive::Noisy(const Pose& pose, double sigma_position, double sigma_angle) {
  Vector6d noise;
  for (int i = 0; i < 6; ++i)
    noise[i] = (i < 3 ? sigma_position : sigma_angle) * random_.Gaussian();
  return pose.BoxPlus(noise);
}

PoseGraphEdge SyntheticDive::Loop(std::int64_t from, std::int64_t to, const Pose& T_from_to) {
  PoseGraphEdge loop;
  loop.from = from;
  loop.to = to;
  loop.T_from_to = Noisy(T_from_to, config_.loop_sigma_position, config_.loop_sigma_angle);
  loop.covariance = Covariance(config_.loop_sigma_position, config_.loop_sigma_angle);
  loop.kind = EdgeKind::kLoop;
  return loop;
}

PoseGraphEdge SyntheticDive::TrueLoop(std::int64_t from, std::int64_t to) {
  return Loop(from, to, Truth(from).Inverse() * Truth(to));
}

PoseGraphEdge SyntheticDive::FalseLoop(std::int64_t from, std::int64_t to, const Vector3d& shift) {
  const Pose shifted(Truth(to).q(), Truth(to).p() + shift);
  return Loop(from, to, Truth(from).Inverse() * shifted);
}

PoseGraphEdge SyntheticDive::RandomLoop() {
  const auto last = static_cast<double>(size() - 1);
  const auto from = static_cast<std::int64_t>(random_.Uniform(0.0, last - 30.0));
  const auto to =
      static_cast<std::int64_t>(random_.Uniform(static_cast<double>(from) + 20.0, last));
  const Vector3d p(random_.Uniform(-3, 3), random_.Uniform(-3, 3), random_.Uniform(-1, 1));
  return Loop(from, to, {FromYawPitchRoll(random_.Uniform(-0.5, 0.5), 0.0, 0.0), p});
}

std::vector<PoseGraphEdge> SyntheticDive::TrueLoops(std::int64_t first, std::int64_t last,
                                                    std::int64_t stride) {
  std::vector<PoseGraphEdge> loops;
  for (std::int64_t k = first; k < last; k += stride)
    loops.push_back(TrueLoop(k - config_.per_lap, k));
  return loops;
}

double Ate(const SyntheticDive& dive, const std::vector<Pose>& estimate) {
  const auto count = static_cast<Eigen::Index>(estimate.size());
  Eigen::Matrix3Xd truth(3, count), estimated(3, count);
  for (Eigen::Index k = 0; k < count; ++k) {
    truth.col(k) = dive.Truth(k).p();
    estimated.col(k) = estimate[static_cast<std::size_t>(k)].p();
  }
  const Eigen::Matrix4d A = Eigen::umeyama(estimated, truth, false);
  const Eigen::Matrix3Xd aligned =
      (A.topLeftCorner<3, 3>() * estimated).colwise() + A.topRightCorner<3, 1>();
  return std::sqrt((aligned - truth).colwise().squaredNorm().mean());
}

}  // namespace drydock::svin2::testing
