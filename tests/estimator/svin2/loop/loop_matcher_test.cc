#include "estimator/svin2/loop/loop_matcher.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "sensors_models/base/check.h"
#include "tests/estimator/svin2/loop/synthetic_loop.h"

namespace drydock::svin2 {
namespace {

using testing::IndexOf;
using testing::MakeLoop;
using testing::NodeMap;

bool AreRight(const testing::SyntheticLoop& loop, const std::vector<LoopMatch>& matches) {
  return std::ranges::all_of(matches, [&](const LoopMatch& match) {
    return loop.now.points[match.now].id == loop.then.points[match.then].id + 1000;
  });
}

// Every 10th point of then's looks like the one before it, but for some bits.
void MakeTwins(testing::SyntheticLoop& loop) {
  RandomStream random(1, "twins");
  for (std::size_t k = 10; k < loop.then.points.size(); k += 10) {
    loop.then.points[k].descriptor =
        testing::Changed(loop.then.points[k - 1].descriptor, 4, random);
  }
}

TEST(LoopMatcher, FindsEveryPointAmongAll) {
  const auto loop = MakeLoop();
  const auto matches = LoopMatcher({}).Match(loop.now, loop.then);
  ASSERT_EQ(matches.size(), loop.landmarks.size());
  EXPECT_TRUE(AreRight(loop, matches));
  for (const LoopMatch& match : matches) EXPECT_EQ(match.distance, 30);
}

TEST(LoopMatcher, RefusesWhatIsTooFarOrTooLikeAnother) {
  const auto changed = MakeLoop({.changed_bits = 150});
  EXPECT_TRUE(LoopMatcher({}).Match(changed.now, changed.then).empty());
  auto loop = MakeLoop();
  MakeTwins(loop);
  const auto matches = LoopMatcher({}).Match(loop.now, loop.then);
  // 7 pairs of twins: of neither half is it clear which one is meant.
  EXPECT_EQ(matches.size(), loop.landmarks.size() - 14);
  EXPECT_TRUE(AreRight(loop, matches));
}

// A landmark that was lost and followed anew, under another id.
TEST(LoopMatcher, TakesTwinsInOneSpotForOneLandmark) {
  auto loop = MakeLoop();
  MakeTwins(loop);
  for (std::size_t k = 10; k < loop.then.points.size(); k += 10)
    loop.then.points[k].left = loop.then.points[k - 1].left + Eigen::Vector2d(1.0, 1.0);
  const auto matches = LoopMatcher({}).Match(loop.now, loop.then);
  // The later one's own looks are gone.
  EXPECT_EQ(matches.size(), loop.landmarks.size() - 7);
}

TEST(LoopMatcher, ComparesPointsOfTheSameNodeOnly) {
  const auto loop = MakeLoop();
  const std::size_t count = loop.landmarks.size();
  NodeMap index_now, index_then;
  // Landmarks by their id's last digit; 3 has another node in `then`, 4 none.
  for (std::size_t k = 0; k < count; ++k) {
    const auto node = static_cast<std::uint32_t>(loop.then.points[k].id % 10);
    const auto at = static_cast<std::uint32_t>(k);
    if (node != 4) index_then[node == 3 ? 33 : node].push_back(at);
    index_now[static_cast<std::uint32_t>(loop.now.points[k].id % 10)].push_back(at);
  }
  const auto matches =
      LoopMatcher({}).Match(loop.now, IndexOf(index_now), loop.then, IndexOf(index_then));
  EXPECT_EQ(matches.size(), count * 8 / 10);
  EXPECT_TRUE(AreRight(loop, matches));
}

TEST(LoopMatcher, TellsTwinsApartByWhereTheyMustBe) {
  auto loop = MakeLoop();
  MakeTwins(loop);
  const auto matches = LoopMatcher({}).MatchNear(loop.rig, loop.now, loop.then, loop.T_then_now, 5);
  EXPECT_TRUE(AreRight(loop, matches));
  // The later half of twins has lost its looks.
  EXPECT_GE(matches.size(), loop.landmarks.size() - 8);
}

TEST(LoopMatcher, LooksForNowsLandmarksInThenWhereThenHasNone) {
  auto loop = MakeLoop();
  testing::CloseRightEye(loop.then);
  const auto matches = LoopMatcher({}).MatchNear(loop.rig, loop.now, loop.then, loop.T_then_now, 5);
  EXPECT_EQ(matches.size(), loop.landmarks.size());
  testing::CloseRightEye(loop.now);
  EXPECT_TRUE(LoopMatcher({}).MatchNear(loop.rig, loop.now, loop.then, loop.T_then_now, 5).empty());
}

TEST(LoopMatcher, RefusesValuesThatCannotBe) {
  EXPECT_THROW(LoopMatcher({.max_distance = 513}), InputError);
  EXPECT_THROW(LoopMatcher({.max_distance_near = -1}), InputError);
  EXPECT_THROW(LoopMatcher({.max_ratio = 1.1}), InputError);
  EXPECT_THROW(LoopMatcher({.max_ratio_near = 0.0}), InputError);
}

}  // namespace
}  // namespace drydock::svin2
