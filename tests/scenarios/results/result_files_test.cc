#include "scenarios/results/result_files.h"

#include <gtest/gtest.h>

#include "scenarios/dataset/tum.h"
#include "sensors_models/base/files.h"
#include "tests/support/temporary_folder.h"

namespace drydock {
namespace {

// The offset basis and the values for "a" and "foobar" stand in the description of FNV-1a by
// Fowler, Noll and Vo.
TEST(HashText, IsFnv1a) {
  EXPECT_EQ(HashText(""), "cbf29ce484222325");
  EXPECT_EQ(HashText("a"), "af63dc4c8601ec8c");
  EXPECT_EQ(HashText("foobar"), "85944171f73967e8");
}

TEST(ResultFiles, WritesWhatTheEstimatorSaid) {
  const testing::TemporaryFolder folder;
  Results results;
  results.odometry = {{Time{1}, Pose()}, {Time{2}, Pose()}};
  results.corrected = {{Time{1}, Pose()}};
  results.loops = {{Time{9}, Time{4}, Pose(Eigen::Quaterniond::Identity(), {1.0, -2.0, 0.5})}};
  results.events = {"one", "two"};
  WriteResults(folder.path(), results);
  EXPECT_EQ(dataset::ReadTum(folder.path() / "odometry.tum").size(), 2U);
  EXPECT_EQ(dataset::ReadTum(folder.path() / "trajectory.tum").size(), 1U);
  EXPECT_EQ(ReadFile(folder.path() / "events.log"), "one\ntwo\n");
  EXPECT_TRUE(ReadFile(folder.path() / "loops.csv").ends_with("]\n9,4,1,-2,0.5,1,0,0,0\n"));
}

}  // namespace
}  // namespace drydock
