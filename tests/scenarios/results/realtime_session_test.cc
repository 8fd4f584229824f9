// An estimator whose cost by the clock is known, on a dive of ten seconds.
#include <algorithm>
#include <memory>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenarios/results/estimator_session.h"

namespace drydock {
namespace {

/// Moves `clock` on by what a frame costs, and remembers what it was handed.
class Slow final : public Estimator {
 public:
  Slow(double frame_cost_s, double& clock, std::vector<Measurement>& seen)
      : frame_cost_s_(frame_cost_s), clock_(clock), seen_(seen) {}

  void Start(const std::optional<NavState>&) override {}
  void Add(const Measurement& measurement) override {
    seen_.push_back(measurement);
    if (!std::holds_alternative<StereoFrame>(measurement.reading)) return;
    clock_ += frame_cost_s_;
    estimate_.emplace().status = TrackingStatus::kTracking;
  }
  std::optional<NavEstimate> Latest() const override { return estimate_; }
  const Trajectory& Odometry() const override { return odometry_; }

 private:
  double frame_cost_s_;
  double& clock_;
  std::vector<Measurement>& seen_;
  std::optional<NavEstimate> estimate_;
  Trajectory odometry_;
};

struct Dive {
  std::vector<Measurement> arrived;
  std::vector<Measurement> seen;
  Results results;
  double seconds = 0.0;

  template <typename Reading>
  std::vector<Time> Seen() const {
    return TimesOf<Reading>(seen);
  }
  template <typename Reading>
  std::vector<Time> Arrived() const {
    return TimesOf<Reading>(arrived);
  }

 private:
  template <typename Reading>
  static std::vector<Time> TimesOf(const std::vector<Measurement>& measurements) {
    std::vector<Time> times;
    for (const Measurement& measurement : measurements)
      if (std::holds_alternative<Reading>(measurement.reading)) times.push_back(measurement.t);
    return times;
  }
};

constexpr Time kStart{1'600'000'000 * kNanosecondsPerSecond};

/// IMU at 100 Hz, 150 frames at 15 Hz, pings at 20 Hz and depth at 1 Hz, in the order of arrival.
std::vector<Measurement> TenSeconds() {
  std::vector<Measurement> dive;
  const auto add = [&](double rate_hz, const Reading& reading) {
    for (int k = 0; k < static_cast<int>(10 * rate_hz); ++k) {
      const Time t = SampleTime(kStart, k, rate_hz);
      dive.push_back({t, t, reading});
    }
  };
  add(100.0, ImuSample{});
  add(15.0, StereoFrame{});
  add(20.0, SonarPing{});
  add(1.0, DepthSample{});
  std::stable_sort(dive.begin(), dive.end(), [](const Measurement& a, const Measurement& b) {
    return a.t_arrival < b.t_arrival;
  });
  return dive;
}

Dive Swim(double frame_cost_s, const std::optional<RealtimeConfig>& realtime) {
  Dive dive{TenSeconds(), {}, {}, 0.0};
  double clock = 1e5;
  EstimatorSession session(std::make_unique<Slow>(frame_cost_s, clock, dive.seen), kStart, realtime,
                           [&clock] { return clock; });
  for (const Measurement& measurement : dive.arrived) session.Add(measurement);
  dive.results = session.Finish();
  dive.seconds = session.seconds();
  return dive;
}

// A frame begins every 0.1 s: 100 in ten seconds, and one waits at the end.
TEST(RealtimeSession, AFrameOf100MsGetsTwoThirdsOf15Hz) {
  const Dive dive = Swim(0.1, RealtimeConfig{});
  EXPECT_NEAR(static_cast<double>(dive.Seen<StereoFrame>().size()), 101.0, 1.0);
  ASSERT_TRUE(dive.results.realtime);
  EXPECT_EQ(dive.results.realtime->frames, 150);
  EXPECT_EQ(dive.results.realtime->drops.size(), 150 - dive.Seen<StereoFrame>().size());
  EXPECT_NEAR(dive.seconds, 0.1 * static_cast<double>(dive.Seen<StereoFrame>().size()), 1e-9);
  EXPECT_THAT(dive.results.events,
              ::testing::Contains(::testing::HasSubstr("stereo frames dropped within 1 s")));
}

TEST(RealtimeSession, AFrameOf130MsGetsEverySecondOne) {
  const Dive dive = Swim(0.13, RealtimeConfig{});
  EXPECT_NEAR(static_cast<double>(dive.Seen<StereoFrame>().size()), 77.0, 1.0);
}

// What comes behind the frame that waits, waits for two of them; with four, for five.
TEST(RealtimeSession, ALongerQueueWaitsLongerAndSeesNoMore) {
  const Dive newest = Swim(0.1, RealtimeConfig{});
  const Dive older = Swim(0.1, RealtimeConfig{4});
  EXPECT_LE(newest.results.realtime->longest_wait.Seconds(), 0.2);
  EXPECT_GT(older.results.realtime->longest_wait.Seconds(), 0.4);
  EXPECT_NEAR(static_cast<double>(older.Seen<StereoFrame>().size()),
              static_cast<double>(newest.Seen<StereoFrame>().size()), 4.0);
}

TEST(RealtimeSession, NothingElseIsLostAndAllIsInOrder) {
  const Dive dive = Swim(0.5, RealtimeConfig{});
  EXPECT_LT(dive.Seen<StereoFrame>().size(), 25U);
  EXPECT_EQ(dive.Seen<ImuSample>(), dive.Arrived<ImuSample>());
  EXPECT_EQ(dive.Seen<SonarPing>(), dive.Arrived<SonarPing>());
  EXPECT_EQ(dive.Seen<DepthSample>(), dive.Arrived<DepthSample>());
  EXPECT_TRUE(std::is_sorted(
      dive.seen.begin(), dive.seen.end(),
      [](const Measurement& a, const Measurement& b) { return a.t_arrival < b.t_arrival; }));
}

TEST(RealtimeSession, OneThatIsFastEnoughGetsEverything) {
  const Dive dive = Swim(0.06, RealtimeConfig{});
  EXPECT_EQ(dive.seen.size(), dive.arrived.size());
  EXPECT_TRUE(dive.results.realtime->drops.empty());
  EXPECT_LE(dive.results.realtime->longest_wait.Seconds(), 0.06);
}

// What an estimator says is known when it is done.
TEST(RealtimeSession, TheLogHasTheTimeThatTheEstimatorTook) {
  EXPECT_THAT(Swim(0.25, RealtimeConfig{}).results.events,
              ::testing::Contains("0.250 s: tracking, map 0"));
  EXPECT_THAT(Swim(0.25, std::nullopt).results.events,
              ::testing::Contains("0.000 s: tracking, map 0"));
}

TEST(RealtimeSession, LockStepLosesNothingHoweverSlow) {
  const Dive dive = Swim(10.0, std::nullopt);
  EXPECT_EQ(dive.seen.size(), dive.arrived.size());
  EXPECT_FALSE(dive.results.realtime);
}

}  // namespace
}  // namespace drydock
