#include "estimator/svin2/frontend/keyframe_memory.h"

#include <gtest/gtest.h>

namespace drydock::svin2 {
namespace {

FeatureTrack Track(LandmarkId id, double x, bool described = true) {
  FeatureTrack track;
  track.id = id;
  track.left.x() = x;
  if (described) track.descriptor.emplace().fill(0);
  return track;
}

TEST(KeyframeMemory, GivesWhatIsLostAsItWasSeenLast) {
  KeyframeMemory memory(2);
  memory.Keep({Track(1, 10.0), Track(2, 10.0), Track(3, 10.0)});
  memory.Keep({Track(2, 20.0), Track(4, 20.0), Track(5, 20.0, false)});
  const auto lost = memory.Lost({Track(4, 0.0)});
  ASSERT_EQ(lost.size(), 3U);  // 4 is live, 5 has no descriptor.
  EXPECT_EQ(lost[0].id, 1U);
  EXPECT_EQ(lost[1].id, 2U);
  EXPECT_EQ(lost[1].left.x(), 20.0);
  EXPECT_EQ(lost[2].id, 3U);
  // A third keyframe pushes out the first.
  memory.Keep({});
  EXPECT_EQ(memory.Lost({}).size(), 2U);
}

TEST(KeyframeMemory, MayBeSwitchedOff) {
  KeyframeMemory memory(0);
  memory.Keep({Track(1, 10.0)});
  EXPECT_TRUE(memory.Lost({}).empty());
}

}  // namespace
}  // namespace drydock::svin2
