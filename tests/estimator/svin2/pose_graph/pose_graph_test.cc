#include "estimator/svin2/pose_graph/pose_graph.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/estimator/svin2/pose_graph/synthetic_graph.h"

namespace drydock::svin2 {
namespace {

using Eigen::Vector3d;
using testing::Covariance;
using testing::SyntheticDive;

Pose At(double x, double y = 0.0, double z = 0.0) {
  return {Eigen::Quaterniond::Identity(), {x, y, z}};
}

/// Poses without turns, with edges of 0.1 m and 0.01 rad.
class PoseGraphTest : public ::testing::Test {
 protected:
  void Node(std::int64_t index, const Pose& T_WI, int map_id = 0) {
    PoseGraphNode node;
    node.index = index;
    node.t = Time{index * kNanosecondsPerSecond};
    node.T_WI = T_WI;
    node.map_id = map_id;
    node.level = level_;
    graph_.AddNode(node);
  }
  void Edge(std::int64_t from, std::int64_t to, const Pose& T_from_to,
            EdgeKind kind = EdgeKind::kSequence, double sigma = 0.1) {
    graph_.AddEdge({from, to, T_from_to, Covariance(sigma, 0.01), kind});
  }
  /// Nodes 0 to count - 1, 1 m apart in x.
  void Line(int count) {
    for (int k = 0; k < count; ++k) {
      Node(k, At(k));
      if (k > 0) Edge(k - 1, k, At(1));
    }
  }
  /// Three nodes, and three more of another map, laid down 5 m too far and turned by 1 rad.
  Pose LineThatGoesOnElsewhere() {
    Line(3);
    const Pose T_GW(FromYawPitchRoll(1.0, 0, 0), {-5, 0, 2});
    for (int k = 3; k < 6; ++k) {
      Node(k, T_GW.Inverse() * At(k), 1);
      if (k > 3) Edge(k - 1, k, At(1));
    }
    return T_GW;
  }
  const Pose& T_GI(std::size_t k) const { return graph_.T_GI()[k]; }
  PoseGraphReport Optimise(const PoseGraphOptions& options = {}) {
    const PoseGraphResult result = graph_.Optimise(options);
    graph_.Apply(result);
    return result.report;
  }

