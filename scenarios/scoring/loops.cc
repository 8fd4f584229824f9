#include "scenarios/scoring/loops.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace drydock::score {
namespace {

constexpr double kRadians = std::numbers::pi / 180.0;

// What makes a loop true.
constexpr double kLoopDistance = 0.25;  // [m]
constexpr double kLoopDistanceShare = 0.05;
constexpr double kLoopAngle = 5.0 * kRadians;

// What makes a place a revisit.
constexpr double kPlaceStep = 0.5;  // [m]
constexpr std::size_t kLeastPlacesBack = 10;
constexpr Duration kLeastTimeBack{20 * kNanosecondsPerSecond};
constexpr double kSamePlaceDistance = 1.5;  // [m]
constexpr double kSamePlaceAngle = 30.0 * kRadians;

// What finds it.
constexpr Duration kFoundWithin{kNanosecondsPerSecond};

Trajectory PlacesOf(const Trajectory& truth) {
  Trajectory places;
  for (const StampedPose& pose : truth) {
    if (places.empty() || (pose.T_WI.p() - places.back().T_WI.p()).norm() >= kPlaceStep)
      places.push_back(pose);
  }
  return places;
}

bool AreTheSamePlace(const Pose& a, const Pose& b) {
  return (a.p() - b.p()).squaredNorm() <= kSamePlaceDistance * kSamePlaceDistance &&
         a.q().angularDistance(b.q()) <= kSamePlaceAngle;
}

bool IsRevisit(const Trajectory& places, std::size_t now) {
  for (std::size_t then = 0; then + kLeastPlacesBack <= now; ++then) {
    if (places[now].t - places[then].t < kLeastTimeBack) return false;
    if (AreTheSamePlace(places[then].T_WI, places[now].T_WI)) return true;
  }
  return false;
}

bool IsFound(Time t, const std::vector<Time>& closed) {
  return std::any_of(closed.begin(), closed.end(),
                     [t](Time at) { return std::llabs((at - t).ns) <= kFoundWithin.ns; });
}

}  // namespace

std::optional<bool> IsTrue(const Trajectory& truth, const Loop& loop) {
  const std::optional<Pose> now = Interpolate(truth, loop.t_now);
  const std::optional<Pose> then = Interpolate(truth, loop.t_then);
  if (!now || !then) return std::nullopt;
  const Pose T_then_now = then->Inverse() * *now;
  const double distance = (loop.T_then_now.p() - T_then_now.p()).norm();
  const double angle = loop.T_then_now.q().angularDistance(T_then_now.q());
  return distance <= kLoopDistance + kLoopDistanceShare * T_then_now.p().norm() &&
         angle <= kLoopAngle;
}

double LoopScore::PrecisionPercent() const {
  if (judged == 0) return 100.0;
  return 100.0 * static_cast<double>(true_loops) / static_cast<double>(judged);
}

std::optional<double> LoopScore::RecallPercent() const {
  if (revisits == 0) return std::nullopt;
  return 100.0 * static_cast<double>(found) / static_cast<double>(revisits);
}

LoopScore ScoreLoops(const Trajectory& truth, const std::vector<Loop>& loops) {
  LoopScore score;
  std::vector<Time> closed;
  for (const Loop& loop : loops) {
    const std::optional<bool> is_true = IsTrue(truth, loop);
    if (!is_true) continue;
    ++score.judged;
    if (!*is_true) continue;
    ++score.true_loops;
    if (loop.t_now - loop.t_then >= kLeastTimeBack) closed.push_back(loop.t_now);
  }
  const Trajectory places = PlacesOf(truth);
  for (std::size_t now = 0; now < places.size(); ++now) {
    if (!IsRevisit(places, now)) continue;
    ++score.revisits;
    if (IsFound(places[now].t, closed)) ++score.found;
  }
  return score;
}

}  // namespace drydock::score
