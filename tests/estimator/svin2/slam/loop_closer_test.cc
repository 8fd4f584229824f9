#include "estimator/svin2/slam/loop_closer.h"

#include <algorithm>
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

/// Loops that were verified and are off by more than half a metre, believed or not.
int NumFalse(const Rounds& rounds, const LoopCloser& closer) {
  const std::vector<PoseGraphNode>& nodes = closer.graph().nodes();
  return static_cast<int>(
      std::ranges::count_if(closer.graph().loops(), [&](const PoseGraphEdge& loop) {
        const auto truth_of = [&](std::int64_t index) {
          return TruthAt(rounds, nodes[closer.graph().PositionOf(index)].t);
        };
        const Pose truth = truth_of(loop.from).Inverse() * truth_of(loop.to);
        return (loop.T_from_to.p() - truth.p()).norm() > 0.5;
      }));
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

/// Of two keyframes by their words, 0 to 1.
double Likeness(const Rounds& rounds, std::size_t now, std::size_t then) {
  const Vocabulary vocabulary = testing::VocabularyOf(rounds);
  const auto words_of = [&](std::size_t k) {
    std::vector<Descriptor> descriptors;
    descriptors.reserve(rounds.keyframes[k].points.size());
    for (const KeyframePoint& point : rounds.keyframes[k].points)
      descriptors.push_back(point.descriptor);
    return vocabulary.Transform(descriptors, 1).words;
  };
  return Score(words_of(now), words_of(then));
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
  const Pose latest = closer->graph().T_GW() * rounds.keyframes.back().T_WI;
  EXPECT_LT((latest.p() - rounds.truth.back().p()).norm(), 0.1);
}

TEST(LoopCloser, ANewMapStaysWhereItIsWithoutALoop) {
  const Rounds rounds = MakeRounds({.seed = 4, .lost_between = true});
  LoopCloserConfig config = SmallConfig();
  config.max_verified = 0;
  const auto closer = Close(rounds, config);
  EXPECT_EQ(LoopsToFirstRound(rounds, *closer), 0) << "where another map lies says nothing";
  EXPECT_GT(CorrectedError(rounds, *closer), 3.0);
}

// At all times, not only in the end.
TEST(LoopCloser, OptimisesOnAWorkerToTheSameBits) {
  const Rounds rounds = MakeRounds({.seed = 5, .with_glimpses = true});
  const auto vocabulary = std::make_shared<const Vocabulary>(testing::VocabularyOf(rounds));
  Worker worker;
  LoopCloser alone(SmallConfig(), testing::SyntheticStereo(), vocabulary, nullptr);
  LoopCloser beside(SmallConfig(), testing::SyntheticStereo(), vocabulary, &worker);
  const auto expect_same = [&] {
    ASSERT_EQ(alone.graph().T_GI().size(), beside.graph().T_GI().size());
    for (std::size_t k = 0; k < alone.graph().T_GI().size(); ++k) {
      ASSERT_EQ(alone.graph().T_GI()[k].p(), beside.graph().T_GI()[k].p());
      ASSERT_EQ(alone.graph().T_GI()[k].q().coeffs(), beside.graph().T_GI()[k].q().coeffs());
    }
  };
  for (const Keyframe& keyframe : rounds.keyframes) {
    alone.Add(keyframe);
    beside.Add(keyframe);
    expect_same();
  }
  alone.Finish();
  beside.Finish();
  expect_same();
  EXPECT_FALSE(alone.Loops().empty());
}

TEST(LoopCloser, WhatIsYoungIsNoCandidate) {
  LoopCloserConfig config = SmallConfig();
  config.min_age_s = 1000.0;
  EXPECT_TRUE(Close(MakeRounds(), config)->Loops().empty());
  // A round takes 80 s: what is nearest has become too young, what was seen before it has not.
  config.min_age_s = 81.0;
  const auto loops = Close(MakeRounds(), config)->Loops();
  EXPECT_GE(loops.size(), 30U);
  for (const LoopClosure& loop : loops) EXPECT_GE((loop.t_now - loop.t_then).Seconds(), 81.0);
}

TEST(LoopCloser, AGlimpseThatNothingTiesIsLeftOut) {
  Rounds rounds = MakeRounds();
  const auto closer = Close(rounds);
  const std::size_t loops = closer->graph().loops().size();
  Keyframe glimpse = rounds.keyframes.back();
  glimpse.is_glimpse = true;
  glimpse.t = glimpse.t + Duration{500'000'000};
  glimpse.link->T_before_now = Pose::Identity();
  Keyframe of_another_map = glimpse, alone = glimpse;
  of_another_map.map_id = 1;
  alone.link.reset();
  closer->Add(of_another_map);
  closer->Add(alone);
  EXPECT_EQ(closer->graph().loops().size(), loops);
  closer->Add(glimpse);
  EXPECT_EQ(closer->graph().loops().size(), loops + 1);

  LoopCloser fresh(SmallConfig(), testing::SyntheticStereo(),
                   std::make_shared<const Vocabulary>(testing::VocabularyOf(rounds)), nullptr);
  fresh.Add(glimpse);
  EXPECT_TRUE(fresh.keyframes().empty() && fresh.graph().nodes().empty());
}

// Keyframes are rare in haze: the last one may be as old as a loop's must be.
TEST(LoopCloser, AGlimpseIsNoLoopToTheKeyframeThatItIsCarriedTo) {
  const Rounds rounds = MakeRounds();
  const auto closer = Close(rounds);
  Keyframe glimpse = rounds.keyframes.back();
  glimpse.is_glimpse = true;
  glimpse.t = glimpse.t + Duration::FromSeconds(SmallConfig().min_age_s + 1.0);
  glimpse.link->T_before_now = Pose::Identity();
  for (KeyframePoint& point : glimpse.points) point.id += 1'000'000;  // All are lost and found.
  closer->Add(glimpse);
  for (const PoseGraphEdge& loop : closer->graph().loops()) EXPECT_LT(loop.from, loop.to);
}

// The window may forget the keyframe before, but not the map: it stays one piece.
TEST(LoopCloser, IsAsUnsureAsOdometryWhereTheWindowForgotTheKeyframeBefore) {
  Rounds rounds = MakeRounds();
  for (const std::size_t k : {20U, 50U}) rounds.keyframes[k].link.reset();
  const auto closer = Close(rounds);
  EXPECT_EQ(closer->graph().links().size(), rounds.keyframes.size() - 1);
  EXPECT_LT(CorrectedError(rounds, *closer), 0.6 * OdometryError(rounds, *closer));
}

// Their errors are alike, and add up to more than independent ones would.
TEST(LoopCloser, StepsOfOdometryCountAsLessSureThanTheySay) {
  const Rounds rounds = MakeRounds();
  LoopCloserConfig config = SmallConfig();
  config.step_sigma_factor = 2.0;
  const auto closer = Close(rounds, config);
  for (std::size_t k = 1; k < rounds.keyframes.size(); ++k) {
    EXPECT_EQ(closer->graph().links()[k - 1].covariance,
              4.0 * rounds.keyframes[k].link->covariance);
  }
}

// Were it tracked all the way round, the window would know all about it.
TEST(LoopCloser, WhatIsStillTrackedIsNoCandidate) {
  const Rounds rounds = MakeRounds({.still_tracked = true});
  EXPECT_TRUE(Close(rounds)->Loops().empty());
}

// The same words, other geometry.
TEST(LoopCloser, LooksAloneCloseNoLoop) {
  const Rounds rounds = MakeRounds({.seed = 6, .is_shuffled = true});
  const Rounds same = MakeRounds({.seed = 6});
  EXPECT_GT(Likeness(rounds, 50, 10), 0.5 * Likeness(same, 50, 10));
  EXPECT_EQ(LoopsToFirstRound(rounds, *Close(rounds, ByLooksAlone())), 0);
  EXPECT_GT(LoopsToFirstRound(same, *Close(same, ByLooksAlone())), 30);
}

// Ten keyframes that truly show what another place shows: geometry holds, and only odometry and the
// other loops can tell.
TEST(LoopCloser, TenFalseLoopsDoLittleHarm) {
  for (const std::uint64_t seed : {7, 8, 9}) {
    const Rounds rounds = MakeRounds({.seed = seed, .look_alikes = 10});
    // The same dive, had they shown nothing.
    Rounds blind = rounds;
    for (std::size_t k = 50; k < 60; ++k) blind.keyframes[k].points.clear();
    const auto without = Close(blind, SmallConfig());
    EXPECT_EQ(NumFalse(blind, *without), 0);
    const double clean = CorrectedError(blind, *without);
    const auto closer = Close(rounds, SmallConfig());
    EXPECT_GE(NumFalse(rounds, *closer), 10) << "were verified";
    EXPECT_LT(WorstLoop(rounds, *closer), 0.1) << "none of those is believed";
    EXPECT_THAT(closer->TakeEvents().back().message, ::testing::HasSubstr("contradict odometry"));
    EXPECT_LT(CorrectedError(rounds, *closer), 1.2 * clean) << seed;
    // They would do harm.
    LoopCloserConfig trusting = SmallConfig();
    trusting.graph.options.check_loops = false;
    EXPECT_GT(CorrectedError(rounds, *Close(rounds, trusting)), 10.0 * clean) << seed;
  }
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
