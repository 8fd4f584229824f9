#include "estimator/svin2/loop/loop_verifier.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "sensors_models/base/check.h"

namespace drydock::svin2 {
namespace {

// Which of a match's two points is meant, and where the match has it.
using Side = std::size_t LoopMatch::*;

Eigen::Vector3d Down(const Pose& T_WI) { return T_WI.q().conjugate() * -Eigen::Vector3d::UnitZ(); }

double TiltError(const Keyframe& now, const Keyframe& then, const Pose& T_then_now) {
  const Eigen::Vector3d by_odometry = Down(now.T_WI);
  const Eigen::Vector3d by_loop = Down(then.T_WI * T_then_now);
  return std::atan2(by_odometry.cross(by_loop).norm(), by_odometry.dot(by_loop));
}

// RMS distance of the matches' pixels from their mean in the direction in which it is smallest.
double Spread(const Keyframe& keyframe, const std::vector<LoopMatch>& matches, Side side) {
  const auto count = static_cast<double>(matches.size());
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const LoopMatch& match : matches) mean += keyframe.points[match.*side].left / count;
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (const LoopMatch& match : matches) {
    const Eigen::Vector2d d = keyframe.points[match.*side].left - mean;
    scatter += d * d.transpose() / count;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(scatter, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, solver.eigenvalues()[0]));
}

// The landmarks of one keyframe where the other's cameras see their matches.
std::vector<LandmarkObservation> Observations(const std::vector<LoopMatch>& matches,
                                              const Keyframe& known_by, Side landmark_side,
                                              const Keyframe& seen_by, Side pixel_side) {
  std::vector<LandmarkObservation> observations;
  for (const LoopMatch& match : matches) {
    const auto& landmark = known_by.points[match.*landmark_side].p_I;
    if (!landmark.has_value()) continue;
    const KeyframePoint& seen = seen_by.points[match.*pixel_side];
    const double scale = ErrorScale(seen);
    observations.push_back({*landmark, 0, seen.left, scale});
    if (seen.right.has_value()) observations.push_back({*landmark, 1, *seen.right, scale});
  }
  return observations;
}

std::uint64_t SeedOf(const Keyframe& now, const Keyframe& then) {
  return static_cast<std::uint64_t>(static_cast<std::uint32_t>(now.index)) << 32 |
         static_cast<std::uint32_t>(then.index);
}

}  // namespace

const char* ToString(LoopStatus status) {
  switch (status) {
    case LoopStatus::kGood:
      return "good";
    case LoopStatus::kFewMatches:
      return "few matches";
    case LoopStatus::kFewInliers:
      return "few inliers";
    case LoopStatus::kLowShare:
      return "low share of inliers";
    case LoopStatus::kNarrow:
      return "narrow";
    case LoopStatus::kFar:
      return "far";
    case LoopStatus::kTilted:
      return "tilted";
    case LoopStatus::kOffHeight:
      return "off height";
    case LoopStatus::kPoorFit:
      return "poor fit";
    case LoopStatus::kUndetermined:
      return "undetermined";
  }
  return "";
}

LoopVerifier::LoopVerifier(const Config& config, const StereoGeometry& rig)
    : config_(config), rig_(rig) {
  RequireInput(config.min_inliers >= 4, "min_inliers is {}; it must be at least 4",
               config.min_inliers);
  RequireInput(config.min_inlier_share >= 0.0 && config.min_inlier_share <= 1.0,
               "min_inlier_share is {}; it must lie in [0, 1]", config.min_inlier_share);
  RequireInput(config.max_error_px > 0.0 && config.max_iterations > 0,
               "max_error_px is {} and max_iterations {}; both must be positive",
               config.max_error_px, config.max_iterations);
  RequireInput(config.min_spread_px >= 0.0, "min_spread_px is {}; it must not be negative",
               config.min_spread_px);
  RequireInput(config.max_distance_m > 0.0 && config.max_angle_rad > 0.0 &&
                   config.max_tilt_error_rad > 0.0 && config.max_height_error_m.value_or(1.0) > 0.0,
               "a loop's bounds of distance, angle, tilt and height must be positive");
}

// What the matches of two keyframes have to say about the motion.
struct LoopVerifier::Candidates {
  const StereoGeometry& rig;
  const Keyframe& now;
  const Keyframe& then;
  const std::vector<LoopMatch>& matches;

