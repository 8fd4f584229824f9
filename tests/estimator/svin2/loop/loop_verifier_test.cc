#include "estimator/svin2/loop/loop_verifier.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "sensors_models/base/check.h"
#include "tests/estimator/svin2/loop/synthetic_loop.h"

namespace drydock::svin2 {
namespace {

using testing::MakeLoop;
using testing::SyntheticLoop;

VerifiedLoop Verify(const SyntheticLoop& loop, const std::vector<LoopMatch>& matches,
                    const LoopVerifier::Config& config = {}) {
  return LoopVerifier(config, loop.rig).Verify(loop.now, loop.then, matches);
}

TEST(LoopVerifier, IsExactWithoutNoise) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const SyntheticLoop loop = MakeLoop({.seed = seed});
    const VerifiedLoop verified = Verify(loop, loop.matches);
    ASSERT_TRUE(verified.IsGood()) << ToString(verified.status);
    EXPECT_EQ(verified.inliers.size(), loop.matches.size());
    EXPECT_LT(testing::ErrorOf(verified.T_then_now, loop.T_then_now), 1e-9);
  }
}

TEST(LoopVerifier, SurvivesOutliersUpTo60Percent) {
  for (const double share : {0.3, 0.45, 0.6}) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const SyntheticLoop loop = MakeLoop({.seed = seed, .noisy = true});
      const auto matches = testing::WithOutliers(loop.matches, share);
      const VerifiedLoop verified = Verify(loop, matches);
      ASSERT_TRUE(verified.IsGood()) << share << " " << seed << ToString(verified.status);
      EXPECT_LT(testing::ErrorOf(verified.T_then_now, loop.T_then_now), 0.02);
      const auto right = std::ranges::count_if(verified.inliers, [&](const LoopMatch& match) {
        return loop.now.points[match.now].id == loop.then.points[match.then].id + 1000;
      });
      EXPECT_GE(right, static_cast<int>((1.0 - share) * 80) - 1);
      EXPECT_LE(static_cast<int>(verified.inliers.size()) - right, 1);
    }
  }
}

TEST(LoopVerifier, IsDeterministic) {
  const SyntheticLoop loop = MakeLoop({.noisy = true});
  const auto matches = testing::WithOutliers(loop.matches, 0.5);
  const VerifiedLoop one = Verify(loop, matches), two = Verify(loop, matches);
  EXPECT_EQ(one.T_then_now.p(), two.T_then_now.p());
  EXPECT_EQ(one.T_then_now.q().coeffs(), two.T_then_now.q().coeffs());
}

// What then's landmarks cannot say for want of stereo, now's do.
TEST(LoopVerifier, WorksFromEitherSide) {
  SyntheticLoop loop = MakeLoop();
  testing::CloseRightEye(loop.then);
  const VerifiedLoop verified = Verify(loop, loop.matches);
  ASSERT_TRUE(verified.IsGood());
  EXPECT_LT(testing::ErrorOf(verified.T_then_now, loop.T_then_now), 1e-9);
  testing::CloseRightEye(loop.now);
  EXPECT_EQ(Verify(loop, loop.matches).status, LoopStatus::kFewInliers);
}

// Coarse points err by pixels: what they are known to bounds what they may be off.
TEST(LoopVerifier, AllowsCoarsePointsTheirErrors) {
  SyntheticLoop loop =
      MakeLoop({.sigma_px = 2.5,
                .noisy = true,
                .T_then_now = Pose(Eigen::Quaterniond::Identity(), {0.1, 0.05, 0.0})});
  const VerifiedLoop coarse = Verify(loop, loop.matches);
  ASSERT_TRUE(coarse.IsGood());
  for (auto* points : {&loop.now.points, &loop.then.points})
    for (KeyframePoint& point : *points) point.sigma_px = 0.15;
  EXPECT_GT(coarse.inliers.size(), Verify(loop, loop.matches).inliers.size() + 20);
}

