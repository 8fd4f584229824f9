#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "estimator/registry/registry.h"
#include "scenarios/compare/plan.h"
#include "scenarios/compare/suite_yaml.h"
#include "sensors_models/base/check.h"
#include "sensors_models/base/files.h"
#include "sensors_models/base/resources.h"
#include "tests/support/temporary_folder.h"

namespace drydock::compare {
namespace {

using ::testing::ElementsAre;

std::string BusFile() { return DRYDOCK_SOURCE_DIR "/tests/data/dead_reckoning/bus.yaml"; }

const std::string kSuite = R"(summary: Two
seeds: [3, 4]
cases:
  - {name: clear, scenario: BUS, set: {water.visibility_m: 20}, duration_s: 2.5}
  - {name: murky, scenario: BUS, set: {water.visibility_m: 3, motion.speed_m_s: 0.3}, seeds: [9]}
estimators:
  - {label: plain, name: dead-reckoning}
  - {label: port moved, name: dead-reckoning, rig_set: {depth.position_m.0: -0.1}}
criteria:
  - {case: [clear, murky], estimator: plain, metric: z_rmse_m, max: 0.1}
  - {case: murky, estimator: port moved, metric: scale_error_percent, statistic: median_abs, max: 3}
)";

class SuiteTest : public ::testing::Test {
 protected:
  Suite Load() const {
    std::string text = kSuite;
    for (auto at = text.find("BUS"); at != std::string::npos; at = text.find("BUS"))
      text.replace(at, 3, BusFile());
    WriteFileAtomically(folder_.path() / "two.yaml", text);
    return LoadSuite(folder_.path() / "two.yaml");
  }

  const testing::TemporaryFolder folder_;
};

TEST_F(SuiteTest, IsReadWhole) {
  const Suite suite = Load();
  EXPECT_EQ(suite.name, "two");
  EXPECT_EQ(suite.summary, "Two");
  ASSERT_EQ(suite.cases.size(), 2U);
  EXPECT_THAT(suite.cases[0].seeds, ElementsAre(3, 4));
  EXPECT_THAT(suite.cases[1].seeds, ElementsAre(9));
  ASSERT_EQ(suite.entrants.size(), 2U);
  EXPECT_EQ(suite.entrants[1].label, "port moved");
  ASSERT_EQ(suite.criteria.size(), 3U);
  EXPECT_EQ(suite.criteria[0].case_name, "clear");
  EXPECT_EQ(suite.criteria[1].case_name, "murky");
  EXPECT_EQ(suite.criteria[2].statistic, Statistic::kMedianAbs);
  EXPECT_EQ(suite.criteria[2].criterion.max, 3.0);
}

TEST_F(SuiteTest, PlanHasAScenarioForEachEntrantOfEachCase) {
  const auto plan = MakePlan(Load(), {"seed=77", "water.daylight=0.5"});
  ASSERT_EQ(plan.size(), 2U);
  ASSERT_EQ(plan[0].scenarios.size(), 2U);
  const Scenario& clear = plan[0].scenarios[0];
  EXPECT_EQ(clear.name, "bus");
  EXPECT_EQ(clear.water.visibility_m, 20.0);
  EXPECT_EQ(clear.duration_s, 2.5);
  EXPECT_EQ(plan[1].scenarios[0].water.visibility_m, 3.0);
  EXPECT_EQ(plan[1].scenarios[0].motion.speed_m_s, 0.3);
  EXPECT_TRUE(clear.criteria.empty()) << "those of the suite count";
  for (const PlannedCase& planned : plan) {
    EXPECT_TRUE(planned.scenarios[0].estimator.rig_set.members.empty());
    EXPECT_EQ(planned.scenarios[1].estimator.rig_set.members.size(), 1U);
    EXPECT_TRUE(planned.scenarios[1].estimator.start_from_truth) << "as the scenario says";
  }
  const Scenario seeded = WithSeed(clear, 12);
  EXPECT_EQ(seeded.seed, 12U);
  EXPECT_EQ(seeded.resolved.Find("seed")->text, "12");
}

TEST(Suite, OfTheCommandLine) {
  const Suite suite = MakeSuite({BusFile()}, {"dead-reckoning"}, 5, 3);
  EXPECT_THAT(suite.cases.at(0).seeds, ElementsAre(5, 6, 7));
  EXPECT_EQ(suite.cases[0].name, "bus");
  EXPECT_EQ(suite.entrants.at(0).label, "dead-reckoning");
  EXPECT_NO_THROW(MakePlan(suite, {}));
  EXPECT_THROW(MakeSuite({BusFile()}, {"crystal-ball"}, 1, 1), InputError);
  EXPECT_THROW(MakeSuite({BusFile()}, {"dead-reckoning", "dead-reckoning"}, 1, 1), InputError);
  EXPECT_THROW(MakeSuite({BusFile(), BusFile()}, {"dead-reckoning"}, 1, 1), InputError);
}

bool IsRegistered(const Entrant& entrant) {
  const std::string& name = entrant.estimator.Find("name")->text;
  return std::any_of(Estimators().begin(), Estimators().end(),
                     [&](const EstimatorEntry& entry) { return entry.name == name; });
}

TEST(Suite, EveryShippedOneCanBeRead) {
  int count = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(DataDirectory() / "scenarios" / "suites")) {
    Suite suite;
    EXPECT_NO_THROW(suite = LoadSuite(entry.path())) << entry.path();
    // Estimators that this build does not have cannot be asked about their options.
    std::erase_if(suite.entrants, [](const Entrant& entrant) { return !IsRegistered(entrant); });
    EXPECT_NO_THROW(MakePlan(suite, {})) << entry.path();
    ++count;
  }
  EXPECT_GE(count, 2);
}

}  // namespace
}  // namespace drydock::compare
