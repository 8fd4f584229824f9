// SVIn2 that comes back to a known place after blackness, over seeds: what docs/results/loops.md
// shows.
#include <algorithm>
#include <cstdio>
#include <string>
#include <tuple>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/integration/dark_trial.h"

namespace drydock {
namespace {

using testing::DarkTrial;

constexpr double kLight = 20.0;  // [s] The first place is in sight again.

double MedianOfThree(std::vector<double> values) {
  std::ranges::sort(values);
  return values.at(1);
}

/// By visibility [m] and length of the dark [s].
class Svin2LoopsFull : public ::testing::TestWithParam<std::tuple<int, double>> {};

TEST_P(Svin2LoopsFull, RelocaliseAfterBlackness) {
  const auto [visibility_m, dark_s] = GetParam();
  std::vector<double> waits, ates;
  for (const int seed : {31, 32, 33}) {
    const testing::RecordedDive dive = testing::Record(
        "bus_return.yaml",
        {fmt::format("water.visibility_m={}", visibility_m), fmt::format("seed={}", seed)});
    const DarkTrial trial =
        testing::RunInTheDark(dive, Time::FromSeconds(kLight - dark_s), Time::FromSeconds(kLight));
    std::printf("V = %d m, %.0f s of blackness, seed %d: %s\n", visibility_m, dark_s, seed,
                testing::Line(trial).c_str());
    std::fflush(stdout);
    EXPECT_EQ(trial.true_loops, trial.loops);
    ASSERT_TRUE(trial.corrected_s.has_value());
    waits.push_back(*trial.corrected_s);
    ates.push_back(trial.ate_percent);
  }
  EXPECT_LE(MedianOfThree(waits), 3.0);
  EXPECT_LE(MedianOfThree(ates), 0.3);
}

// In 17 s tracking is lost for good, and a new map begins.
INSTANTIATE_TEST_SUITE_P(All, Svin2LoopsFull,
                         ::testing::Combine(::testing::Values(12, 6),
                                            ::testing::Values(10.0, 17.0)));

}  // namespace
}  // namespace drydock
