#include "scenarios/scoring/association.h"

#include <initializer_list>

#include <gtest/gtest.h>

#include "tests/scenarios/scoring/support.h"

namespace drydock::score {
namespace {

/// Poses at these milliseconds whose x is the millisecond, to tell them apart.
Trajectory At(std::initializer_list<double> milliseconds) {
  Trajectory trajectory;
  for (const double ms : milliseconds) {
    trajectory.push_back({Time::FromSeconds(1e-3 * ms),
                          Pose(Eigen::Quaterniond::Identity(), Eigen::Vector3d(ms, 0.0, 0.0))});
  }
  return trajectory;
}

TEST(Associate, TakesTheNearest) {
  const auto result = Associate(At({0, 10, 20, 30}), At({12, 27}), {});
  ASSERT_EQ(result.pairs.size(), 2U);
  EXPECT_EQ(result.pairs[0].truth.p().x(), 10.0);
  EXPECT_EQ(result.pairs[1].truth.p().x(), 30.0);
  EXPECT_EQ(result.pairs[1].t.ns, 27'000'000);
}

TEST(Associate, TakesTheEarlierOnTies) {
  const auto result = Associate(At({0, 10, 20, 30}), At({5, 15}), {});
  ASSERT_EQ(result.pairs.size(), 2U);
  EXPECT_EQ(result.pairs[0].truth.p().x(), 0.0);
  EXPECT_EQ(result.pairs[1].truth.p().x(), 10.0);
}

TEST(Associate, MaximumDifferenceIsInclusive) {
  EXPECT_EQ(Associate(At({0, 100}), At({10}), {}).pairs.size(), 1U);
  EXPECT_EQ(Associate(At({0, 100}), At({10.001}), {}).pairs.size(), 0U);
  EXPECT_EQ(Associate(At({0, 100}), At({30}), {.max_difference_s = 0.03}).pairs.size(), 1U);
}

TEST(Associate, SeveralPosesMayShareAPartner) {
  const auto result = Associate(At({0, 10, 200, 300}), At({8, 9, 11}), {});
  ASSERT_EQ(result.pairs.size(), 3U);
  for (const PosePair& pair : result.pairs) EXPECT_EQ(pair.truth.p().x(), 10.0);
}

TEST(Associate, GoesThroughTheShorterTrajectory) {
  const auto result = Associate(At({10, 20}), At({8, 9, 11.5, 12, 18}), {});
  ASSERT_EQ(result.pairs.size(), 2U);
  EXPECT_EQ(result.pairs[0].truth.p().x(), 10.0);
  EXPECT_EQ(result.pairs[0].estimate.p().x(), 9.0);
  EXPECT_EQ(result.pairs[0].t.ns, 9'000'000);
  EXPECT_EQ(result.pairs[1].estimate.p().x(), 18.0);
}

TEST(Associate, OfEquallyLongOnesGoesThroughTheEstimate) {
  const auto result = Associate(At({0, 10, 20}), At({9, 10, 11}), {});
  ASSERT_EQ(result.pairs.size(), 3U);
  EXPECT_EQ(result.pairs[0].estimate.p().x(), 9.0);
  EXPECT_EQ(result.pairs[2].estimate.p().x(), 11.0);
}

TEST(Associate, TellsWhyPosesWereDropped) {
  const auto result =
      Associate(At({100, 110, 400, 410, 420, 430}), At({50, 105, 250, 415, 500}), {});
  EXPECT_EQ(result.truth_poses, 6U);
  EXPECT_EQ(result.estimate_poses, 5U);
  EXPECT_EQ(result.pairs.size(), 2U);
  EXPECT_EQ(result.dropped_outside, 2U);
  EXPECT_EQ(result.dropped_in_gap, 1U);
}

TEST(Associate, EmptyTrajectories) {
  EXPECT_TRUE(Associate({}, {}, {}).pairs.empty());
  EXPECT_TRUE(Associate({}, At({1}), {}).pairs.empty());
  EXPECT_TRUE(Associate(At({1}), {}, {}).pairs.empty());
  const auto result = Associate({}, At({1}), {.mode = AssociationMode::kInterpolate});
  EXPECT_EQ(result.dropped_outside, 1U);
}

TEST(Associate, InterpolatesTheTruth) {
  const auto result = Associate(At({0, 10, 100}), At({-1, 4, 55, 100, 101}),
                                {.mode = AssociationMode::kInterpolate});
  ASSERT_EQ(result.pairs.size(), 3U);
  EXPECT_NEAR(result.pairs[0].truth.p().x(), 4.0, 1e-12);
  EXPECT_NEAR(result.pairs[1].truth.p().x(), 55.0, 1e-12);
  EXPECT_EQ(result.pairs[2].truth.p().x(), 100.0);
  EXPECT_EQ(result.dropped_outside, 2U);
}

// Doubles of seconds since 1970 are 238 ns apart: stamps closer than that are the same to evo.
TEST(Associate, ComparesLargeStampsAsDoubleSeconds) {
  Trajectory truth = At({0, 10, 20});
  Trajectory estimate = At({10});
  for (auto* trajectory : {&truth, &estimate}) {
    for (StampedPose& pose : *trajectory) pose.t.ns += 1'600'000'000'000'000'000;
  }
  truth[1].t.ns += 40;
  truth.insert(truth.begin() + 1, truth[1]);
  truth[1].t.ns -= 80;
  truth[1].T_WI = Pose(Eigen::Quaterniond::Identity(), {-1.0, 0.0, 0.0});
  const auto result = Associate(truth, estimate, {});
  ASSERT_EQ(result.pairs.size(), 1U);
  EXPECT_EQ(result.pairs[0].truth.p().x(), -1.0);
}

}  // namespace
}  // namespace drydock::score
