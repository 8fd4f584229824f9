// The feature tracker at work before a textured wall, for its tests.
#pragma once

#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "estimator/svin2/frontend/feature_tracker.h"
#include "tests/estimator/svin2/frontend/synthetic_dive.h"

namespace drydock::svin2::testing {

/// Sideways and up, turning, and 6 mm nearer each frame.
inline Pose PoseAt(int k) {
  return {ExpSO3({0.004 * k, -0.002 * k, 0.003 * k}), {0.006 * k, 0.012 * k, 0.008 * k}};
}

inline Time TimeAt(int k) { return SampleTime({}, k, 15.0); }

inline FeatureTracker::Config Small(Matching matching = Matching::kBoth) {
  FeatureTracker::Config config;
  config.matching = matching;
  config.detector.max_corners = 80;
  config.detector.min_score = 2e-3;
  return config;
}

inline std::optional<MotionPrediction> Prediction(int k) {
  if (k == 0) return std::nullopt;
  return MotionPrediction{PoseAt(k - 1), PoseAt(k)};
}

/// The tracker at work, and where on the wall each of its points was first seen.
class Dive {
 public:
  explicit Dive(const FeatureTracker::Config& config) : tracker_(config, HalfRig()) {}

  TrackedFrame Swim(int k, bool predict = true) { return See(k, wall_.See(PoseAt(k)), predict); }

  TrackedFrame See(int k, const StereoFrame& images, bool predict = true) {
    const auto lookup = [this](LandmarkId id) -> std::optional<Eigen::Vector3d> {
      const auto found = points_W_.find(id);
      return found == points_W_.end() ? std::nullopt : std::optional(found->second);
    };
    TrackedFrame frame =
        tracker_.Track(TimeAt(k), images, predict ? Prediction(k) : std::nullopt, lookup);
    for (const TrackedPoint& point : frame.points) {
      points_W_.try_emplace(point.id, wall_.PointAt(PoseAt(k), 0, point.left));
    }
    return frame;
  }

  /// Of the pixels of both cameras, with the number of them.
  double RmsError(int k, const TrackedFrame& frame) const {
    double squares = 0.0;
    int n = 0;
    for (const TrackedPoint& point : frame.points) {
      const Eigen::Vector3d& p_W = points_W_.at(point.id);
      squares += (wall_.PixelOf(PoseAt(k), 0, p_W).value() - point.left).squaredNorm();
      ++n;
      if (!point.right.has_value()) continue;
      squares += (wall_.PixelOf(PoseAt(k), 1, p_W).value() - *point.right).squaredNorm();
      ++n;
    }
    return std::sqrt(squares / n);
  }

  /// Where the point that was first seen as `id` is seen.
  Eigen::Vector2d PixelOf(int k, LandmarkId id) const {
    return wall_.PixelOf(PoseAt(k), 0, points_W_.at(id)).value();
  }

  FeatureTracker& tracker() { return tracker_; }
  const WallDive& wall() const { return wall_; }

 private:
  WallDive wall_;
  FeatureTracker tracker_;
  std::map<LandmarkId, Eigen::Vector3d> points_W_;
};

inline std::set<LandmarkId> IdsOf(const TrackedFrame& frame) {
  std::set<LandmarkId> ids;
  for (const TrackedPoint& point : frame.points) ids.insert(point.id);
  return ids;
}

inline std::size_t Shared(const TrackedFrame& a, const TrackedFrame& b) {
  const auto ids = IdsOf(b);
  std::size_t shared = 0;
  for (const LandmarkId id : IdsOf(a)) shared += ids.contains(id) ? 1 : 0;
  return shared;
}

}  // namespace drydock::svin2::testing
