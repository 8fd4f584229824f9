// SVIn2 started at random in the first minute of the bus dive, in clear and murky water: what
// docs/results/starts.md shows.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/integration/start_trial.h"

namespace drydock {
namespace {

using testing::StartTrial;

constexpr int kStarts = 20;
constexpr double kDive = 60.0;          // [s]
constexpr double kLongestTrial = 10.0;  // [s] Where there is enough to see at once.

double WorstScale(const std::vector<StartTrial>& trials) {
  double worst = 0.0;
  for (const StartTrial& trial : trials)
    worst = std::max(worst, std::abs(trial.scale_error_percent.value_or(0.0)));
  return worst;
}

/// The row of one dive.
std::string Row(int visibility_m, int seed, const std::vector<StartTrial>& trials) {
  std::vector<double> waits;
  int judged = 0, false_starts = 0;
  for (const StartTrial& trial : trials) {
    if (trial.wait_s) waits.push_back(*trial.wait_s);
    judged += trial.scale_error_percent.has_value();
    false_starts += trial.false_starts;
  }
  std::sort(waits.begin(), waits.end());
  return fmt::format("| {} m | {} | {} of {} | {:.2f} / {:.2f} | {} | {:.2f} | {} |", visibility_m,
                     seed, waits.size(), trials.size(),
                     waits.empty() ? NAN : waits[waits.size() / 2],
                     waits.empty() ? NAN : waits.back(), judged, WorstScale(trials), false_starts);
}

class Svin2StartsFull : public ::testing::TestWithParam<int> {};

TEST_P(Svin2StartsFull, ScaleIsWithinTwoPercentAndNoStartIsFalse) {
  for (const int seed : {1, 2, 3}) {
    const testing::RecordedDive dive = testing::RecordBus(
        {fmt::format("duration_s={}", kDive), fmt::format("water.visibility_m={}", GetParam()),
         fmt::format("seed={}", seed)});
    const auto trials = testing::StartAtRandom(dive, fmt::format("dive {}", seed), kStarts, 0.0,
                                               kDive - kLongestTrial);
    for (const StartTrial& trial : trials) std::printf("%s\n", testing::Line(trial).c_str());
    std::printf("%s\n", Row(GetParam(), seed, trials).c_str());
    std::fflush(stdout);
    EXPECT_GE(
        std::ranges::count_if(trials, [](const StartTrial& t) { return t.wait_s.has_value(); }),
        kStarts / 2);
    for (const StartTrial& trial : trials) {
      EXPECT_EQ(trial.false_starts, 0) << testing::Line(trial);
      if (trial.wait_s) {
        EXPECT_LT(std::abs(trial.scale_error_percent.value_or(99.0)), 2.0) << testing::Line(trial);
      }
      // In murky water some of them look at nothing but water.
      if (GetParam() == 12) {
        EXPECT_LT(trial.wait_s.value_or(99.0), 3.0) << testing::Line(trial);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(AtVisibility, Svin2StartsFull, ::testing::Values(12, 6));

}  // namespace
}  // namespace drydock
