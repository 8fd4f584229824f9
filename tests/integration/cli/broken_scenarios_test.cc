// `drydock run` and `simulate` on scenarios that cannot be used.
#include "sensors_models/base/files.h"
#include "tests/integration/cli/broken_files.h"

namespace drydock::testing {
namespace {

constexpr const char* kScenario = R"(summary: A dive for tests
scene:
  name: bus
rig: svin2_v3
water:
  jerlov_type: III
  visibility_m: 12
sensors:
  stereo: {enabled: false}
motion:
  speed_m_s: 0.45
  waypoints:
    - {position_m: [0, 0, 0]}
    - {position_m: [2, 0, 0]}
estimator:
  name: dead-reckoning
  start_from_truth: true
seed: 1
duration_s: 1
criteria:
  - {metric: z_rmse_m, max: 1}
)";

class BrokenScenario : public BrokenFilesTest {
 protected:
  BrokenScenario() { WriteFileAtomically(inputs() / "dive.yaml", kScenario); }
};

TEST_P(BrokenScenario, IsRefused) { ExpectRefusal(GetParam()); }

Broken Dive(const char* name, How how, const std::string& says) {
  return {name,
          {"run", "@dive.yaml", "-o", "result"},
          "dive.yaml",
          std::move(how),
          {"@dive.yaml" + says}};
}

Broken Set(const char* name, const std::string& assignment, const std::string& says) {
  return {name, {"run", "@dive.yaml", "--set", assignment}, "", {}, {says}};
}

std::string Repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

/// Nine lists of nine aliases each: 10^9 values if followed.
std::string AliasBomb() {
  std::string text = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n";
  for (int i = 1; i < 9; ++i) {
    const std::string alias = "*a" + std::to_string(i - 1);
    text += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [" + alias +
            Repeated(", " + alias, 9) + "]\n";
  }
  return text;
}

std::string ManyKeys() {
  std::string text;
  for (int i = 0; i < 100'000; ++i) text += "k" + std::to_string(i) + ": 1\n";
  return text;
}

const Broken kSyntax[] = {
    Dive("OpenList", Edit("[2, 0, 0]", "[2, 0, 0"), ":14: "),
    Dive("Tab", Edit("  name: bus", "\tname: bus"), ":3: "),
    Dive("BadIndent", Edit("  visibility_m", " visibility_m"), ":7: "),
    Dive("NoColon", Edit("seed: 1", "seed 1"), ":19: "),
    Dive("OpenQuote", Edit("A dive for tests", "\"A dive"), ":"),
    Dive("DuplicateKey", Append("rig: svin2_v3\n"),
         ":22: the key 'rig' stands twice (first in line 4)"),
    Dive("DuplicateNestedKey", Edit("  visibility_m: 12", "  visibility_m: 12\n  visibility_m: 6"),
         ":8: the key 'visibility_m' stands twice (first in line 7)"),
    Dive("UnknownAlias", Edit("seed: 1", "seed: *one"), ":18: "),
    Dive("TwoDocuments", Append("---\nseed: 2\n"), ": holds more than one YAML document"),
    Dive("Empty", Whole(""), ": is empty, must be a mapping"),
    Dive("CommentsOnly", Whole("# to do\n"), ": is empty, must be a mapping"),
    Dive("AScalar", Whole("bus\n"), ": must be a mapping of keys to values"),
    Dive("BinaryGarbage", Whole(std::string("summary: x\n\0\x01\x02\xff", 15)),
         ":2: is not UTF-8 text"),
    Dive("Latin1", Edit("A dive for tests", "Ein Tauchgang f\xfcr Tests"), ":1: is not UTF-8 text"),
    Dive("Utf16", Utf16(), ":1: is not UTF-8 text"),
    Dive("DeepNesting", Append("x: " + Repeated("[", 100'000) + "\n"),
         ":24: nested deeper than 32"),
    Dive("NestedTooDeep", Append("x: " + Repeated("[", 60) + Repeated("]", 60) + "\n"),
         ":22: nested deeper than 32"),
    Dive("AliasBomb", Append(AliasBomb()), ":22: more than 200000 values"),
    Dive("ManyKeys", Whole(ManyKeys()), ":10001: a mapping of more than 10000 keys"),
    Dive("LargerThanAMegabyte", Append("# " + std::string(2'000'000, 'x')), ": larger than"),
    Dive("AFolder", Folder(), ": is a folder, must be a file"),
    Dive("Missing", Remove(), ": no such file"),
};

const Broken kValues[] = {
    Dive("UnknownKey", Append("currents: strong\n"), ":22: unknown key 'currents'; known here: "),
    Dive("UnknownNestedKey", Edit("  visibility_m: 12", "  visibility: 12"),
         ":7: unknown key 'water.visibility'; known here: "),
    Dive("MissingScene", Edit("scene:\n  name: bus\n", ""), ":1: the key 'scene' is missing"),
    Dive("MissingRig", Edit("rig: svin2_v3\n", ""), ":1: the key 'rig' is missing"),
    Dive("MissingPosition", Edit("{position_m: [2, 0, 0]}", "{pitch_deg: 3}"),
         ":14: the key 'motion.waypoints.1.position_m' is missing"),
    Dive("ListForNumber", Edit("seed: 1", "seed: [1]"),
         ":18: seed is a list, must be a whole number"),
    Dive("NumberForList", Edit("[2, 0, 0]", "2"),
         ":14: motion.waypoints.1.position_m is 2, must be a list of 3 numbers"),
    Dive("MapForList", Edit("  - {metric: z_rmse_m, max: 1}", "  metric: z_rmse_m"),
         ":20: criteria is a mapping, must be a list"),
    Dive("ScalarForMap", Edit("scene:\n  name: bus", "scene: bus"),
         ":2: scene is bus, must be a mapping"),
    Dive("TwoCoordinates", Edit("[2, 0, 0]", "[2, 0]"),
         ":14: motion.waypoints.1.position_m is a list, must be a list of 3 numbers"),
    Dive("YesForBoolean", Edit("start_from_truth: true", "start_from_truth: yes"),
         ":17: estimator.start_from_truth is yes, must be true or false"),
    Dive("QuotedNumber", Edit("visibility_m: 12", "visibility_m: \"12\""),
         ":7: water.visibility_m is \"12\", must be a number"),
    Dive("NumberWithUnit", Edit("visibility_m: 12", "visibility_m: 12 m"),
         ":7: water.visibility_m is 12 m, must be a number"),
    Dive("DecimalComma", Edit("speed_m_s: 0.45", "speed_m_s: 0,45"),
         ":11: motion.speed_m_s is 0,45, must be a number"),
    Dive("Nan", Edit("visibility_m: 12", "visibility_m: nan"),
         ":7: water.visibility_m is nan, must be a number from 0 to 100"),
    Dive("Infinity", Edit("duration_s: 1", "duration_s: .inf"),
         ":19: duration_s is .inf, must be a number from"),
    Dive("NegativeSpeed", Edit("speed_m_s: 0.45", "speed_m_s: -1"),
         ":11: motion.speed_m_s is -1, must be a number from 0.01 to 3"),
    Dive("EnormousNumber", Edit("duration_s: 1", "duration_s: 1e999"),
         ":19: duration_s is 1e999, must be a number"),
    Dive("EnormousSeed", Edit("seed: 1", "seed: 99999999999999999999"),
         ":18: seed is 99999999999999999999, must be a whole number"),
    Dive("LongNumber", Edit("seed: 1", "seed: " + std::string(100'000, '9')), ":18: seed is 99999"),
    Dive("EscapesForTheTerminal", Edit("III", "\"\\x1b[2J\""),
         ":6: water.jerlov_type is \"?[2J\", must be one of"),
    Dive("Nothing", Edit("rig: svin2_v3", "rig:"), ":4: rig is nothing, must be text"),
    Dive("UnknownScene", Edit("name: bus", "name: atlantis"),
         ":3: scene.name is atlantis, must be one of bus"),
    Dive("UnknownRig", Edit("svin2_v3", "trireme"), ":4: rig is trireme, must be one of "),
    Dive("MissingRigFile", Edit("svin2_v3", "nowhere/rig.yaml"),
         ":4: rig is nowhere/rig.yaml, must be a file that is there"),
    Dive("UnknownEstimatorRig", Edit("  start_from", "  rig: trireme\n  start_from"),
         ":17: estimator.rig is trireme, must be one of"),
    Dive("UnknownEstimator", Edit("dead-reckoning", "crystal-ball"),
         ":16: estimator.name is crystal-ball, must be one of dead-reckoning"),
    Dive("UnknownEstimatorOption", Edit("  start_from", "  options: {glow: 3}\n  start_from"),
         ":17: unknown key 'glow'; known here: none"),
    Dive("EstimatorOptionsAreAList", Edit("  start_from", "  options: [glow]\n  start_from"),
         ":17: estimator.options is a list, must be a mapping"),
    Dive("UnknownMetric", Edit("z_rmse_m", "beauty"),
         ":21: criteria.0.metric is beauty, must be one of ate_rmse_m"),
    Dive("CriterionWithoutBound", Edit(", max: 1", ""), ":21: the criterion on z_rmse_m needs"),
    Dive("CriterionUpsideDown", Edit("max: 1", "max: 1, min: 2"),
         ":21: criteria.0.min is 2, must be at most max"),
    Dive("UnknownJerlovType", Edit("III", "IV"), ":6: water.jerlov_type is IV, must be one of"),
    Dive("NoStart", Edit("start_from_truth: true", "start_from_truth: false"), ":17: "),
};

const Broken kPaths[] = {
    Dive("OneWaypoint", Edit("    - {position_m: [2, 0, 0]}\n", ""),
         ":12: motion.waypoints is a list, must be a list of 2 to 1000"),
    Dive("CoincidentWaypoints", Edit("[2, 0, 0]", "[0, 0, 0]"),
         ":14: motion.waypoints.1.position_m is a list, must be at least 0.01 m from"),
    Dive("WaypointFarAway", Edit("[2, 0, 0]", "[2e6, 0, 0]"),
         ":14: motion.waypoints.1.position_m.0 is 2e6, must be a number from -1000 to 1000"),
    Dive("LookAtItself", Edit("[2, 0, 0]", "[2, 0, 0], look_at_m: [2, 0, 1]"),
         ":14: motion.waypoints.1.look_at_m is a list, must be a point at least 0.1 m"),
    Dive("PathThroughTheBus", Edit("[2, 0, 0]", "[4.5, -3, 0]"),
         ":14: motion.waypoints.1, near this way-point: at "),
    {"SlowAndLong",
     {"run", "@dive.yaml", "--set", "motion.speed_m_s=0.01"},
     "dive.yaml",
     Edit("[2, 0, 0]", "[1000, 0, 0]"),
     {"@dive.yaml:14: motion.waypoints.1: the path takes ",
      " s at 0.01 m/s, must be at most 100000 s"}},
};

const Broken kBasesAndOptions[] = {
    Dive("BaseIsItself", Append("base: dive.yaml\n"), ": more than 8 files based on one another"),
    Dive("BaseMissing", Append("base: reef.yaml\n"),
         ":22: base is @reef.yaml, but there is no such file"),
    Dive("BaseIsAFolder", Append("base: .\n"), ":22: base is @., but there is no such file"),
    Dive("BaseIsAList", Append("base: [a]\n"), ":22: base must be a file's name"),
    Set("SetWithoutEquals", "seed", "--set seed: must be key.path=value"),
    Set("SetUnknownKey", "depth=3", "--set depth=3: unknown key 'depth'"),
    Set("SetUnknownPath", "currents.strength=3",
        "--set currents.strength=3: unknown key 'currents'"),
    Set("SetUnknownEstimatorOption", "estimator.options.lamps.glow=3",
        "--set estimator.options.lamps.glow=3: unknown key 'lamps'; known here: none"),
    Set("SetOutOfBounds", "water.visibility_m=-1",
        "--set water.visibility_m=-1: water.visibility_m is -1, must be"),
    Set("SetBrokenYaml", "seed=[1", "--set seed=[1: "),
    Set("SetBeyondAList", "criteria.7.max=1",
        "--set criteria.7.max=1: '7' leads nowhere at @dive.yaml:20"),
    {"UnknownRenderer",
     {"run", "@dive.yaml", "--renderer", "crayons"},
     "",
     {},
     {"renderer is crayons, must be one of auto, egl, osmesa"}},
    {"SeedIsText", {"run", "@dive.yaml", "--seed", "lucky"}, "", {}, {"--seed", "lucky"}},
    {"SimulateNeedsOutput", {"simulate", "@dive.yaml"}, "", {}, {"--output is required"}},
    {"SimulateToo",
     {"simulate", "@dive.yaml", "-o", "result"},
     "dive.yaml",
     Edit("III", "IV"),
     {"@dive.yaml:6: "}},
    {"OutputHoldsOtherThings", {"run", "@dive.yaml", "-o", "@"}, "", {}, {": holds other things"}},
    {"OutputIsAFile",
     {"run", "@dive.yaml", "-o", "@dive.yaml"},
     "",
     {},
     {"@dive.yaml: is a file, must be a folder"}},
};

INSTANTIATE_TEST_SUITE_P(Syntax, BrokenScenario, ::testing::ValuesIn(kSyntax), NameOf);
INSTANTIATE_TEST_SUITE_P(Values, BrokenScenario, ::testing::ValuesIn(kValues), NameOf);
INSTANTIATE_TEST_SUITE_P(Paths, BrokenScenario, ::testing::ValuesIn(kPaths), NameOf);
INSTANTIATE_TEST_SUITE_P(BasesAndOptions, BrokenScenario, ::testing::ValuesIn(kBasesAndOptions),
                         NameOf);

}  // namespace
}  // namespace drydock::testing
