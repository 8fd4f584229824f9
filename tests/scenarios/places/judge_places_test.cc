#include "scenarios/places/judge_places.h"

#include <gtest/gtest.h>

#include "tests/estimator/svin2/vocabulary/synthetic_descriptors.h"

namespace drydock {
namespace {

using svin2::testing::Disturbed;
using svin2::testing::RandomDescriptors;
using svin2::testing::SmallVocabulary;

// Along a line at 1 m a keyframe and second, 30 of the things beside it in view, and back.
std::vector<KeyframeView> ThereAndBack() {
  RandomStream random(1, "judge_places_test");
  const std::vector<svin2::Descriptor> things = RandomDescriptors(240, random);
  std::vector<KeyframeView> views;
  for (int k = 0; k < 40; ++k) {
    const int x = k < 20 ? k : 39 - k;
    KeyframeView view{Time{} + Duration::FromSeconds(k), Pose({1, 0, 0, 0}, {1.0 * x, 0, 0}), {}};
    const auto first = things.begin() + 10 * x;
    for (auto thing = first; thing != first + 30; ++thing) {
      view.descriptors.push_back(Disturbed(*thing, 10, random));
    }
    views.push_back(std::move(view));
  }
  return views;
}

TEST(JudgePlaces, TellsRevisitsFromOtherPlaces) {
  PlaceJudging judging;
  judging.same_distance_m = 0.5;
  const auto views = ThereAndBack();
  std::vector<std::vector<svin2::Descriptor>> images;
  for (std::size_t i = 0; i < 20; ++i) images.push_back(views[i].descriptors);
  const svin2::Vocabulary vocabulary(svin2::TrainVocabulary(images, {}));
  const PlaceJudgement found = JudgePlaces(vocabulary, views, judging);
  // The first keyframes on the way back are too near in time to count.
  EXPECT_EQ(found.revisits, 15);
  EXPECT_EQ(found.same.size(), 15U);
  EXPECT_EQ(found.neighbours.size(), 39U);
  EXPECT_GT(found.same.front(), 2.0 * found.other[found.other.size() / 2]);
  // The keyframes next to it show two thirds of the same things.
  EXPECT_GE(found.best.same, 10);
  EXPECT_GE(found.best.same + found.best.between, 14);
  EXPECT_LE(found.best.other, 1);
  EXPECT_GE(found.consistent.same + found.consistent.between, 12);
  EXPECT_EQ(found.consistent.other, 0);
}

TEST(JudgePlaces, TurnedAwayIsAnotherPlace) {
  std::vector<KeyframeView> views = ThereAndBack();
  const Eigen::Quaterniond back(0, 0, 0, 1);
  for (std::size_t i = 20; i < views.size(); ++i) views[i].T_WI = {back, views[i].T_WI.p()};
  const PlaceJudgement found = JudgePlaces(SmallVocabulary(), views, {});
  EXPECT_EQ(found.revisits, 0);
  EXPECT_TRUE(found.same.empty());
  EXPECT_EQ(found.best.same, 0);
}

}  // namespace
}  // namespace drydock
