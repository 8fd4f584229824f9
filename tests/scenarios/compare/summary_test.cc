#include "scenarios/compare/summary.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenarios/compare/tables.h"

namespace drydock::compare {
namespace {

using ::testing::HasSubstr;

TEST(Summarize, TakesTheValuesThatExist) {
  const SeedValues values = {3.0, std::nullopt, -8.0, 1.0, 6.0};
  EXPECT_EQ(Summarize(Statistic::kMedian, values), 2.0);     // -8 1 3 6
  EXPECT_EQ(Summarize(Statistic::kMedianAbs, values), 4.5);  // 1 3 6 8
  EXPECT_EQ(Summarize(Statistic::kMean, values), 0.5);
  EXPECT_EQ(Summarize(Statistic::kMin, values), -8.0);
  EXPECT_EQ(Summarize(Statistic::kMax, values), 6.0);
  EXPECT_EQ(Summarize(Statistic::kMedian, {5.0, 7.0, 6.0}), 6.0);
  EXPECT_FALSE(Summarize(Statistic::kMedian, {std::nullopt}));
}

Finished WithAte(std::optional<double> ate) {
  Finished finished;
  finished.scorecard.metrics.ate_rmse_m = ate;
  finished.estimator_s = 0.6;
  finished.stereo_frames = 15;
  return finished;
}

/// Two seeds; of "weak" only the first gave a trajectory.
Comparison TwoEstimators() {
  Comparison comparison;
  comparison.suite.name = "pair";
  comparison.suite.summary = "Strong and weak";
  comparison.suite.cases = {{"V12", "bus.yaml", {}, {1, 2}}};
  comparison.suite.entrants = {PlainEntrant("strong"), PlainEntrant("weak")};
  for (const char* label : {"strong", "weak"}) {
    comparison.suite.criteria.push_back(
        {"V12", label, Statistic::kMedian, {"ate_rmse_m", std::nullopt, 0.5}});
  }
  comparison.cases = {
      {"V12", {1, 2}, {{WithAte(0.2), WithAte(0.4)}, {WithAte(0.1), WithAte(std::nullopt)}}}};
  comparison.criteria = JudgeAll(comparison.suite, comparison.cases);
  return comparison;
}

TEST(Comparison, ASeedWithoutTheMetricFailsTheCriterion) {
  const Comparison comparison = TwoEstimators();
  ASSERT_EQ(comparison.criteria.size(), 2U);
  EXPECT_TRUE(comparison.criteria[0].passed);
  EXPECT_NEAR(*comparison.criteria[0].actual, 0.3, 1e-12);
  EXPECT_FALSE(comparison.criteria[1].passed);
  EXPECT_FALSE(comparison.criteria[1].actual);
  EXPECT_FALSE(comparison.Passed());
  EXPECT_TRUE(Comparison().Passed());
}

TEST(Comparison, ReadsAsATable) {
  const Comparison comparison = TwoEstimators();
  const std::string text = ToMarkdown(comparison);
  EXPECT_THAT(text, HasSubstr("| estimator | ate_rmse_m                        |\n"
                              "|-----------|-----------------------------------|\n"
                              "| strong    | 0.3000 (0.2000 … 0.4000)          |\n"
                              "| weak      | 0.1000 (0.1000 … 0.1000) [1 of 2] |\n"));
  EXPECT_THAT(text,
              HasSubstr("| V12  | strong    | median ate_rmse_m | <= 0.5 | 0.3000 | met    |"));
  EXPECT_THAT(text,
              HasSubstr("| V12  | weak      | median ate_rmse_m | <= 0.5 | –      | MISSED |"));
  // 0.6 s for 15 frames.
  EXPECT_EQ(DescribeCosts(comparison), "strong 40.0 ms, weak 40.0 ms");
  EXPECT_THAT(ToJson(comparison), HasSubstr("\"verdict\": \"failed\""));
}

}  // namespace
}  // namespace drydock::compare
