#include "scenarios/scoring/errors.h"

#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sensors_models/base/check.h"
#include "tests/scenarios/scoring/support.h"

namespace drydock::score {
namespace {

using testing::DoubleNear;
using testing::Each;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

using Unit = StepOptions::Unit;

/// Poses at these places along x, truth and estimate.
std::vector<PosePair> Line(const std::vector<double>& truth, const std::vector<double>& estimate) {
  std::vector<PosePair> pairs;
  const auto at = [](double x) {
    return Pose(Eigen::Quaterniond::Identity(), Eigen::Vector3d(x, 0.0, 0.0));
  };
  for (std::size_t i = 0; i < truth.size(); ++i) {
    pairs.push_back({Time{static_cast<std::int64_t>(i)}, at(truth[i]), at(estimate[i])});
  }
  return pairs;
}

TEST(Summarize, ByHand) {
  const auto s = Summarize({4.0, 1.0, 2.0, 2.0});
  ASSERT_TRUE(s.has_value());
  EXPECT_EQ(s->count, 4U);
  EXPECT_DOUBLE_EQ(s->rmse, 2.5);  // sqrt(25 / 4)
  EXPECT_DOUBLE_EQ(s->mean, 2.25);
  EXPECT_DOUBLE_EQ(s->median, 2.0);
  EXPECT_DOUBLE_EQ(s->standard_deviation, std::sqrt(1.1875));  // divided by n, not n - 1
  EXPECT_EQ(s->min, 1.0);
  EXPECT_EQ(s->max, 4.0);
  EXPECT_EQ(s->sse, 25.0);
}

TEST(Summarize, MedianOfAnOddCountAndOfNone) {
  EXPECT_EQ(Summarize({5.0, 1.0, 3.0})->median, 3.0);
  EXPECT_EQ(Summarize({5.0})->standard_deviation, 0.0);
  EXPECT_FALSE(Summarize({}).has_value());
}

TEST(Summarize, SumsWithoutLoss) {
  std::vector<double> values(10'000, 1e-8);
  values.insert(values.begin(), 1e8);
  EXPECT_DOUBLE_EQ(Summarize(values)->mean * 10'001.0, 1e8 + 1e-4);
}

TEST(AbsoluteErrors, TranslationAndRotation) {
  const Pose truth(FromYawPitchRoll(0.5, 0.0, 0.0), {1.0, 2.0, 3.0});
  const Pose estimate(FromYawPitchRoll(0.8, 0.0, 0.0), {1.0, 5.0, 7.0});
  const PoseErrors errors = AbsoluteErrors({{Time{0}, truth, estimate}}, {});
  EXPECT_THAT(errors.translation, ElementsAre(DoubleNear(5.0, 1e-14)));
  EXPECT_THAT(errors.rotation, ElementsAre(DoubleNear(0.3, 1e-14)));
}

TEST(SelectSteps, ByFrames) {
  const auto pairs = Line(std::vector<double>(7), std::vector<double>(7));
  EXPECT_THAT(SelectSteps(pairs, {.step = 3, .unit = Unit::kFrames, .all_pairs = false}),
              ElementsAre(Pair(0, 3), Pair(3, 6)));
  EXPECT_THAT(SelectSteps(pairs, {.step = 5, .unit = Unit::kFrames}),
              ElementsAre(Pair(0, 5), Pair(1, 6)));
  EXPECT_THAT(SelectSteps(pairs, {.step = 7, .unit = Unit::kFrames}), IsEmpty());
}

TEST(SelectSteps, AllByMetresTakesTheNearestWithinATenth) {
  const std::vector<double> x = {0.0, 2.0, 4.6, 5.3, 7.5, 20.0};
  // From 0: 5.3 (off by 0.3). From 2: 7.5 (off by 0.5, a tenth of 5, allowed). From 4.6, 5.3 and
  // 7.5: nothing near enough.
  EXPECT_THAT(SelectSteps(Line(x, x), {.step = 5.0}), ElementsAre(Pair(0, 3), Pair(1, 4)));
}

TEST(SelectSteps, AllByMetresTakesTheFirstOnTies) {
  const std::vector<double> tie = {0.0, 4.75, 5.25, 5.25};
  EXPECT_THAT(SelectSteps(Line(tie, tie), {.step = 5.0}), ElementsAre(Pair(0, 1)));
  const std::vector<double> resting = {0.0, 5.0, 5.0, 5.0};
  EXPECT_THAT(SelectSteps(Line(resting, resting), {.step = 5.0}), ElementsAre(Pair(0, 1)));
}

TEST(SelectSteps, ByMetresOneAfterTheOther) {
  const std::vector<double> x = {0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0};
  // As evo does it: the first step ends where it begins to count.
  EXPECT_THAT(SelectSteps(Line(x, x), {.step = 2.0, .all_pairs = false}),
              ElementsAre(Pair(2, 4), Pair(4, 6)));
}

TEST(SelectSteps, AlongTheEstimateUnlessToldTheTruth) {
  const auto pairs = Line({0.0, 5.0, 10.0}, {0.0, 2.5, 5.0});
  EXPECT_THAT(SelectSteps(pairs, {.step = 5.0}), ElementsAre(Pair(0, 2)));
  EXPECT_THAT(SelectSteps(pairs, {.step = 5.0, .along = StepOptions::Along::kTruth}),
              ElementsAre(Pair(0, 1), Pair(1, 2)));
}

TEST(SelectSteps, RefusesStepsThatAreNone) {
  const auto pairs = Line({0.0, 1.0}, {0.0, 1.0});
  EXPECT_THROW(SelectSteps(pairs, {.step = 0.5, .unit = Unit::kFrames}), InputError);
  EXPECT_THROW(SelectSteps(pairs, {.step = 0.0}), InputError);
  EXPECT_THROW(SelectSteps(pairs, {.step = std::nan("")}), InputError);
}

TEST(SelectSteps, EmptyAndSingle) {
  EXPECT_THAT(SelectSteps({}, {}), IsEmpty());
  EXPECT_THAT(SelectSteps(Line({0.0}, {0.0}), {}), IsEmpty());
  EXPECT_THAT(SelectSteps({}, {.all_pairs = false}), IsEmpty());
}

TEST(RelativeErrors, PureScaleMakesAConstantError) {
  std::vector<double> truth;
  std::vector<double> estimate;
  for (int i = 0; i <= 100; ++i) {
    truth.push_back(0.1 * i);
    estimate.push_back(0.11 * i);
  }
  const auto errors = RelativeErrors(Line(truth, estimate), {.step = 10, .unit = Unit::kFrames});
  EXPECT_EQ(errors.translation.size(), 91U);
  EXPECT_THAT(errors.translation, Each(DoubleNear(0.1, 1e-12)));
  EXPECT_THAT(errors.rotation, Each(DoubleNear(0.0, 1e-12)));
}

TEST(RelativeErrors, DoNotSeeAMovedWorld) {
  const Trajectory truth = Helix();
  const Trajectory moved = Moved(truth, Pose(FromYawPitchRoll(1.0, 2.0, 3.0), {9.0, 8.0, 7.0}));
  std::vector<PosePair> pairs;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    pairs.push_back({truth[i].t, truth[i].T_WI, moved[i].T_WI});
  }
  const auto errors = RelativeErrors(pairs, {});
  EXPECT_FALSE(errors.translation.empty());
  EXPECT_THAT(errors.translation, Each(DoubleNear(0.0, 1e-12)));
  EXPECT_THAT(errors.rotation, Each(DoubleNear(0.0, 1e-12)));
}

}  // namespace
}  // namespace drydock::score
