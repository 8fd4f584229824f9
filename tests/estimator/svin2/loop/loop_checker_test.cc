#include "estimator/svin2/loop/loop_checker.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "sensors_models/base/check.h"
#include "tests/estimator/svin2/loop/synthetic_loop.h"

namespace drydock::svin2 {
namespace {

using testing::IndexOf;
using testing::MakeLoop;
using testing::NodeMap;
using testing::SyntheticLoop;

Relocalisation Check(const SyntheticLoop& loop, const std::optional<Pose>& guess = std::nullopt) {
  return LoopChecker({}, loop.rig).Check(loop.now, loop.then, guess);
}

// All points look the same to all, so that looks alone say nothing.
void LookAlike(SyntheticLoop& loop) {
  RandomStream random(1, "look-alike");
  const Descriptor same = testing::RandomDescriptor(random);
  for (Keyframe* keyframe : {&loop.now, &loop.then})
    for (KeyframePoint& point : keyframe->points)
      point.descriptor = testing::Changed(same, 4, random);
}

TEST(LoopChecker, FindsTheMotion) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const SyntheticLoop loop = MakeLoop({.seed = seed, .noisy = true, .offset_px = 0.5});
    const Relocalisation found = Check(loop);
    ASSERT_TRUE(found.IsGood()) << ToString(found.status);
    EXPECT_LT(testing::ErrorOf(found.T_then_now, loop.T_then_now), 0.02);
    EXPECT_GE(found.inliers.size(), 70U);
  }
}

TEST(LoopChecker, ComparesByTheIndexWhereThereIsOne) {
  const SyntheticLoop loop = MakeLoop({.noisy = true});
  NodeMap now, then;
  for (std::uint32_t k = 0; k < loop.landmarks.size(); ++k) {
    now[static_cast<std::uint32_t>(loop.now.points[k].id % 8)].push_back(k);
    then[static_cast<std::uint32_t>(loop.then.points[k].id % 8)].push_back(k);
  }
  const LoopChecker checker({.max_pairs_without_index = 0}, loop.rig);
  EXPECT_TRUE(checker.Check(loop.now, IndexOf(now), loop.then, IndexOf(then), loop.then).IsGood());
  EXPECT_EQ(checker.Check(loop.now, {}, loop.then, {}, loop.then).status, LoopStatus::kFewMatches);
  // So few points are all compared.
  EXPECT_TRUE(LoopChecker({}, loop.rig).Check(loop.now, {}, loop.then, {}, loop.then).IsGood());
}

// Looks find 14 of 80 points, geometry the rest.
TEST(LoopChecker, FindsMoreWhereGeometrySaysWhereToLook) {
  SyntheticLoop loop = MakeLoop({.changed_bits = 110});
  RandomStream random(1, "looks");
  for (std::size_t k = 0; k < 14; ++k)
    loop.now.points[79 - k].descriptor = loop.then.points[k].descriptor;
  EXPECT_LE(LoopMatcher({}).Match(loop.now, loop.then).size(), 25U);
  const Relocalisation found = Check(loop);
  ASSERT_TRUE(found.IsGood()) << ToString(found.status);
  EXPECT_GE(found.inliers.size(), 60U);
}

TEST(LoopChecker, AGuessTakesThePlaceOfLooks) {
  const SyntheticLoop loop = MakeLoop({.changed_bits = 110});
  EXPECT_EQ(Check(loop).status, LoopStatus::kFewMatches);
  Vector6d off;
  off << 0.05, -0.03, 0.02, 0.005, 0.005, 0.02;
  const Relocalisation found = Check(loop, loop.T_then_now.BoxPlus(off));
  ASSERT_TRUE(found.IsGood()) << ToString(found.status);
  EXPECT_LT(testing::ErrorOf(found.T_then_now, loop.T_then_now), 1e-6);
}

TEST(LoopChecker, RefusesOtherPlacesWhateverIsGuessed) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SyntheticLoop loop = MakeLoop({.seed = seed});
    loop.then = MakeLoop({.seed = seed + 100}).then;
    EXPECT_FALSE(Check(loop).IsGood());
    EXPECT_FALSE(Check(loop, loop.T_then_now).IsGood());
    LookAlike(loop);
    EXPECT_FALSE(Check(loop).IsGood());
    EXPECT_FALSE(Check(loop, loop.T_then_now).IsGood());
  }
}

TEST(LoopChecker, RefusesPermutedLooks) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SyntheticLoop loop = MakeLoop({.seed = seed});
    const Descriptor first = loop.now.points.front().descriptor;
    for (std::size_t k = 0; k + 1 < loop.now.points.size(); ++k)
      loop.now.points[k].descriptor = loop.now.points[k + 1].descriptor;
    loop.now.points.back().descriptor = first;
    EXPECT_FALSE(Check(loop).IsGood());
    EXPECT_FALSE(Check(loop, loop.T_then_now).IsGood());
  }
}

TEST(LoopChecker, RefusesValuesThatCannotBe) {
  const StereoGeometry rig(testing::SyntheticStereo());
  EXPECT_THROW(LoopChecker({.min_seed_inliers = 3}, rig), InputError);
  EXPECT_THROW(LoopChecker({.radius_px = 0.0}, rig), InputError);
  EXPECT_THROW(LoopChecker({.guess_radius_px = -1.0}, rig), InputError);
  EXPECT_THROW(LoopChecker({.max_pairs_without_index = -1}, rig), InputError);
}

}  // namespace
}  // namespace drydock::svin2
