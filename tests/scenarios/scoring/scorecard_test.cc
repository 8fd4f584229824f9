#include "scenarios/scoring/scorecard.h"

#include <limits>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "scenarios/scoring/json.h"
#include "sensors_models/base/check.h"
#include "tests/scenarios/scoring/support.h"
#include "tests/support/input_error.h"

namespace drydock::score {
namespace {

using drydock::testing::InputErrorOf;

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Json = nlohmann::ordered_json;

RunInfo BusRun() {
  RunInfo run;
  run.scenario = "bus";
  run.seed = 18'446'744'073'709'551'615ULL;
  run.estimator = "svin2";
  run.renderer = "osmesa";
  run.commit = "0123abc";
  run.config_hash = "ff00";
  return run;
}

std::vector<std::string> Keys(const Json& json) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : json.items()) keys.push_back(key);
  return keys;
}

TEST(Scorecard, JsonHasTheKeysOfTheContractInOrder) {
  const Json json = Json::parse(ToJson(Score(BusRun(), Helix(), Helix(), Helix(), {})));
  EXPECT_THAT(Keys(json), ElementsAre("schema", "scenario", "seed", "estimator", "renderer",
                                      "commit", "config_hash", "path_length_m", "duration_s",
                                      "metrics", "alignment", "criteria", "verdict"));
  EXPECT_THAT(
      Keys(json["metrics"]),
      ElementsAre("ate_rmse_m", "ate_odometry_rmse_m", "ate_to_odometry", "ate_percent",
                  "scale_error_percent", "rpe_5m_percent", "rpe_5m_deg_per_m",
                  "final_drift_percent", "yaw_error_deg", "z_rmse_m", "continuity_percent",
                  "init_time_s", "init_scale_error_percent", "false_starts", "anees_position",
                  "anees_orientation", "ate_after_fault_m", "recovery_time_s", "loops_found",
                  "loop_precision", "loop_recall", "sonar_map_rmse_m", "landmark_map_rmse_m"));
  EXPECT_EQ(json["schema"], 1);
  EXPECT_EQ(json["seed"], 18'446'744'073'709'551'615ULL);
  EXPECT_EQ(json["verdict"], "pass");
  EXPECT_EQ(json["alignment"]["method"], "se3");
  EXPECT_TRUE(json["metrics"]["loops_found"].is_null());
  EXPECT_TRUE(json["metrics"]["ate_after_fault_m"].is_null());
}

// A golden text of a case whose every figure is exact: byte for byte.
TEST(Scorecard, JsonIsTheSameBytes) {
  RunInfo run = BusRun();
  run.seed = 3;
  run.known.loops_found = 2.0;
  run.known.loop_recall = 0.1;
  const Scorecard card =
      Score(run, Helix(), {}, {}, {{"loops_found", 1.0, std::nullopt}, {"ate_rmse_m", {}, 0.3}});
  EXPECT_EQ(ToJson(card), R"({
  "schema": 1,
  "scenario": "bus",
  "seed": 3,
  "estimator": "svin2",
  "renderer": "osmesa",
  "commit": "0123abc",
  "config_hash": "ff00",
  "path_length_m": )" + Json(card.path_length_m).dump() +
                              R"(,
  "duration_s": 30.0,
  "metrics": {
    "ate_rmse_m": null,
    "ate_odometry_rmse_m": null,
    "ate_to_odometry": null,
    "ate_percent": null,
    "scale_error_percent": null,
    "rpe_5m_percent": null,
    "rpe_5m_deg_per_m": null,
    "final_drift_percent": null,
    "yaw_error_deg": null,
    "z_rmse_m": null,
    "continuity_percent": 0.0,
    "init_time_s": null,
    "init_scale_error_percent": null,
    "false_starts": null,
    "anees_position": null,
    "anees_orientation": null,
    "ate_after_fault_m": null,
    "recovery_time_s": null,
    "loops_found": 2.0,
    "loop_precision": null,
    "loop_recall": 0.1,
    "sonar_map_rmse_m": null,
    "landmark_map_rmse_m": null
  },
  "alignment": {
    "method": "se3",
    "scale": null,
    "rotation_xyzw": null,
    "translation_m": null
  },
  "criteria": [
    {
      "name": "loops_found",
      "actual": 2.0,
      "bound": {
        "min": 1.0
      },
      "unit": "",
      "passed": true
    },
    {
      "name": "ate_rmse_m",
      "actual": null,
      "bound": {
        "max": 0.3
      },
      "unit": "m",
      "passed": false
    }
  ],
  "verdict": "fail"
}
)");
}

