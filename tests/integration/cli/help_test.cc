#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/integration/cli/drydock_program.h"
#include "tests/support/temporary_folder.h"

namespace drydock::testing {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;

#ifdef DRYDOCK_WITH_SIM
const std::vector<std::string> kCommands = {"run",      "simulate", "compare",
                                            "estimate", "score",    "list"};
#else
const std::vector<std::string> kCommands = {"estimate", "score", "list"};
#endif

TEST(CliHelp, ProgramNamesItsCommandsAndExitCodes) {
  const TemporaryFolder folder;
  const Outcome help = RunDrydock(folder.path(), {"--help"});
  EXPECT_EQ(help.exit_code, 0);
  for (const std::string& command : kCommands)
    EXPECT_THAT(help.out, ContainsRegex("\n  " + command + " +[A-Z]"));
  EXPECT_THAT(help.out, HasSubstr("0 all criteria met, 1 a criterion missed, 2 could not run"));
}

TEST(CliHelp, EveryCommandExplainsItself) {
  const TemporaryFolder folder;
  for (const std::string& command : kCommands) {
    const Outcome help = RunDrydock(folder.path(), {command, "--help"});
    EXPECT_EQ(help.exit_code, 0) << command;
    EXPECT_THAT(help.out, HasSubstr("Usage: ")) << command;
    EXPECT_THAT(help.out, HasSubstr(command)) << command;
    EXPECT_EQ(help.err, "") << command;
  }
}

TEST(CliHelp, WrongUseIsAnError) {
  const TemporaryFolder folder;
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{}, {"swim"}, {"score"}, {"estimate"}, {"list", "--frobnicate"}}) {
    const Outcome outcome = RunDrydock(folder.path(), arguments);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(outcome.err, HasSubstr("--help"));
  }
}

TEST(CliList, NamesWhatUsersMayWrite) {
  const TemporaryFolder folder;
  const Outcome list = RunDrydock(folder.path(), {"list"});
  EXPECT_EQ(list.exit_code, 0);
  EXPECT_EQ(list.err, "");
  EXPECT_THAT(list.out, ContainsRegex("Scenarios\n.*  bus +A school bus"));
  EXPECT_THAT(list.out, ContainsRegex("Suites\n.*  odometry_headline +[A-Z]"));
  EXPECT_THAT(list.out, ContainsRegex("Estimators\n.*  dead-reckoning +[A-Za-z]"));
  EXPECT_THAT(list.out, ContainsRegex("Metrics\n.*  ate_rmse_m +.*\\[m\\]"));
#ifdef DRYDOCK_WITH_SIM
  EXPECT_THAT(list.out, ContainsRegex("Scenes\n.*  bus +[A-Za-z]"));
#endif
}

}  // namespace
}  // namespace drydock::testing