TEST(LoopVerifier, RefusesPlacesThatOnlyLookAlike) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const SyntheticLoop loop = MakeLoop({.seed = seed});
    EXPECT_EQ(Verify(loop, testing::WithOutliers(loop.matches, 1.0)).status,
              LoopStatus::kFewInliers);
  }
}

TEST(LoopVerifier, RefusesTooFew) {
  const SyntheticLoop loop = MakeLoop({.landmarks = 14});
  EXPECT_EQ(Verify(loop, loop.matches).status, LoopStatus::kFewMatches);
  EXPECT_EQ(Verify(loop, {}).status, LoopStatus::kFewMatches);
  const SyntheticLoop more = MakeLoop({.landmarks = 40});
  const auto matches = testing::WithOutliers(more.matches, 0.7);
  EXPECT_EQ(Verify(more, matches).status, LoopStatus::kFewInliers);
  EXPECT_EQ(Verify(more, matches, {.min_inliers = 10, .min_inlier_share = 0.5}).status,
            LoopStatus::kLowShare);
  EXPECT_TRUE(Verify(more, matches, {.min_inliers = 10, .max_iterations = 1000}).IsGood());
}

TEST(LoopVerifier, RefusesOneSpotOrLine) {
  const SyntheticLoop spot = MakeLoop({.half_width = 0.04});
  EXPECT_EQ(Verify(spot, spot.matches).status, LoopStatus::kNarrow);
  const SyntheticLoop loop = MakeLoop({.landmarks = 400});
  std::vector<LoopMatch> line;
  for (const LoopMatch& match : loop.matches)
    if (std::abs(loop.then.points[match.then].left.y() - 300.0) < 30.0) line.push_back(match);
  ASSERT_GE(line.size(), 20U);
  EXPECT_EQ(Verify(loop, line).status, LoopStatus::kNarrow);
}

TEST(LoopVerifier, RefusesWhatOdometryRulesOut) {
  SyntheticLoop loop = MakeLoop();
  EXPECT_EQ(Verify(loop, loop.matches, {.max_distance_m = 0.5}).status, LoopStatus::kFar);
  EXPECT_EQ(Verify(loop, loop.matches, {.max_angle_rad = 0.1}).status, LoopStatus::kFar);
  const Pose T_WI = loop.now.T_WI;
  // Drift in x, y and yaw is what loops are for.
  loop.now.T_WI = Pose(FromYawPitchRoll(1.0, 0.0, 0.0), {3, -2, 0}) * T_WI;
  EXPECT_TRUE(Verify(loop, loop.matches, {.max_height_error_m = 0.1}).IsGood());
  loop.now.T_WI = Pose(Eigen::Quaterniond::Identity(), {0, 0, 0.2}) * T_WI;
  EXPECT_TRUE(Verify(loop, loop.matches).IsGood());
  EXPECT_EQ(Verify(loop, loop.matches, {.max_height_error_m = 0.1}).status, LoopStatus::kOffHeight);
  loop.now.map_id = 1;
  EXPECT_TRUE(Verify(loop, loop.matches, {.max_height_error_m = 0.1}).IsGood());
  loop.now.T_WI = Pose(FromYawPitchRoll(0.0, 0.1, 0.0), {0, 0, 0}) * T_WI;
  EXPECT_EQ(Verify(loop, loop.matches).status, LoopStatus::kTilted);
}

TEST(LoopVerifier, RefusesValuesThatCannotBe) {
  const StereoGeometry rig(testing::SyntheticStereo());
  EXPECT_THROW(LoopVerifier({.min_inliers = 3}, rig), InputError);
  EXPECT_THROW(LoopVerifier({.min_inlier_share = 1.1}, rig), InputError);
  EXPECT_THROW(LoopVerifier({.max_error_px = 0.0}, rig), InputError);
  EXPECT_THROW(LoopVerifier({.min_spread_px = -1.0}, rig), InputError);
  EXPECT_THROW(LoopVerifier({.max_height_error_m = 0.0}, rig), InputError);
}

}  // namespace
}  // namespace drydock::svin2