TEST(Scorecard, FinalAndOdometryAreScoredApart) {
  Trajectory odometry = Helix();
  for (std::size_t i = 0; i < odometry.size(); ++i) {
    const Eigen::Vector3d off(0.0, i % 2 == 0 ? 0.5 : -0.5, 0.0);
    odometry[i].T_WI = Pose(odometry[i].T_WI.q(), odometry[i].T_WI.p() + off);
  }
  const Scorecard card = Score(BusRun(), Helix(), odometry, Helix(), {});
  EXPECT_NEAR(*card.metrics.ate_rmse_m, 0.0, 1e-12);
  EXPECT_NEAR(*card.metrics.ate_odometry_rmse_m, 0.5, 0.01);
  EXPECT_NEAR(*card.metrics.ate_to_odometry, 0.0, 1e-12);
  EXPECT_NEAR(*Score(BusRun(), Helix(), odometry, odometry, {}).metrics.ate_to_odometry, 1.0, 0.0);
  ASSERT_TRUE(card.alignment.has_value());
}

TEST(Scorecard, FaultMetrics) {
  RunInfo run = BusRun();
  run.last_fault_end = Time::FromSeconds(20.0);
  Trajectory odometry = Helix();
  // Nothing is published from 18 s to 22.5 s.
  std::erase_if(odometry, [](const StampedPose& pose) {
    return pose.t.Seconds() > 18.0 && pose.t.Seconds() < 22.45;
  });
  const Scorecard card = Score(run, Helix(), odometry, Helix(), {});
  EXPECT_NEAR(*card.metrics.recovery_time_s, 2.5, 1e-9);
  EXPECT_NEAR(*card.metrics.ate_after_fault_m, 0.0, 1e-12);
  EXPECT_NEAR(*card.metrics.continuity_percent, 100.0 * (1.0 - 4.5 / 30.0), 1e-9);
}

TEST(Scorecard, KnownFiguresStandAndNotANumberIsNone) {
  RunInfo run = BusRun();
  run.known.init_time_s = 4.5;
  run.known.anees_position = std::numeric_limits<double>::quiet_NaN();
  run.known.sonar_map_rmse_m = std::numeric_limits<double>::infinity();
  const Scorecard card = Score(run, Helix(), Helix(), Helix(), {});
  EXPECT_EQ(card.metrics.init_time_s, 4.5);
  EXPECT_FALSE(card.metrics.anees_position.has_value());
  EXPECT_FALSE(card.metrics.sonar_map_rmse_m.has_value());
}

TEST(Scorecard, NoEstimateFailsItsCriteriaAndIsNoError) {
  const Scorecard card = Score(BusRun(), Helix(), {}, {},
                               {{"ate_rmse_m", {}, 100.0}, {"continuity_percent", 0.0, {}}});
  EXPECT_EQ(card.metrics.continuity_percent, 0.0);
  EXPECT_FALSE(card.metrics.ate_rmse_m.has_value());
  EXPECT_FALSE(card.criteria[0].passed);
  EXPECT_TRUE(card.criteria[1].passed);
  EXPECT_FALSE(card.Passed());
}

TEST(Scorecard, EmptyTruthIsAnError) {
  EXPECT_THROW(Score(BusRun(), {}, Helix(), Helix(), {}), InputError);
}

TEST(Scorecard, TextThatIsNotUtf8DoesNotBreakTheJson) {
  RunInfo run = BusRun();
  run.scenario = "b\xffs \"quoted\"\n";
  EXPECT_TRUE(Json::accept(ToJson(Score(run, Helix(), {}, {}, {}))));
}

