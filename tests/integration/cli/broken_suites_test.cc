// `drydock compare` on suites and options that cannot be used.
#include "sensors_models/base/files.h"
#include "tests/integration/cli/broken_files.h"

namespace drydock::testing {
namespace {

constexpr const char* kSuite = R"(summary: A suite for tests
seeds: [1, 2]
cases:
  - {name: clear, scenario: dive.yaml, set: {water.visibility_m: 12}}
  - {name: murky, scenario: dive.yaml, set: {water.visibility_m: 3}, duration_s: 1}
estimators:
  - {label: plain, name: dead-reckoning}
  - {label: other, name: dead-reckoning, start_from_truth: true}
criteria:
  - {case: clear, estimator: plain, metric: z_rmse_m, max: 1}
)";

class BrokenSuite : public BrokenFilesTest {
 protected:
  BrokenSuite() {
    WriteFileAtomically(inputs() / "suite.yaml", kSuite);
    WriteFileAtomically(inputs() / "dive.yaml",
                        "base: " + BusScenario() + "\nestimator: {start_from_truth: true}\n");
  }
};

TEST_P(BrokenSuite, IsRefused) { ExpectRefusal(GetParam()); }

Broken Suite(const char* name, How how, const std::string& says) {
  return {name,
          {"compare", "--suite", "@suite.yaml", "-o", "result"},
          "suite.yaml",
          std::move(how),
          {"@suite.yaml" + says}};
}

Broken Options(const char* name, std::vector<std::string> options, const char* says) {
  options.insert(options.begin(), "compare");
  return {name, std::move(options), "", {}, {says}};
}

const Broken kSuites[] = {
    Suite("Missing", Remove(), ": no such file"),
    Suite("UnknownKey", Append("colour: red\n"), ":11: unknown key 'colour'; known here: "),
    Suite("NoSummary", Edit("summary: A suite for tests\n", ""),
          ":1: the key 'summary' is missing"),
    Suite("NoCases", Edit("cases:", "cases: []\nbags:"), ":3: cases is a list, must be a list of"),
    Suite("NoSeeds", Edit("seeds: [1, 2]\n", ""), ":3: case clear has no seeds, nor has the suite"),
    Suite("EmptySeeds", Edit("[1, 2]", "[]"), ":2: seeds is a list, must be a list of at least"),
    Suite("SeedTwice", Edit("[1, 2]", "[2, 2]"),
          ":2: seeds is a list, must be a list of different numbers; 2 stands twice"),
    Suite("HalfASeed", Edit("[1, 2]", "[1.5]"), ":2: seeds is a list, must be a list of whole"),
    Suite("CaseTwice", Edit("murky", "clear"),
          ":5: cases.1.name is clear, must be a name that does not stand twice"),
    Suite("CaseWithoutScenario", Edit("scenario: dive.yaml, ", ""),
          ":4: the key 'cases.0.scenario' is missing"),
    Suite("NoSuchScenario", Edit("dive.yaml", "reef.yaml"),
          ":4: cases.0.scenario is reef.yaml, must be"),
    Suite("UnknownCaseKey", Edit("duration_s: 1", "length_s: 1"),
          ":5: unknown key 'cases.1.length_s'"),
    Suite("SetIsAList", Edit("{water.visibility_m: 12}", "[water]"),
          ":4: cases.0.set is a list, must be a mapping"),
    Suite("SetOutOfBounds", Edit("water.visibility_m: 12", "water.visibility_m: -12"),
          ":4: water.visibility_m is -12, must be"),
    Suite("SetUnknownKey", Edit("water.visibility_m: 3", "water.saltiness: 3"),
          ":5: unknown key 'water.saltiness'"),
    Suite("SetLeadsNowhere", Edit("water.visibility_m: 3", "criteria.9.max: 3"),
          ":5: '9' leads nowhere at "),
    Suite("DurationIsText", Edit("duration_s: 1", "duration_s: long"), ":5: duration_s is long"),
    Suite("UnknownEstimator", Edit("name: dead-reckoning", "name: crystal-ball"),
          ":7: estimator.name is crystal-ball, must be one of"),
    Suite("EstimatorWithoutName", Edit(", name: dead-reckoning", ""),
          ":7: the key 'estimators.0.name' is missing"),
    Suite("LabelTwice", Edit("other", "plain"),
          ":8: estimators.1.label is plain, must be a name that"),
    Suite("UnknownOption", Edit("start_from_truth: true", "options: {lamps.glow: 3}"),
          ":8: unknown key 'lamps'; known here: none"),
    Suite("UnknownRig", Edit("start_from_truth: true", "rig: trireme"),
          ":8: estimator.rig is trireme, must be one of"),
    Suite("RigSetUnknownKey", Edit("start_from_truth: true", "rig_set: {sails: 3}"),
          ":8: unknown key 'sails'"),
    Suite("CannotStart", Edit("start_from_truth: true", "start_from_truth: false"),
          ":8: estimator.start_from_truth is false: dead-reckoning has to be told"),
    Suite("CriterionOnNoCase", Edit("case: clear", "case: V1"),
          ":10: criteria.0.case is V1, must be one or a list of clear, murky"),
    Suite("CriterionOnNoEstimator", Edit("estimator: plain", "estimator: [plain, vain]"),
          ":10: criteria.0.estimator is a list, must be one or a list of plain, other"),
    Suite("CriterionOnNoMetric", Edit("z_rmse_m", "beauty"), ":10: criteria.0.metric is beauty"),
    Suite("UnknownStatistic", Edit("max: 1}", "statistic: mode, max: 1}"),
          ":10: criteria.0.statistic is mode, must be one of median, median_abs, mean, min, max"),
};

const Broken kOptions[] = {
    Options("Nothing", {}, "compare needs scenario files or --suite"),
    Options("NoEstimators", {"@dive.yaml"}, "compare needs --estimators or --suite"),
    Options("UnknownEstimator", {"@dive.yaml", "--estimators", "dead-reckoning,crystal-ball"},
            "estimator is crystal-ball, must be one of dead-reckoning"),
    Options("EstimatorTwice", {"@dive.yaml", "--estimators", "dead-reckoning,dead-reckoning"},
            "estimator dead-reckoning is named twice"),
    Options("NoSeeds", {"@dive.yaml", "--estimators", "dead-reckoning", "--seeds", "0"}, "--seeds"),
    Options("SuiteAndScenario", {"@dive.yaml", "--suite", "@suite.yaml"}, "--suite"),
    Options("BadSet", {"--suite", "@suite.yaml", "--set", "seed=lucky"},
            "--set seed=lucky: seed is lucky"),
    Options("OutputHoldsOtherThings", {"--suite", "@suite.yaml", "-o", "@"},
            ": holds other things"),
};

INSTANTIATE_TEST_SUITE_P(Suites, BrokenSuite, ::testing::ValuesIn(kSuites), NameOf);
INSTANTIATE_TEST_SUITE_P(Options, BrokenSuite, ::testing::ValuesIn(kOptions), NameOf);

}  // namespace
}  // namespace drydock::testing
