// What the feature tracker describes, for recognising places.
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "estimator/svin2/frontend/descriptor_extractor.h"
#include "estimator/svin2/frontend/preprocessor.h"
#include "tests/estimator/svin2/frontend/tracked_wall.h"

namespace drydock::svin2 {
namespace {

using testing::Dive;
using testing::PoseAt;
using testing::Small;

// How the points of frame `k` look in its left image, turned to `down`, in the first camera.
std::vector<std::optional<Descriptor>> LooksOf(const Dive& dive, int k, const TrackedFrame& frame,
                                               const Eigen::Vector3d& down) {
  std::vector<Eigen::Vector2d> pixels;
  pixels.reserve(frame.points.size());
  for (const TrackedPoint& point : frame.points) pixels.push_back(point.left);
  return DescriptorExtractor({}).Describe(
      Preprocessor({}).Process(dive.wall().See(PoseAt(k)).images[0]), pixels,
      dive.wall().geometry().camera(0), down);
}

Eigen::Vector3d DownAt(const Dive& dive, int k) {
  const Pose T_WC = PoseAt(k) * dive.wall().geometry().T_IC(0);
  return T_WC.q().conjugate() * -Eigen::Vector3d::UnitZ();
}

// What places are recognised by: the points that are tracked, as this very frame shows them.
TEST(FeatureTracker, DescribesPointsAtKeyframes) {
  FeatureTracker::Config config = Small();
  config.keyframes.max_gap = 4;
  Dive dive(config);
  int keyframes = 0;
  for (int k = 0; k < 6; ++k) {
    const TrackedFrame frame = dive.Swim(k);
    if (!frame.is_keyframe) {
      for (const TrackedPoint& point : frame.points) EXPECT_FALSE(point.descriptor.has_value());
      continue;
    }
    ++keyframes;
    // Nothing says yet what is down.
    const Eigen::Vector3d down = k == 0 ? Eigen::Vector3d::UnitY().eval() : DownAt(dive, k);
    const auto expected = LooksOf(dive, k, frame, down);
    int alike = 0, described = 0;
    for (std::size_t i = 0; i < frame.points.size(); ++i) {
      described += expected[i].has_value() ? 1 : 0;
      alike += expected[i].has_value() && frame.points[i].descriptor == expected[i] ? 1 : 0;
    }
    // Points that were regained at this frame keep their corner's, a fraction of a pixel aside.
    EXPECT_GE(alike, described * 9 / 10);
    EXPECT_GE(described, 30);
  }
  EXPECT_EQ(keyframes, 2);
}

TEST(FeatureTracker, PatchesAloneAreNotDescribed) {
  Dive dive(Small(Matching::kPatches));
  const TrackedFrame frame = dive.Swim(0);
  EXPECT_TRUE(frame.is_keyframe);
  for (const TrackedPoint& point : frame.points) EXPECT_FALSE(point.descriptor.has_value());
}

// What is described for loop closing between keyframes leaves the tracks as they are.
TEST(FeatureTracker, DescribesFramesBetweenKeyframesAtIntervals) {
  FeatureTracker::Config config = Small();
  config.keyframes.max_gap = 5;
  Dive keyframes_alone(config);
  config.describe_every = Duration{200'000'000};  // Each third frame.
  Dive dive(config);
  int between = 0, last_described = 0;
  for (int k = 0; k < 9; ++k) {
    const StereoFrame images = dive.wall().See(PoseAt(k));
    const TrackedFrame frame = dive.See(k, images), plain = keyframes_alone.See(k, images);
    EXPECT_EQ(plain.is_described, plain.is_keyframe) << k;
    EXPECT_EQ(frame.is_described, frame.is_keyframe || k - last_described >= 3) << k;
    if (frame.is_described) last_described = k;
    between += frame.is_described && !frame.is_keyframe ? 1 : 0;

    EXPECT_EQ(frame.is_keyframe, plain.is_keyframe) << k;
    ASSERT_EQ(frame.points.size(), plain.points.size()) << k;
    std::size_t with_descriptor = 0;
    for (std::size_t i = 0; i < frame.points.size(); ++i) {
      ASSERT_EQ(frame.points[i].id, plain.points[i].id) << k;
      ASSERT_EQ(frame.points[i].left, plain.points[i].left) << k;
      ASSERT_EQ(frame.points[i].right, plain.points[i].right) << k;
      ASSERT_EQ(frame.points[i].sigma_px, plain.points[i].sigma_px) << k;
      with_descriptor += frame.points[i].descriptor.has_value() ? 1 : 0;
    }
    if (frame.is_described) {
      EXPECT_GE(with_descriptor, 30U) << k;
    } else {
      EXPECT_EQ(with_descriptor, 0U) << k;
    }
  }
  EXPECT_EQ(between, 2);
}

// As they look in this very frame, not in the last keyframe.
TEST(FeatureTracker, AFrameBetweenKeyframesIsDescribedAsItIs) {
  FeatureTracker::Config config = Small();
  config.describe_every = Duration{200'000'000};
  Dive dive(config);
  for (int k = 0; k < 3; ++k) dive.Swim(k);
  const TrackedFrame frame = dive.Swim(3);
  ASSERT_TRUE(frame.is_described);
  ASSERT_FALSE(frame.is_keyframe);
  const auto expected = LooksOf(dive, 3, frame, DownAt(dive, 3));
  for (std::size_t i = 0; i < frame.points.size(); ++i)
    EXPECT_EQ(frame.points[i].descriptor, expected[i]) << i;
}

}  // namespace
}  // namespace drydock::svin2
