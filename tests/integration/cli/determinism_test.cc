// The same scenario and seed give the same bytes; another seed does not.
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sensors_models/base/files.h"
#include "tests/integration/cli/drydock_program.h"
#include "tests/support/temporary_folder.h"

namespace drydock::testing {
namespace {

namespace fs = std::filesystem;

/// Every file below `folder` by its path from there.
std::map<std::string, std::string> FilesBelow(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file())
      files[fs::relative(entry.path(), folder).string()] = ReadFile(entry.path());
  }
  return files;
}

/// The names of the files that differ or that only one of both has.
std::vector<std::string> Differences(const std::map<std::string, std::string>& first,
                                     const std::map<std::string, std::string>& second) {
  std::vector<std::string> names;
  for (const auto& [name, content] : first) {
    const auto other = second.find(name);
    if (other == second.end() || other->second != content) names.push_back(name);
  }
  for (const auto& [name, content] : second) {
    if (!first.contains(name)) names.push_back(name);
  }
  return names;
}

class CliDeterminism : public ::testing::Test {
 protected:
  std::map<std::string, std::string> FilesOf(const std::vector<std::string>& command,
                                             const std::string& seed) const {
    std::vector<std::string> arguments = command;
    arguments.insert(arguments.end(), {BusScenario(), "--set", "duration_s=1", "--seed", seed});
    arguments.insert(arguments.end(), {"-o", "result"});
    const Outcome outcome = RunDrydock(folder_.path(), arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return FilesBelow(folder_.path() / "result");
  }

  const TemporaryFolder folder_;
};

TEST_F(CliDeterminism, RunRepeatsEveryByteButItsTimings) {
  const auto first = FilesOf({"run"}, "1");
  EXPECT_TRUE(first.contains("scorecard.json"));
  EXPECT_TRUE(first.contains("frames.png"));
  EXPECT_THAT(Differences(first, FilesOf({"run"}, "1")),
              ::testing::UnorderedElementsAre("timings.json"));
}

TEST_F(CliDeterminism, SimulateRepeatsEveryByteAndHeedsTheSeed) {
  const auto first = FilesOf({"simulate"}, "1");
  EXPECT_GT(first.size(), 40U);
  EXPECT_THAT(Differences(first, FilesOf({"simulate"}, "1")), ::testing::IsEmpty());
  const auto different = Differences(first, FilesOf({"simulate"}, "2"));
  for (const char* name :
       {"mav0/imu0/data.csv", "mav0/pressure0/data.csv", "mav0/cam0/data/1000000000.png",
        "mav0/state_groundtruth_estimate0/data.csv"}) {
    EXPECT_THAT(different, ::testing::Contains(name));
  }
  EXPECT_THAT(different, ::testing::Not(::testing::Contains("mav0/cam0/sensor.yaml")));
}

}  // namespace
}  // namespace drydock::testing
