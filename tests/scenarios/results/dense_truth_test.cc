#include "scenarios/results/dense_truth.h"

#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include "scenarios/scoring/trajectory_score.h"

namespace drydock {
namespace {

constexpr Duration Milliseconds(std::int64_t count) { return {count * 1'000'000}; }

/// On a circle of 1 m at 0.5 m/s, every `step` from `from` on.
Trajectory Circle(Time from, Duration step, int count) {
  Trajectory poses;
  for (Time t = from; count > 0; --count, t = t + step) {
    const double angle = 0.5 * t.Seconds();
    poses.push_back({t, Pose(FromYawPitchRoll(angle, 0.0, 0.0),
                             Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0))});
  }
  return poses;
}

TEST(DenseTruth, LeavesNoErrorOfTheScorersOwn) {
  // 100 Hz against 15 Hz; the estimate is the truth.
  const Trajectory truth = Circle(Time{}, Milliseconds(10), 1000);
  const Trajectory estimate = Circle(Time{3'000'000}, Duration{66'666'667}, 140);
  const auto ate = [&](const Trajectory& by) {
    return score::ScoreTrajectories(by, estimate, score::Alignment::kSe3).ape_translation.rmse;
  };
  EXPECT_GT(ate(truth), 1e-3);
  EXPECT_LT(ate(AddInterpolated(truth, estimate)), 1e-5);
}

TEST(DenseTruth, KeepsWhatIsKnownAndStaysInOrder) {
  const Trajectory truth = Circle(Time{}, Milliseconds(10), 4);
  // Before the truth, on one of its stamps, twice between two of them, after its end.
  Trajectory estimate;
  for (const std::int64_t ms : {-1, 10, 12, 17, 31})
    estimate.push_back({Time{} + Milliseconds(ms), {}});
  const Trajectory all = AddInterpolated(truth, estimate);
  ASSERT_EQ(all.size(), 6U);
  for (std::size_t i = 1; i < all.size(); ++i) EXPECT_LT(all[i - 1].t, all[i].t);
  for (const StampedPose& pose : truth) EXPECT_EQ(Interpolate(all, pose.t)->p(), pose.T_WI.p());
  EXPECT_EQ(all[2].t, Time{12'000'000});
  EXPECT_EQ(all[2].T_WI.p(), Interpolate(truth, Time{12'000'000})->p());
}

TEST(DenseTruth, AddsNothingInAGap) {
  const auto added = [](Duration step) {
    const Trajectory truth = Circle(Time{}, step, 3);
    return AddInterpolated(truth, Circle(Time{} + Milliseconds(1), step, 2)).size() - truth.size();
  };
  EXPECT_EQ(added(kDenseTruth), 2U);
  EXPECT_EQ(added(kDenseTruth + Duration{1}), 0U);
  EXPECT_TRUE(AddInterpolated({}, Circle(Time{}, Milliseconds(1), 2)).empty());
}

}  // namespace
}  // namespace drydock
