#include "estimator/svin2/pose_graph/delayed_pose_graph.h"

#include <algorithm>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/estimator/svin2/pose_graph/synthetic_graph.h"

namespace drydock::svin2 {
namespace {

using testing::SyntheticDive;

/// Where all keyframes were thought to be after each keyframe, and whether a result was applied.
struct Course {
  std::vector<std::vector<Pose>> poses;
  std::vector<std::int64_t> applied_at;
};

Course CourseOf(int delay, Worker* worker) {
  SyntheticDive dive({});
  std::vector<PoseGraphEdge> loops = dive.TrueLoops(110, 200, 4);
  DelayedPoseGraphConfig config;
  config.delay_frames = delay;
  DelayedPoseGraph graph(config, worker);
  Course course;
  auto loop = loops.begin();
  for (std::int64_t k = 0; k < dive.size(); ++k) {
    std::vector<PoseGraphEdge> edges;
    if (k > 0) edges.push_back(dive.Step(k));
    if (loop != loops.end() && loop->to == k) edges.push_back(*loop++);
    if (graph.AddKeyframe(dive.Node(k), edges)) course.applied_at.push_back(k);
    course.poses.push_back(graph.graph().T_GI());
  }
  graph.Finish();
  course.poses.push_back(graph.graph().T_GI());
  return course;
}

void ExpectSame(const Course& a, const Course& b) {
  EXPECT_EQ(a.applied_at, b.applied_at);
  ASSERT_EQ(a.poses.size(), b.poses.size());
  for (std::size_t n = 0; n < a.poses.size(); ++n) {
    ASSERT_EQ(a.poses[n].size(), b.poses[n].size());
    for (std::size_t k = 0; k < a.poses[n].size(); ++k) {
      ASSERT_EQ(a.poses[n][k].p(), b.poses[n][k].p()) << n << " " << k;
      ASSERT_EQ(a.poses[n][k].q().coeffs(), b.poses[n][k].q().coeffs()) << n << " " << k;
    }
  }
}

TEST(DelayedPoseGraph, AWorkerChangesNothing) {
  for (const int delay : {0, 1, 5}) {
    Worker worker;
    ExpectSame(CourseOf(delay, nullptr), CourseOf(delay, &worker));
  }
}

TEST(DelayedPoseGraph, ResultsComeWhenTheyAreDue) {
  // Loops at 110, 114, ...: begun there, taken 5 later, when the next begins at once.
  const Course late = CourseOf(5, nullptr);
  ASSERT_GE(late.applied_at.size(), 3U);
  EXPECT_EQ(late.applied_at[0], 115);
  EXPECT_EQ(late.applied_at[1], 120);
  EXPECT_EQ(late.applied_at[2], 125);
  const Course at_once = CourseOf(0, nullptr);
  EXPECT_EQ(at_once.applied_at[0], 110);
  EXPECT_EQ(at_once.applied_at[1], 114);
}

TEST(DelayedPoseGraph, FinishUsesAllThereIs) {
  // Whatever was under way: the end is that of the whole graph.
  const auto late = CourseOf(5, nullptr).poses.back(), at_once = CourseOf(0, nullptr).poses.back();
  for (std::size_t k = 0; k < late.size(); ++k)
    EXPECT_LT(late[k].BoxMinus(at_once[k]).norm(), 1e-4) << k;
}

TEST(DelayedPoseGraph, GlimpsesFindLoopsAtOnce) {
  SyntheticDive dive({});
  DelayedPoseGraphConfig config;
  config.delay_frames = 2;
  DelayedPoseGraph graph(config, nullptr);
  std::vector<std::int64_t> applied_at;
  for (std::int64_t k = 0; k < 130; ++k) {
    const std::vector<PoseGraphEdge> edges(k > 0 ? 1 : 0, dive.Step(k));
    if (graph.AddKeyframe(dive.Node(k), edges)) applied_at.push_back(k);
    if (k == 120) {
      EXPECT_FALSE(graph.AddGlimpse(dive.TrueLoop(15, 115)));
    }
  }
  EXPECT_EQ(applied_at, std::vector<std::int64_t>{122});
  // They count as frames, too, where keyframes are rare.
  EXPECT_FALSE(graph.AddGlimpse(dive.TrueLoop(16, 116)));
  EXPECT_FALSE(graph.AddGlimpse(std::nullopt));
  EXPECT_TRUE(graph.AddGlimpse(std::nullopt));
  ASSERT_TRUE(graph.report().has_value());
  EXPECT_TRUE(graph.report()->converged);
}

TEST(DelayedPoseGraph, MayBeGivenUpUnderWay) {
  SyntheticDive dive({});
  Worker worker;
  DelayedPoseGraph graph({}, &worker);
  for (std::int64_t k = 0; k < 120; ++k) {
    std::vector<PoseGraphEdge> edges(k > 0 ? 1 : 0, dive.Step(k));
    if (k == 119) edges.push_back(dive.TrueLoop(19, 119));
    graph.AddKeyframe(dive.Node(k), edges);
  }
}

TEST(DelayedPoseGraph, RefusesANegativeDelay) {
  DelayedPoseGraphConfig config;
  config.delay_frames = -1;
  EXPECT_THROW(DelayedPoseGraph(config, nullptr), std::logic_error);
}

}  // namespace
}  // namespace drydock::svin2
