// SVIn2 starts by itself, wherever in a dive it is switched on; and where there is nothing to see
// it does not. One dive for all tests that see something: they run in one process.
#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "estimator/registry/registry.h"
#include "tests/integration/start_trial.h"

namespace drydock {
namespace {

using testing::RecordedDive;
using testing::StartTrial;

constexpr double kRestEnds = 2.5;       // [s]
constexpr double kSwimsFrom = 3.5;      // [s] By then it has gone 5 cm.
constexpr double kPitchesFrom = 9.0;    // [s]
constexpr double kPitchesUntil = 18.0;  // [s]
constexpr double kLongestTrial = 6.7;   // [s] Of a body that swims.

/// A body rests, swims along the bus, then nods by 24 degrees each 1.1 s.
RecordedDive RecordDive() {
  return testing::RecordBus({"duration_s=18",
                             "motion={rest_s: 2.5, sway: {position_m: 0.02, angle_deg: 1.5}}",
                             "motion.waypoints=["
                             "{position_m: [0, 0, 0], yaw_offset_deg: -30, pitch_deg: 5},"
                             "{position_m: [1, 0, 0], yaw_offset_deg: -30, pitch_deg: 5},"
                             "{position_m: [2, 0, 0], yaw_offset_deg: -30, pitch_deg: 5},"
                             "{position_m: [2.5, 0, 0], yaw_offset_deg: -30, pitch_deg: 17},"
                             "{position_m: [3, 0, 0], yaw_offset_deg: -30, pitch_deg: -7},"
                             "{position_m: [3.5, 0, 0], yaw_offset_deg: -30, pitch_deg: 17},"
                             "{position_m: [4, 0, 0], yaw_offset_deg: -30, pitch_deg: -7},"
                             "{position_m: [4.5, 0, 0], yaw_offset_deg: -30, pitch_deg: 17},"
                             "{position_m: [5, 0, 0], yaw_offset_deg: -30, pitch_deg: -7},"
                             "{position_m: [5.5, 0, 0], yaw_offset_deg: -30, pitch_deg: 17},"
                             "{position_m: [6.5, 0, 0], yaw_offset_deg: -30, pitch_deg: 5}]"});
}

class Svin2Starts : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { dive_ = std::make_unique<RecordedDive>(RecordDive()); }
  static void TearDownTestSuite() { dive_.reset(); }

  static std::vector<StartTrial> Try(const char* stream, int count, double from_s, double to_s) {
    std::vector<StartTrial> trials = testing::StartAtRandom(*dive_, stream, count, from_s, to_s);
    for (const StartTrial& trial : trials) {
      const std::string line = testing::Line(trial);
      std::printf("%s\n", line.c_str());
      EXPECT_LT(trial.wait_s.value_or(99.0), 2.5) << line;
      EXPECT_LT(std::abs(trial.scale_error_percent.value_or(99.0)), 2.0) << line;
      EXPECT_EQ(trial.false_starts, 0) << line;
    }
    return trials;
  }

 private:
  static inline std::unique_ptr<RecordedDive> dive_;
};

TEST_F(Svin2Starts, SevenTimesFromRest) {
  // The shortest wait is a second: each of these starts before the body does.
  for (const StartTrial& trial : Try("still", 7, 0.0, kRestEnds - 1.2))
    EXPECT_TRUE(trial.FromRest()) << testing::Line(trial);
}

TEST_F(Svin2Starts, SevenTimesWhileSwimming) {
  for (const StartTrial& trial : Try("swimming", 7, kSwimsFrom, kPitchesFrom - 1.0))
    EXPECT_FALSE(trial.FromRest()) << testing::Line(trial);
}

TEST_F(Svin2Starts, SixTimesWhilePitching) {
  Try("pitching", 6, kPitchesFrom, kPitchesUntil - kLongestTrial);
}

/// Away from the bus and upwards, where the water is all there is.
TEST(Svin2InBlueWater, DoesNotStart) {
  const RecordedDive dive = testing::RecordBus(
      {"duration_s=20", "water.visibility_m=6",
       "motion.waypoints=[{position_m: [0, 2, 0.5], yaw_offset_deg: 10, pitch_deg: -40},"
       "{position_m: [1, 5, 1], yaw_offset_deg: -20, pitch_deg: -45},"
       "{position_m: [-2, 12, 1.5], yaw_offset_deg: 0, pitch_deg: -35}]"});
  const auto estimator = FindEstimator("svin2-noloop").make(dive.rig, NoOptions());
  estimator->Start(std::nullopt);
  for (const Measurement& measurement : dive.measurements) {
    estimator->Add(measurement);
    ASSERT_FALSE(estimator->Latest().has_value())
        << "at " << measurement.t.Seconds() << " s: " << estimator->TakeEvents().front().message;
  }
  EXPECT_GT(dive.measurements.back().t, Time::FromSeconds(19.9));
}

}  // namespace
}  // namespace drydock
