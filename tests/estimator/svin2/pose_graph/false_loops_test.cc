// Loop closing under false loops and under large drift, on a dive of two laps.
#include <algorithm>

#include <gtest/gtest.h>

#include "tests/estimator/svin2/pose_graph/synthetic_graph.h"

namespace drydock::svin2 {
namespace {

using Eigen::Vector3d;
using testing::Ate;
using testing::SyntheticDive;
using testing::SyntheticDiveConfig;

constexpr std::uint64_t kSeeds = 10;

SyntheticDiveConfig WithSeed(std::uint64_t seed) {
  SyntheticDiveConfig config;
  config.seed = seed;
  return config;
}

struct Outcome {
  double ate = 0.0;
  double ate_odometry = 0.0;
  std::vector<LoopVerdict> verdicts;

  /// Of the loops from the `first` on.
  std::int64_t Believed(std::size_t first = 0) const {
    return std::count(verdicts.begin() + static_cast<std::ptrdiff_t>(first), verdicts.end(),
                      LoopVerdict::kBelieved);
  }
};

Outcome Close(const SyntheticDive& dive, const std::vector<PoseGraphEdge>& loops,
              const PoseGraphOptions& options = {}) {
  PoseGraph graph;
  dive.AddTo(graph);
  Outcome outcome;
  outcome.ate_odometry = Ate(dive, graph.T_GI());
  for (const PoseGraphEdge& loop : loops) graph.AddEdge(loop);
  const PoseGraphResult result = graph.Optimise(options);
  EXPECT_TRUE(result.report.usable && result.report.converged);
  outcome.ate = Ate(dive, result.T_GI);
  outcome.verdicts = result.verdicts;
  return outcome;
}

std::vector<PoseGraphEdge> Joined(std::vector<PoseGraphEdge> a,
                                  const std::vector<PoseGraphEdge>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Ten false loops from neighbours to neighbours, all wrong by the same.
std::vector<PoseGraphEdge> LookAlikes(SyntheticDive& dive, const Vector3d& shift) {
  std::vector<PoseGraphEdge> loops;
  for (std::int64_t k = 0; k < 10; ++k) loops.push_back(dive.FalseLoop(30 + k, 133 + k, shift));
  return loops;
}

TEST(FalseLoops, TrueOnesAreBelievedAndTakeDriftAway) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SyntheticDive dive(WithSeed(seed));
    const Outcome outcome = Close(dive, dive.TrueLoops(110, 200, 9));
    EXPECT_EQ(outcome.Believed(), 10) << seed;
    EXPECT_LT(outcome.ate, outcome.ate_odometry) << seed;
  }
}

TEST(FalseLoops, RandomOnesHardlyHurt) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SyntheticDive dive(WithSeed(seed));
    const auto loops = dive.TrueLoops(110, 200, 9);
    std::vector<PoseGraphEdge> wrong;
    wrong.reserve(10);
    for (int k = 0; k < 10; ++k) wrong.push_back(dive.RandomLoop());
    const Outcome clean = Close(dive, loops);
    // Whichever come first.
    EXPECT_LT(Close(dive, Joined(loops, wrong)).ate, 1.2 * clean.ate) << seed;
    EXPECT_LT(Close(dive, Joined(wrong, loops)).ate, 1.2 * clean.ate) << seed;
    // They would hurt.
    PoseGraphOptions trusting;
    trusting.check_loops = false;
    EXPECT_GT(Close(dive, Joined(loops, wrong), trusting).ate, 2.0 * clean.ate) << seed;
  }
}

TEST(FalseLoops, ThoseThatAgreeWithEachOtherHardlyHurt) {
  for (const Vector3d& shift : {Vector3d(0.8, 0, 0), Vector3d(0, 1.5, 0), Vector3d(-3, 0, 0)}) {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      SyntheticDive dive(WithSeed(seed));
      // As many sightings of one look-alike as true loops all around.
      const auto loops = dive.TrueLoops(110, 200, 9);
      const auto wrong = LookAlikes(dive, shift);
      const Outcome clean = Close(dive, loops);
      const Outcome late = Close(dive, Joined(loops, wrong)),
                    early = Close(dive, Joined(wrong, loops));
      EXPECT_LT(late.ate, 1.2 * clean.ate) << seed << " " << shift.transpose();
      EXPECT_LT(early.ate, 1.2 * clean.ate) << seed << " " << shift.transpose();
      EXPECT_EQ(late.Believed(), early.Believed());
      EXPECT_EQ(late.Believed(loops.size()), 0) << seed << " " << shift.transpose();
    }
  }
}

TEST(FalseLoops, HardlyHurtWhereFewTrueOnesAre) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SyntheticDive dive(WithSeed(seed));
    const auto loops = dive.TrueLoops(150, 200, 25);
    ASSERT_EQ(loops.size(), 2U);
    const Outcome clean = Close(dive, loops);
    const Outcome outcome = Close(dive, Joined(loops, LookAlikes(dive, {0, 1.5, 0})));
    EXPECT_LT(outcome.ate, 1.2 * clean.ate) << seed;
  }
}

TEST(FalseLoops, LargeDriftAfterABlindStretchIsCorrected) {
  for (const std::int64_t count : {1, 2}) {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      SyntheticDive dive(WithSeed(seed));
      dive.GoBlind(120, 130, {1.6, -1.2, 0.0}, 0.3);
      const auto loops = dive.TrueLoops(150, 150 + 20 * count, 20);
      const Outcome outcome = Close(dive, loops);
      EXPECT_EQ(outcome.Believed(), count) << seed;
      EXPECT_GT(outcome.ate_odometry, 0.7) << seed;
      EXPECT_LT(outcome.ate, 0.3 * outcome.ate_odometry) << seed;
    }
  }
}

TEST(FalseLoops, TakeNothingWithThemWhenFoundOut) {
  // After a blind stretch a look-alike is as likely as the truth, until more is seen.
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SyntheticDive dive(WithSeed(seed));
    dive.GoBlind(120, 130, {1.6, -1.2, 0.0}, 0.3);
    PoseGraph graph;
    dive.AddTo(graph);
    for (const auto& wrong :
         {dive.FalseLoop(32, 135, {1.0, 0, 0}), dive.FalseLoop(34, 137, {1.0, 0, 0})})
      graph.AddEdge(wrong);
    graph.Apply(graph.Optimise({}));
    const double misled = Ate(dive, graph.T_GI());
    for (const PoseGraphEdge& loop : dive.TrueLoops(150, 200, 12)) graph.AddEdge(loop);
    graph.Apply(graph.Optimise({}));
    EXPECT_LT(Ate(dive, graph.T_GI()), 0.3 * misled) << seed;
    EXPECT_EQ(graph.verdicts()[0], LoopVerdict::kAgainstLoops) << seed;
  }
}

}  // namespace
}  // namespace drydock::svin2
