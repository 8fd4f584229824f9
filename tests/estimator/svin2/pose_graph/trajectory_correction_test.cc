#include "estimator/svin2/pose_graph/trajectory_correction.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "tests/estimator/svin2/pose_graph/synthetic_graph.h"

namespace drydock::svin2 {
namespace {

using Eigen::Vector3d;

constexpr std::int64_t kTenth = kNanosecondsPerSecond / 10;

Pose At(double x) { return {Eigen::Quaterniond::Identity(), {x, 0, 0}}; }

/// Keyframes at 0, 1, 2 s, 1 m apart, corrected as `corrections` say.
PoseGraph Graph(const std::vector<Pose>& corrections) {
  PoseGraph graph;
  PoseGraphResult result;
  for (std::size_t k = 0; k < corrections.size(); ++k) {
    PoseGraphNode node;
    node.index = static_cast<std::int64_t>(k);
    node.t = Time{node.index * kNanosecondsPerSecond};
    node.T_WI = At(static_cast<double>(k));
    graph.AddNode(node);
    result.T_GI.push_back(corrections[k] * node.T_WI);
  }
  graph.Apply(result);
  return graph;
}

/// Frames each tenth of a second, from -0.5 to 2.5 s, on the same line.
Trajectory Odometry() {
  Trajectory odometry;
  for (std::int64_t k = -5; k <= 25; ++k)
    odometry.push_back({Time{k * kTenth}, At(0.1 * static_cast<double>(k))});
  return odometry;
}

TEST(TrajectoryCorrection, OneCorrectionMovesAllAlike) {
  const Pose T_GW(FromYawPitchRoll(1.0, 0.2, 0.1), {100, -50, 3});
  const Trajectory odometry = Odometry(),
                   corrected = Corrected(Graph({T_GW, T_GW, T_GW}), odometry);
  ASSERT_EQ(corrected.size(), odometry.size());
  for (std::size_t k = 0; k < odometry.size(); ++k) {
    EXPECT_EQ(corrected[k].t, odometry[k].t);
    EXPECT_LT(corrected[k].T_WI.BoxMinus(T_GW * odometry[k].T_WI).norm(), 1e-12);
  }
}

TEST(TrajectoryCorrection, GoesEvenlyFromKeyframeToKeyframe) {
  const Trajectory corrected =
      Corrected(Graph({At(0), Pose(Eigen::Quaterniond::Identity(), {0, 1, 0}), At(0)}), Odometry());
  for (std::size_t k = 0; k < corrected.size(); ++k) {
    const double t = corrected[k].t.Seconds();
    const double expected = t < 0 ? 0 : t < 1 ? t : t < 2 ? 2 - t : 0;
    EXPECT_NEAR(corrected[k].T_WI.p().y(), expected, 1e-12) << t;
    EXPECT_NEAR(corrected[k].T_WI.p().x(), t, 1e-12);
  }
}

// Blind from 0.5 to 1 s: that is where it drifted.
TEST(TrajectoryCorrection, GrowsAsOdometryDoubtsItself) {
  const Trajectory odometry = Odometry();
  std::vector<double> sigmas(odometry.size(), 0.01);
  for (std::size_t k = 0; k < odometry.size(); ++k)
    sigmas[k] += std::clamp(2.0 * (odometry[k].t.Seconds() - 0.5), 0.0, 1.0);
  const Trajectory corrected = Corrected(Graph({At(0), At(1), At(1)}), odometry, sigmas);
  for (const StampedPose& pose : corrected) {
    const double t = pose.t.Seconds();
    EXPECT_NEAR(pose.T_WI.p().x(), t + std::clamp(2.0 * (t - 0.5), 0.0, 1.0), 1e-5) << t;
  }
}

TEST(TrajectoryCorrection, HitsEveryKeyframe) {
  const std::vector<Pose> corrections = {Pose(FromYawPitchRoll(0.1, 0, 0), {1, 0, 0}),
                                         Pose(FromYawPitchRoll(0.5, 0.1, 0), {1, 2, 0}),
                                         Pose(FromYawPitchRoll(-0.3, 0, 0.2), {0, 0, 3})};
  const PoseGraph graph = Graph(corrections);
  const Trajectory corrected = Corrected(graph, Odometry());
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_LT(corrected[5 + 10 * k].T_WI.BoxMinus(graph.T_GI()[k]).norm(), 1e-12);
  // Constant before the first and after the last.
  EXPECT_LT(corrected[0].T_WI.BoxMinus(corrections[0] * At(-0.5)).norm(), 1e-12);
  EXPECT_LT(corrected[30].T_WI.BoxMinus(corrections[2] * At(2.5)).norm(), 1e-12);
}

TEST(TrajectoryCorrection, DoesNotHangOnWhereTheOriginIs) {
  // A dive far from the origin, corrected by the same motions of the body.
  const std::vector<Pose> corrections = {At(0), Pose(FromYawPitchRoll(0.8, 0.1, -0.2), {1, 2, 0.5}),
                                         At(0)};
  const Pose away(FromYawPitchRoll(2.0, 0, 0), {1000, -500, 20});
  std::vector<Pose> moved;
  moved.reserve(corrections.size());
  for (const Pose& correction : corrections) moved.push_back(away * correction);
  const Trajectory here = Corrected(Graph(corrections), Odometry());
  const Trajectory there = Corrected(Graph(moved), Odometry());
  for (std::size_t k = 0; k < here.size(); ++k)
    EXPECT_LT(there[k].T_WI.BoxMinus(away * here[k].T_WI).norm(), 1e-9);
}

TEST(TrajectoryCorrection, WithoutKeyframesItIsOdometry) {
  const Trajectory corrected = Corrected(PoseGraph(), Odometry());
  EXPECT_EQ(corrected.size(), Odometry().size());
  EXPECT_EQ(corrected[3].T_WI.p(), Odometry()[3].T_WI.p());
  EXPECT_TRUE(Corrected(Graph({At(1)}), {}).empty());
}

}  // namespace
}  // namespace drydock::svin2