  // Then's landmarks in the cameras of now: a body at T_then_now sees them.
  std::vector<LandmarkObservation> SeenNow() const {
    return Observations(matches, then, &LoopMatch::then, now, &LoopMatch::now);
  }
  std::vector<LandmarkObservation> SeenThen() const {
    return Observations(matches, now, &LoopMatch::now, then, &LoopMatch::then);
  }

  // Whether everything that can be said of a match agrees with the motion, and anything can.
  std::vector<LoopMatch> Agreeing(const Pose& T_then_now, double max_error_px) const {
    const Pose T_now_then = T_then_now.Inverse();
    const auto agrees = [&](const std::optional<Eigen::Vector3d>& landmark, const Pose& T,
                            const KeyframePoint& seen) {
      if (!landmark.has_value()) return true;
      const auto is_near = [&](int camera, const Eigen::Vector2d& pixel) {
        const auto expected =
            rig.camera(camera).Project(rig.T_IC(camera).Inverse() * (T * *landmark));
        return expected.has_value() && (*expected - pixel).norm() < max_error_px * ErrorScale(seen);
      };
      return is_near(0, seen.left) && (!seen.right.has_value() || is_near(1, *seen.right));
    };
    std::vector<LoopMatch> agreeing;
    for (const LoopMatch& match : matches) {
      const auto& of_now = now.points[match.now].p_I;
      const auto& of_then = then.points[match.then].p_I;
      if (!of_now.has_value() && !of_then.has_value()) continue;
      if (agrees(of_then, T_now_then, now.points[match.now]) &&
          agrees(of_now, T_then_now, then.points[match.then])) {
        agreeing.push_back(match);
      }
    }
    return agreeing;
  }
};

std::optional<Pose> LoopVerifier::FindPose(const Candidates& candidates,
                                           const std::optional<Pose>& guess,
                                           std::uint64_t seed) const {
  RigRansacConfig ransac;
  ransac.max_error_px = config_.max_error_px;
  ransac.max_iterations = config_.max_iterations;
  ransac.min_inliers = config_.min_inliers;
  if (const auto found = EstimateRigPose(rig_, candidates.SeenNow(), guess, seed, ransac))
    return found->T_WI;
  // Then's points may not have become landmarks where now's have.
  const auto inverse = guess ? std::optional(guess->Inverse()) : std::nullopt;
  if (const auto found = EstimateRigPose(rig_, candidates.SeenThen(), inverse, seed, ransac))
    return found->T_WI.Inverse();
  return std::nullopt;
}

VerifiedLoop LoopVerifier::Verify(const Keyframe& now, const Keyframe& then,
                                  const std::vector<LoopMatch>& matches,
                                  const std::optional<Pose>& T_then_now) const {
  VerifiedLoop loop;
  if (matches.size() < static_cast<std::size_t>(config_.min_inliers)) return loop;
  loop.status = LoopStatus::kFewInliers;
  const Candidates candidates{.rig = rig_, .now = now, .then = then, .matches = matches};
  const auto found = FindPose(candidates, T_then_now, SeedOf(now, then));
  if (!found.has_value()) return loop;
  loop.T_then_now = *found;
  loop.inliers = candidates.Agreeing(*found, config_.max_error_px);
  loop.status = Judge(now, then, matches.size(), loop);
  return loop;
}

LoopStatus LoopVerifier::Judge(const Keyframe& now, const Keyframe& then, std::size_t matches,
                               const VerifiedLoop& loop) const {
  const auto inliers = static_cast<double>(loop.inliers.size());
  if (inliers < config_.min_inliers) return LoopStatus::kFewInliers;
  if (inliers < config_.min_inlier_share * static_cast<double>(matches))
    return LoopStatus::kLowShare;
  if (std::min(Spread(now, loop.inliers, &LoopMatch::now),
               Spread(then, loop.inliers, &LoopMatch::then)) < config_.min_spread_px) {
    return LoopStatus::kNarrow;
  }
  if (loop.T_then_now.p().norm() > config_.max_distance_m ||
      LogSO3(loop.T_then_now.q()).norm() > config_.max_angle_rad) {
    return LoopStatus::kFar;
  }
  if (TiltError(now, then, loop.T_then_now) > config_.max_tilt_error_rad)
    return LoopStatus::kTilted;
  const double height = (then.T_WI * loop.T_then_now).p().z();
  if (config_.max_height_error_m.has_value() && now.map_id == then.map_id &&
      std::abs(height - now.T_WI.p().z()) > *config_.max_height_error_m) {
    return LoopStatus::kOffHeight;
  }
  return LoopStatus::kGood;
}

}  // namespace drydock::svin2
