#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sensors_models/base/files.h"
#include "tests/integration/cli/drydock_program.h"
#include "tests/support/temporary_folder.h"

namespace drydock::testing {
namespace {

using ::testing::HasSubstr;

std::string OracleFile(const std::string& name) {
  return DRYDOCK_SOURCE_DIR "/tests/data/oracle/" + name;
}

class CliScore : public ::testing::Test {
 protected:
  Outcome Score(const std::vector<std::string>& arguments) const {
    std::vector<std::string> all = {"score"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return RunDrydock(folder_.path(), all);
  }

  const TemporaryFolder folder_;
};

// Golden values: evo 1.36, see tests/data/oracle/README.md.
TEST_F(CliScore, JsonHasTheFiguresOfTheOracle) {
  for (const std::string name : {"a", "b"}) {
    const auto golden = nlohmann::json::parse(ReadFile(OracleFile(name + ".json")));
    for (const std::string align : {"none", "origin", "se3", "sim3"}) {
      const Outcome outcome = Score({OracleFile("truth.tum"), OracleFile(name + "_estimate.tum"),
                                     "--json", "--align", align});
      ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
      const auto scored = nlohmann::json::parse(outcome.out);
      EXPECT_NEAR(scored["metrics"]["ate_rmse_m"], golden["ape_trans_" + align]["rmse"], 1e-9)
          << name << ", " << align;
    }
  }
}

TEST_F(CliScore, TextNamesTheMetrics) {
  const Outcome outcome = Score({OracleFile("truth.tum"), OracleFile("a_estimate.tum")});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.out, HasSubstr("1747 pairs, aligned by se3"));
  EXPECT_THAT(outcome.out, HasSubstr("ate_rmse_m                   0.1107 m"));
}

TEST_F(CliScore, WhatCannotBeReadIsNamed) {
  const Outcome missing = Score({OracleFile("truth.tum"), "none.tum"});
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_THAT(missing.err, HasSubstr("none.tum"));

  WriteFileAtomically(folder_.path() / "broken.tum", "0 0 0 0 0 0 0 1\n0.1 0 0 zero 0 0 0 1\n");
  const Outcome broken = Score({OracleFile("truth.tum"), "broken.tum"});
  EXPECT_EQ(broken.exit_code, 2);
  EXPECT_THAT(broken.err, HasSubstr("broken.tum:2"));
  EXPECT_EQ(broken.out, "");

  EXPECT_EQ(
      Score({OracleFile("truth.tum"), OracleFile("truth.tum"), "--align", "upside-down"}).exit_code,
      2);
}

}  // namespace
}  // namespace drydock::testing