  std::optional<LevelSigmas> level_;
  PoseGraph graph_;
};

TEST_F(PoseGraphTest, SharesTheErrorOutByCovariance) {
  // Three steps of 0.1 m and a loop of 0.1 m that says 0.4 m more: each takes a quarter of it.
  Line(4);
  Edge(0, 3, At(3.4), EdgeKind::kLoop);
  const PoseGraphReport report = Optimise();
  EXPECT_TRUE(report.converged && report.usable);
  EXPECT_EQ(report.components, 1);
  for (std::size_t k = 0; k < 4; ++k)
    EXPECT_NEAR(T_GI(k).p().x(), static_cast<double>(k) * 1.1, 1e-6);
  EXPECT_EQ(T_GI(0).p(), Vector3d::Zero());
}

TEST_F(PoseGraphTest, ASurerEdgeGivesWayLess) {
  Node(0, At(0));
  Node(1, At(1));
  Edge(0, 1, At(1), EdgeKind::kSequence, 0.1);
  Node(2, At(2));
  Edge(1, 2, At(1), EdgeKind::kSequence, 0.2);
  Edge(0, 2, At(2.1), EdgeKind::kLoop, 0.01);
  Optimise();
  // Variances 1, 4 and 0.01 of 5.01.
  EXPECT_NEAR(T_GI(1).p().x(), 1.0 + 0.1 / 5.01, 1e-6);
  EXPECT_NEAR(T_GI(2).p().x(), 2.0 + 0.5 / 5.01, 1e-6);
}

TEST_F(PoseGraphTest, IdentityWeightsAreAnAblation) {
  Node(0, At(0));
  Node(1, At(1));
  Edge(0, 1, At(1), EdgeKind::kSequence, 0.1);
  Node(2, At(2));
  Edge(1, 2, At(1), EdgeKind::kSequence, 0.2);
  Edge(0, 2, At(2.03), EdgeKind::kLoop, 0.01);
  PoseGraphOptions options;
  options.identity_weights = true;
  Optimise(options);
  EXPECT_NEAR(T_GI(1).p().x(), 1.01, 1e-6);
  EXPECT_NEAR(T_GI(2).p().x(), 2.02, 1e-6);
}

TEST_F(PoseGraphTest, HuberHoldsLoopsBackButNotLinks) {
  // Two nodes at 1 m by odometry, a second edge says 3 m, both of 0.1 m: 20 sigmas apart.
  const auto place = [](EdgeKind kind) {
    PoseGraph graph;
    for (int k = 0; k < 2; ++k) {
      PoseGraphNode node;
      node.index = k;
      node.t = Time{k};
      node.T_WI = At(k);
      graph.AddNode(node);
    }
    graph.AddEdge({0, 1, At(1), Covariance(0.1, 0.01), EdgeKind::kSequence});
    graph.AddEdge({0, 1, At(3), Covariance(0.1, 0.01), kind});
    // Ties the component, without a say.
    graph.AddEdge({0, 1, At(1), Covariance(100.0, 10.0), EdgeKind::kLoop});
    PoseGraphOptions options;
    options.check_loops = false;
    return graph.Optimise(options).T_GI[1].p().x();
  };
  EXPECT_NEAR(place(EdgeKind::kCovisible), 2.0, 1e-3);
  // Its pull ends at 3.5 sigmas.
  EXPECT_NEAR(place(EdgeKind::kLoop), 1.35, 1e-3);
}

TEST_F(PoseGraphTest, WithoutLoopsItIsOdometryToTheBit) {
  const SyntheticDive dive({});
  dive.AddTo(graph_);
  graph_.AddEdge({3, 6, At(1), Covariance(0.1, 0.01), EdgeKind::kCovisible});
  EXPECT_EQ(Optimise().components, 1);
  for (std::int64_t k = 0; k < dive.size(); ++k) {
    EXPECT_EQ(T_GI(static_cast<std::size_t>(k)).p(), dive.Node(k).T_WI.p());
    EXPECT_EQ(T_GI(static_cast<std::size_t>(k)).q().coeffs(), dive.Node(k).T_WI.q().coeffs());
  }
  EXPECT_EQ(graph_.T_GW().p(), Vector3d::Zero());
}

TEST_F(PoseGraphTest, CovisibleEdgesCount) {
  // A loop ties the component; the covisible edge says 0.2 m more than two steps.
  Line(3);
  Edge(0, 2, At(2.2), EdgeKind::kCovisible);
  Edge(0, 1, At(1.0), EdgeKind::kLoop, 100.0);
  Optimise();
  EXPECT_NEAR(T_GI(2).p().x(), 2.0 + 0.2 * 2.0 / 3.0, 1e-4);
}

TEST_F(PoseGraphTest, MapsAreApartUntilALoopTiesThem) {
  const Pose T_GW = LineThatGoesOnElsewhere();
  EXPECT_EQ(Optimise().components, 2);
  EXPECT_LT(T_GI(5).BoxMinus(T_GW.Inverse() * At(5)).norm(), 1e-12);
  Edge(1, 4, At(3), EdgeKind::kLoop, 0.01);
  EXPECT_EQ(Optimise().components, 1);
  for (std::size_t k = 0; k < 6; ++k)
    EXPECT_LT(T_GI(k).BoxMinus(At(static_cast<double>(k))).norm(), 1e-6) << k;
  EXPECT_LT(graph_.T_GW().BoxMinus(T_GW).norm(), 1e-6);
  // What follows in the new map is corrected from the start.
  Node(6, T_GW.Inverse() * At(6), 1);
  EXPECT_LT(T_GI(6).BoxMinus(At(6)).norm(), 1e-6);
}

// Odometry lays a new map where the one before has brought it.
TEST_F(PoseGraphTest, AMapThatNothingTiesFollowsTheOneBefore) {
  const Pose T_GW = LineThatGoesOnElsewhere();
  Edge(1, 4, At(3), EdgeKind::kLoop, 0.01);
  for (int k = 6; k < 8; ++k) Node(k, T_GW.Inverse() * At(k), 2);
  Edge(6, 7, At(1));
  EXPECT_EQ(Optimise().components, 2);
  for (std::size_t k = 0; k < 8; ++k)
    EXPECT_LT(T_GI(k).BoxMinus(At(static_cast<double>(k))).norm(), 1e-6) << k;
  // From the start, too.
  Node(8, T_GW.Inverse() * At(8), 3);
  EXPECT_LT(T_GI(8).BoxMinus(At(8)).norm(), 1e-6);
  // And again, as it is.
  Optimise();
  EXPECT_LT(T_GI(8).BoxMinus(At(8)).norm(), 1e-6);
}

TEST_F(PoseGraphTest, AMapIsTiedOverAnotherOne) {
  // The third map knows only the second, which comes to know the first later.
  for (int map = 0; map < 3; ++map) {
    for (int k = 0; k < 3; ++k) {
      Node(3 * map + k, At(3 * map + k, 10 * map), map);
      if (k > 0) Edge(3 * map + k - 1, 3 * map + k, At(1));
    }
  }
  Edge(4, 7, At(3), EdgeKind::kLoop, 0.01);
  EXPECT_EQ(Optimise().components, 2);
  // The second map, as the older, stays, and the third comes to it.
  EXPECT_LT(T_GI(4).BoxMinus(At(4, 10)).norm(), 1e-12);
  EXPECT_LT(T_GI(7).BoxMinus(At(7, 10)).norm(), 1e-6);
  Edge(1, 8, At(7), EdgeKind::kLoop, 0.01);
  EXPECT_EQ(Optimise().components, 1);
  for (std::size_t k = 0; k < 9; ++k)
    EXPECT_LT(T_GI(k).BoxMinus(At(static_cast<double>(k))).norm(), 1e-6) << k;
}

TEST_F(PoseGraphTest, MapsComeApartWhenTheirLoopIsNotBelievedAnyMore) {
  Line(30);
  for (int k = 30; k < 60; ++k) {
    Node(k, At(k, 4), 1);
    if (k > 30) Edge(k - 1, k, At(1));
  }
  Edge(5, 40, At(20), EdgeKind::kLoop, 0.01);
  Optimise();
  EXPECT_NEAR(T_GI(40).p().x(), 25.0, 1e-6);
  Edge(1, 45, At(44), EdgeKind::kLoop, 0.01);
  Edge(20, 59, At(39), EdgeKind::kLoop, 0.01);
  Optimise();
  EXPECT_EQ(graph_.verdicts()[0], LoopVerdict::kAgainstLoops);
  for (std::size_t k = 0; k < 60; ++k)
    EXPECT_LT(T_GI(k).BoxMinus(At(static_cast<double>(k))).norm(), 1e-6) << k;
}

TEST_F(PoseGraphTest, HeightAndTiltAreKeptWhereTheyAreKnown) {
  const auto sink = [&](std::optional<LevelSigmas> level) {
    level_ = level;
    graph_ = PoseGraph();
    Line(5);
    Edge(0, 4, Pose(FromYawPitchRoll(0.02, 0, 0.02), {4.1, 0.1, 0.1}), EdgeKind::kLoop, 0.02);
    Optimise();
    return T_GI(4);
  };
  const Pose free = sink(std::nullopt), held = sink(LevelSigmas{0.002, 0.0005});
  EXPECT_GT(free.p().z(), 0.05);
  EXPECT_LT(std::abs(held.p().z()), 1e-3);
  const auto tilt = [](const Pose& pose) {
    return (pose.q() * Vector3d::UnitZ()).head<2>().norm();
  };
  EXPECT_GT(tilt(free), 0.01);
  EXPECT_LT(tilt(held), 1e-3);
  // The rest is corrected as before.
  EXPECT_GT(held.p().y(), 0.05);
  EXPECT_GT(YawOf(held.q()), 0.01);
}

TEST_F(PoseGraphTest, NodesAddedMeanwhileAreCarriedAlong) {
  Line(4);
  Edge(0, 3, At(3.4), EdgeKind::kLoop);
  const PoseGraph snapshot = graph_;
  Node(4, At(4));
  Edge(3, 4, At(1));
  graph_.Apply(snapshot.Optimise({}));
  EXPECT_NEAR(T_GI(3).p().x(), 3.3, 1e-6);
  EXPECT_NEAR(T_GI(4).p().x(), 4.3, 1e-6);
  EXPECT_EQ(graph_.verdicts().size(), 1U);
}

TEST_F(PoseGraphTest, GrowingItGivesWhatTheWholeGives) {
  // Loops as they come, each optimised from the result before, against all at once.
  SyntheticDive dive({});
  const auto loops = dive.TrueLoops(110, 200, 9);
  auto next = loops.begin();
  for (std::int64_t k = 0; k < dive.size(); ++k) {
    dive.AddTo(graph_, k);
    if (next == loops.end() || next->to != k) continue;
    graph_.AddEdge(*next++);
    Optimise();
  }
  Optimise();
  PoseGraph whole;
  dive.AddTo(whole);
  for (const PoseGraphEdge& loop : loops) whole.AddEdge(loop);
  const PoseGraphResult at_once = whole.Optimise({});
  for (std::size_t k = 0; k < at_once.T_GI.size(); ++k)
    EXPECT_LT(T_GI(k).BoxMinus(at_once.T_GI[k]).norm(), 1e-4) << k;
}

TEST_F(PoseGraphTest, TheSameGraphGivesTheSameBits) {
  const auto run = [] {
    SyntheticDive dive({});
    PoseGraph graph;
    dive.AddTo(graph);
    for (const PoseGraphEdge& loop : dive.TrueLoops(110, 200, 9)) graph.AddEdge(loop);
    return graph.Optimise({}).T_GI;
  };
  const auto first = run(), second = run();
  for (std::size_t k = 0; k < first.size(); ++k) {
    EXPECT_EQ(first[k].p(), second[k].p());
    EXPECT_EQ(first[k].q().coeffs(), second[k].q().coeffs());
  }
}

TEST_F(PoseGraphTest, RefusesBrokenPromises) {
  Line(3);
  EXPECT_THROW(Node(2, At(9)), std::logic_error);
  EXPECT_THROW(Edge(0, 7, At(1)), std::logic_error);
  EXPECT_THROW(Edge(2, 0, At(1), EdgeKind::kLoop), std::logic_error);
  EXPECT_THROW(Edge(0, 1, At(1)), std::logic_error);
  EXPECT_THROW(Edge(0, 2, At(1), EdgeKind::kLoop, 0.0), std::logic_error);
  Node(3, At(3));
  Edge(0, 3, At(3), EdgeKind::kLoop);
  EXPECT_THROW(Edge(2, 3, At(1)), std::logic_error);
  LoopCheckConfig config;
  config.sigma_factor = 0.0;
  EXPECT_THROW(PoseGraph{config}, std::logic_error);
  PoseGraphOptions options;
  options.iterations = 0;
  EXPECT_THROW(graph_.Optimise(options), std::logic_error);
}

TEST_F(PoseGraphTest, AnEmptyGraphIsNothing) {
  EXPECT_EQ(Optimise().components, 0);
  EXPECT_EQ(graph_.T_GW().p(), Vector3d::Zero());
}

}  // namespace
}  // namespace drydock::svin2
