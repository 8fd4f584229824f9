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

TEST(KnownMetrics, JudgeTheLoops) {
  Trajectory truth;  // 1 m/s along x.
  for (int i = 0; i <= 50; ++i)
    truth.push_back({Time::FromSeconds(i), Pose(Eigen::Quaterniond::Identity(), {1.0 * i, 0, 0})});
  Results results;
  const auto loop = [](double x) {
    return LoopClosure{Time::FromSeconds(30), Time::FromSeconds(5),
                       Pose(Eigen::Quaterniond::Identity(), {x, 0.0, 0.0})};
  };
  results.loops = {loop(25.0), loop(3.0)};
  const score::Metrics metrics = KnownMetrics(truth, results);
  EXPECT_EQ(metrics.loops_found, 2.0);
  EXPECT_EQ(metrics.loop_precision, 50.0);
  EXPECT_FALSE(metrics.loop_recall);
}

}  // namespace
}  // namespace drydock