TEST(Judge, BoundsAreInclusive) {
  Metrics metrics;
  metrics.ate_rmse_m = 0.3;
  EXPECT_TRUE(Judge({"ate_rmse_m", {}, 0.3}, metrics).passed);
  EXPECT_TRUE(Judge({"ate_rmse_m", 0.3, {}}, metrics).passed);
  EXPECT_TRUE(Judge({"ate_rmse_m", 0.3, 0.3}, metrics).passed);
  EXPECT_FALSE(Judge({"ate_rmse_m", {}, 0.2999}, metrics).passed);
  EXPECT_FALSE(Judge({"ate_rmse_m", 0.3001, {}}, metrics).passed);
  EXPECT_FALSE(Judge({"z_rmse_m", {}, 1.0}, metrics).passed) << "a metric that is missing fails";
  EXPECT_EQ(Judge({"ate_rmse_m", {}, 0.3}, metrics).unit, "m");
}

TEST(Judge, RefusesCriteriaThatMakeNoSense) {
  const Metrics metrics;
  EXPECT_THROW(Judge({"ate", {}, 0.3}, metrics), InputError);
  EXPECT_THROW(Judge({"ate_rmse_m", {}, {}}, metrics), InputError);
  EXPECT_THROW(Judge({"ate_rmse_m", 2.0, 1.0}, metrics), InputError);
  EXPECT_THROW(Judge({"ate_rmse_m", {}, std::nan("")}, metrics), InputError);
}

std::string ReadCriterionMessage(const std::string& text) {
  return InputErrorOf([&] {
    ReadYaml(ParseYaml(text, "f.yaml"), [](YamlReader& yaml) { return ReadCriterion(yaml); });
  });
}

TEST(ReadCriterion, ReadsBoundsAndRefusesTheRest) {
  const Criterion criterion =
      ReadYaml(ParseYaml("metric: ate_rmse_m\nmin: 0.1\nmax: 0.5\n", "f.yaml"),
               [](YamlReader& yaml) { return ReadCriterion(yaml); });
  EXPECT_EQ(criterion.metric, "ate_rmse_m");
  EXPECT_EQ(criterion.min, 0.1);
  EXPECT_EQ(criterion.max, 0.5);
  EXPECT_THAT(ReadCriterionMessage("metric: ate\nmax: 1\n"),
              AllOf(HasSubstr("f.yaml:1"), HasSubstr("ate_rmse_m")));
  EXPECT_THAT(ReadCriterionMessage("metric: ate_rmse_m\n"), HasSubstr("'min', 'max'"));
  EXPECT_THAT(ReadCriterionMessage("metric: ate_rmse_m\nmin: 2\nmax: 1\n"), HasSubstr("f.yaml:2"));
  EXPECT_THAT(ReadCriterionMessage("metric: ate_rmse_m\nmaximum: 1\n"), HasSubstr("f.yaml"));
  EXPECT_THAT(ReadCriterionMessage("metric: ate_rmse_m\nmax: 1\nextra: 1\n"), HasSubstr("extra"));
}

TEST(Criterion, DescribesItsBound) {
  EXPECT_EQ(DescribeBound({"ate_rmse_m", {}, 0.3}), "<= 0.3");
  EXPECT_EQ(DescribeBound({"continuity_percent", 95.0, {}}), ">= 95");
  EXPECT_EQ(DescribeBound({"anees_position", 0.5, 2.0}), "from 0.5 to 2");
}

TEST(MetricTable, NamesAreUniqueAndEachHasItsOwnValue) {
  std::set<std::string_view> names;
  std::set<double> values;
  Metrics metrics;
  double next = 1.0;
  for (const MetricInfo& info : AllMetrics()) {
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    EXPECT_FALSE(info.description.empty());
    EXPECT_EQ(FindMetric(info.name), &info);
    EXPECT_FALSE((metrics.*info.value).has_value()) << info.name << " shares its value";
    metrics.*info.value = next++;
  }
  EXPECT_EQ(AllMetrics().size() * sizeof(std::optional<double>), sizeof(Metrics));
  EXPECT_EQ(FindMetric("nothing"), nullptr);
}

}  // namespace
}  // namespace drydock::score
