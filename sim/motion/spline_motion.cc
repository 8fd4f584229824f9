#include "sim/motion/spline_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include <fmt/format.h>

#include "sensors_models/base/check.h"

namespace drydock::sim {
namespace {

/// `angle` plus the multiple of 2 pi that brings it nearest to `reference`.
double Unwrap(double angle, double reference) {
  return angle +
         2.0 * std::numbers::pi * std::round((reference - angle) / (2.0 * std::numbers::pi));
}

/// Columns of x, y, z, yaw, pitch.
Eigen::MatrixXd PathPoints(const std::vector<Waypoint>& waypoints) {
  const std::size_t count = waypoints.size();
  Eigen::MatrixXd points(5, count);
  for (std::size_t i = 0; i < count; ++i) {
    const Waypoint& waypoint = waypoints[i];
    const Eigen::Vector3d ahead = waypoints[std::min(i + 1, count - 1)].position;
    const Eigen::Vector3d behind = waypoints[i > 0 ? i - 1 : 0].position;
    const Eigen::Vector3d view =
        waypoint.look_at ? *waypoint.look_at - waypoint.position : Eigen::Vector3d(ahead - behind);
    double yaw = std::atan2(view.y(), view.x()) + waypoint.yaw_offset_rad;
    if (i > 0) yaw = Unwrap(yaw, points(3, static_cast<Eigen::Index>(i) - 1));
    const double pitch =
        waypoint.look_at ? -std::atan2(view.z(), view.head<2>().norm()) : waypoint.pitch_rad;
    points.col(static_cast<Eigen::Index>(i)) << waypoint.position, yaw, pitch;
  }
  return points;
}

double ArcLength(const QuinticSpline& spline, double from, double to) {
  constexpr int kSteps = 64;
  double length = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double t = from + (to - from) * (i + 0.5) / kSteps;
    length += spline.Evaluate(t, 1).head<3>().norm() * (to - from) / kSteps;
  }
  return length;
}

/// Lengths of the straight stretches from way-point to way-point [m].
std::vector<double> StraightLengths(const std::vector<Waypoint>& waypoints) {
  std::vector<double> lengths;
  for (std::size_t i = 1; i < waypoints.size(); ++i)
    lengths.push_back((waypoints[i].position - waypoints[i - 1].position).norm());
  return lengths;
}

/// A curve that settles keeps to less than twice its way-points' polygon, even in a U-turn between
/// two long stretches. Where stretches are too unequal it swings out between them, is given more
/// time for that and swings out the further for it, to thousands of kilometres in a few rounds.
void RequireNearPolygon(const std::vector<Waypoint>& waypoints, const std::vector<double>& lengths,
                        const std::vector<double>& straight) {
  constexpr double kMost = 2.0;
  const double curve = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  const double polygon = std::accumulate(straight.begin(), straight.end(), 0.0);
  if (curve <= kMost * polygon) return;
  std::size_t worst = 0;
  for (std::size_t i = 1; i < lengths.size(); ++i) {
    if (lengths[i] - straight[i] > lengths[worst] - straight[worst]) worst = i;
  }
  throw InputError(fmt::format(
      "{}: the curve is {:.4g} m long on the stretch of {:.4g} m to this way-point and {:.4g} m in "
      "all, must be at most {} times the {:.4g} m of its straight stretches: are neighbouring "
      "stretches too unequal?",
      waypoints[worst + 1].place, lengths[worst], straight[worst], curve, kMost, polygon));
}

/// Chooses the times of the way-points such that each stretch is passed at `speed`, the first and
/// the last at half of it, since the path starts and ends at rest.
QuinticSpline FitAtSpeed(const std::vector<Waypoint>& waypoints, double speed) {
  const Eigen::MatrixXd points = PathPoints(waypoints);
  const std::vector<double> straight = StraightLengths(waypoints);
  const std::size_t stretches = straight.size();
  std::vector<double> lengths = straight;
  const auto fit = [&](std::vector<double>& times) {
    times.assign(1, 0.0);
    for (std::size_t i = 0; i < stretches; ++i) {
      const double share = i == 0 || i + 1 == stretches ? 0.5 : 1.0;
      times.push_back(times.back() + lengths[i] / (share * speed));
    }
    return QuinticSpline(times, points);
  };
  constexpr int kRounds = 8;  // The lengths settle to a per mille within four.
  std::vector<double> times;
  QuinticSpline spline = fit(times);
  for (int round = 0;; ++round) {
    for (std::size_t i = 0; i < stretches; ++i)
      lengths[i] = ArcLength(spline, times[i], times[i + 1]);
    RequireNearPolygon(waypoints, lengths, straight);
    if (round == kRounds) return spline;
    spline = fit(times);
  }
}

/// Angular rate in the body frame from yaw, pitch, roll and their rates.
Eigen::Vector3d BodyRate(double pitch, double roll, const Eigen::Vector3d& yaw_pitch_roll_rates) {
  const double yaw_rate = yaw_pitch_roll_rates[0];
  const double pitch_rate = yaw_pitch_roll_rates[1];
  const double roll_rate = yaw_pitch_roll_rates[2];
  return {roll_rate - yaw_rate * std::sin(pitch),
          pitch_rate * std::cos(roll) + yaw_rate * std::sin(roll) * std::cos(pitch),
          -pitch_rate * std::sin(roll) + yaw_rate * std::cos(roll) * std::cos(pitch)};
}

}  // namespace

SplineMotion::SplineMotion(const MotionConfig& config, std::uint64_t seed)
    : rest_s_(config.rest_s),
      path_(FitAtSpeed(config.waypoints, config.speed_m_s)),
      sway_(config.sway, seed) {}

std::size_t SplineMotion::NearestWaypoint(Time t) const {
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < path_.size(); ++i) {
    const auto away = [&](std::size_t k) {
      return std::abs(rest_s_ + path_.TimeOf(k) - t.Seconds());
    };
    if (away(i) < away(nearest)) nearest = i;
  }
  return nearest;
}

MotionState SplineMotion::At(Time t) const {
  const double seconds = t.Seconds() - rest_s_;
  const Eigen::VectorXd value = path_.Evaluate(seconds);
  const Eigen::VectorXd rate = path_.Evaluate(seconds, 1);
  const Eigen::VectorXd acceleration = path_.Evaluate(seconds, 2);
  const Sway::Sample sway = sway_.At(seconds);

  const double yaw = value[3] + sway.value[3];
  const double pitch = value[4] + sway.value[4];
  const double roll = sway.value[5];
  const Eigen::Vector3d angle_rates(rate[3] + sway.rate[3], rate[4] + sway.rate[4], sway.rate[5]);

  MotionState state;
  state.T_WI = Pose(FromYawPitchRoll(yaw, pitch, roll), value.head<3>() + sway.value.head<3>());
  state.v_W = rate.head<3>() + sway.rate.head<3>();
  state.a_W = acceleration.head<3>() + sway.acceleration.head<3>();
  state.w_I = BodyRate(pitch, roll, angle_rates);
  return state;
}

}  // namespace drydock::sim
