#include "estimator/svin2/slam/loop_closer.h"

#include <cmath>
#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/estimator/svin2/slam/synthetic_rounds.h"
#include "tests/estimator/svin2/synthetic_stereo.h"

namespace drydock::svin2 {
namespace {

using testing::MakeRounds;
using testing::Rounds;

/// Looks through as many steps of the small tree as there are: all points are compared.
LoopCloserConfig SmallConfig() {
  LoopCloserConfig config;
  config.index_level = 1;
  return config;
}

LoopCloserConfig ByLooksAlone() {
  LoopCloserConfig config = SmallConfig();
  config.nearby.max_distance_m = 0.0;
  return config;
}

std::unique_ptr<LoopCloser> Close(const Rounds& rounds,
                                  const LoopCloserConfig& config = SmallConfig(),
                                  Worker* worker = nullptr) {
  auto closer = std::make_unique<LoopCloser>(
      config, testing::SyntheticStereo(),
      std::make_shared<const Vocabulary>(testing::VocabularyOf(rounds)), worker);
  for (const Keyframe& keyframe : rounds.keyframes) closer->Add(keyframe);
  closer->Finish();
  return closer;
}

Pose TruthAt(const Rounds& rounds, Time t) {
  for (std::size_t k = 0; k < rounds.keyframes.size(); ++k)
    if (rounds.keyframes[k].t == t) return rounds.truth[k];
  ADD_FAILURE() << "no keyframe at " << t.Seconds() << " s";
  return {};
}

/// How far off the loops are that were closed [m]: the worst.
double WorstLoop(const Rounds& rounds, const LoopCloser& closer) {
  double worst = 0.0;
  for (const LoopClosure& loop : closer.Loops()) {
    const Pose truth = TruthAt(rounds, loop.t_then).Inverse() * TruthAt(rounds, loop.t_now);
    worst = std::max(worst, (loop.T_then_now.p() - truth.p()).norm());
  }
  return worst;
}

int LoopsToFirstRound(const Rounds& rounds, const LoopCloser& closer) {
  int count = 0;
  for (const LoopClosure& loop : closer.Loops())
    if (loop.t_now >= rounds.second_round && loop.t_then < rounds.second_round) ++count;
  return count;
}

/// Position error (RMSE) of the keyframes [m]; the first one defines the world.
double Error(const Rounds& rounds, const std::vector<PoseGraphNode>& nodes,
             const std::vector<Pose>& T_GI) {
  double squares = 0.0;
  for (std::size_t k = 0; k < nodes.size(); ++k)
    squares += (T_GI[k].p() - TruthAt(rounds, nodes[k].t).p()).squaredNorm();
  return std::sqrt(squares / static_cast<double>(nodes.size()));
}

double CorrectedError(const Rounds& rounds, const LoopCloser& closer) {
  return Error(rounds, closer.graph().nodes(), closer.graph().T_GI());
}

double OdometryError(const Rounds& rounds, const LoopCloser& closer) {
  std::vector<Pose> T_WI;
  for (const PoseGraphNode& node : closer.graph().nodes()) T_WI.push_back(node.T_WI);
  return Error(rounds, closer.graph().nodes(), T_WI);
}

TEST(LoopCloser, ClosesTheSecondRoundOntoTheFirst) {
  const Rounds rounds = MakeRounds();
  const auto closer = Close(rounds);
  EXPECT_GE(closer->Loops().size(), 36U) << "of 40 keyframes that come again";
  for (const LoopClosure& loop : closer->Loops())
    EXPECT_GE((loop.t_now - loop.t_then).Seconds(), 70.0) << "a round takes 80 s";
  EXPECT_LT(WorstLoop(rounds, *closer), 0.05);
  EXPECT_LT(CorrectedError(rounds, *closer), 0.6 * OdometryError(rounds, *closer));
  const auto events = closer->TakeEvents();
  ASSERT_EQ(events.size(), closer->Loops().size());
  EXPECT_THAT(events[0].message, ::testing::HasSubstr("recognised the place of"));
}

TEST(LoopCloser, RecognisesPlacesByTheirLooks) {
  const Rounds rounds = MakeRounds({.seed = 2});
  const auto closer = Close(rounds, ByLooksAlone());
  EXPECT_GE(closer->Loops().size(), 30U);
  EXPECT_LT(WorstLoop(rounds, *closer), 0.1);
}

TEST(LoopCloser, GlimpsesLookForTheirPlaceAndAreNotRemembered) {
  const Rounds rounds = MakeRounds({.seed = 3, .with_glimpses = true});
  const auto closer = Close(rounds);
  EXPECT_EQ(closer->graph().nodes().size(), 60U);
  EXPECT_EQ(closer->keyframes().size(), 60U);
  EXPECT_GE(closer->Loops().size(), 36U);
  EXPECT_LT(WorstLoop(rounds, *closer), 0.1);
  EXPECT_LT(CorrectedError(rounds, *closer), 0.6 * OdometryError(rounds, *closer));
}

TEST(LoopCloser, LaysANewMapWhereALoopHasIt) {
  const Rounds rounds = MakeRounds({.seed = 4, .lost_between = true});
  const auto closer = Close(rounds);
  EXPECT_GE(closer->Loops().size(), 30U);
  EXPECT_GT(OdometryError(rounds, *closer), 3.0);
  EXPECT_LT(CorrectedError(rounds, *closer), 0.1);
}

TEST(LoopCloser, ANewMapStaysWhereItIsWithoutALoop) {
  const Rounds rounds = MakeRounds({.seed = 4, .lost_between = true});
  LoopCloserConfig config = SmallConfig();
  config.max_verified = 0;
  const auto closer = Close(rounds, config);
  EXPECT_EQ(LoopsToFirstRound(rounds, *closer), 0) << "where another map lies says nothing";
  EXPECT_GT(CorrectedError(rounds, *closer), 3.0);
}

TEST(LoopCloser, OptimisesOnAWorkerToTheSameBits) {
  const Rounds rounds = MakeRounds({.seed = 5, .with_glimpses = true});
  Worker worker;
  const auto alone = Close(rounds), beside = Close(rounds, SmallConfig(), &worker);
  ASSERT_EQ(alone->graph().T_GI().size(), beside->graph().T_GI().size());
  for (std::size_t k = 0; k < alone->graph().T_GI().size(); ++k) {
    EXPECT_EQ(alone->graph().T_GI()[k].p(), beside->graph().T_GI()[k].p());
    EXPECT_EQ(alone->graph().T_GI()[k].q().coeffs(), beside->graph().T_GI()[k].q().coeffs());
  }
}

TEST(LoopCloser, WhatIsYoungIsNoCandidate) {
  LoopCloserConfig config = SmallConfig();
  config.min_age_s = 1000.0;
  EXPECT_TRUE(Close(MakeRounds(), config)->Loops().empty());
}

// Were it tracked all the way round, the window would know all about it.
TEST(LoopCloser, WhatIsStillTrackedIsNoCandidate) {
  const Rounds rounds = MakeRounds({.still_tracked = true});
  EXPECT_TRUE(Close(rounds)->Loops().empty());
}

// The same words, other geometry.
TEST(LoopCloser, LooksAloneCloseNoLoop) {
  const Rounds rounds = MakeRounds({.seed = 6, .is_shuffled = true});
  EXPECT_EQ(LoopsToFirstRound(rounds, *Close(rounds, ByLooksAlone())), 0);
}

// Ten keyframes that truly show what another place shows: geometry holds, and only odometry and the
// other loops can tell.
TEST(LoopCloser, TenFalseLoopsDoLittleHarm) {
  const auto clean = Close(MakeRounds({.seed = 7}));
  const Rounds rounds = MakeRounds({.seed = 7, .look_alikes = 10});
  const auto closer = Close(rounds, ByLooksAlone());
  EXPECT_GE(closer->TakeEvents().size(), closer->Loops().size() + 8) << "were verified";
  EXPECT_LT(WorstLoop(rounds, *closer), 0.1) << "none of those is believed";
  EXPECT_LT(CorrectedError(rounds, *closer), 1.2 * CorrectedError(MakeRounds({.seed = 7}), *clean));
}

TEST(LoopCloser, ShowsNothingAndClosesNothing) {
  Rounds rounds = MakeRounds();
  const std::shared_ptr<const Vocabulary> vocabulary =
      std::make_shared<const Vocabulary>(testing::VocabularyOf(rounds));
  LoopCloser closer(SmallConfig(), testing::SyntheticStereo(), vocabulary, nullptr);
  closer.Finish();
  EXPECT_TRUE(closer.Loops().empty());
  for (Keyframe& keyframe : rounds.keyframes) {
    keyframe.points.clear();
    closer.Add(std::move(keyframe));
  }
  closer.Finish();
  EXPECT_TRUE(closer.Loops().empty());
}

}  // namespace
}  // namespace drydock::svin2
