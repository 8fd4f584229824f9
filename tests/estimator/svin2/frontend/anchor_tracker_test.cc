#include "estimator/svin2/frontend/anchor_tracker.h"

#include <gtest/gtest.h>

#include "sensors_models/base/check.h"
#include "tests/estimator/svin2/frontend/synthetic_images.h"

namespace drydock::svin2 {
namespace {

using testing::Draw;
using testing::Texture;

// The texture seen `scale` times as large, with (100, 100) staying where it is.
cv::Mat Scaled(double scale) {
  const Texture texture(7);
  const Eigen::Vector2d middle(100.0, 100.0);
  return Draw(200, 200, [&](const Eigen::Vector2d& p) {
    return 120.0 + 30.0 * texture(middle + (p - middle) / scale);
  });
}

TEST(AnchorTracker, ErrorsDoNotAddUpAndTheAnchorIsRenewedWhenTheSizeHasChanged) {
  const AnchorTracker tracker({.max_scale = 1.25});
  FeatureTrack track;
  track.left = {100.0, 100.0};
  ImagePyramid before = {Scaled(1.0)};
  ASSERT_TRUE(tracker.Anchor(before, track));
  // 1.05^4 = 1.22 is within the limit, 1.05^5 = 1.28 is not: frame 5 renews, with frame 4's patch.
  double scale = 1.0;
  for (int k = 1; k <= 6; ++k) {
    scale *= 1.05;
    const ImagePyramid now = {Scaled(scale)};
    ASSERT_TRUE(tracker.Follow(before, now, track.left + Eigen::Vector2d(0.7, -0.4), track));
    EXPECT_LT((track.left - Eigen::Vector2d(100.0, 100.0)).norm(), 0.1);
    EXPECT_EQ(track.renewals, k < 5 ? 0 : 1);
    EXPECT_NEAR(track.warp(0, 0), k < 5 ? scale : scale / (1.05 * 1.05 * 1.05 * 1.05), 0.02);
    before = now;
  }
}

TEST(AnchorTracker, GivesUpWhatIsNoLongerThere) {
  const AnchorTracker tracker({});
  FeatureTrack track;
  track.left = {100.0, 100.0};
  const ImagePyramid before = {Scaled(1.0)};
  ASSERT_TRUE(tracker.Anchor(before, track));
  const Texture other(8);
  const ImagePyramid elsewhere = {
      Draw(200, 200, [&](const Eigen::Vector2d& p) { return 120.0 + 30.0 * other(p); })};
  EXPECT_FALSE(tracker.Follow(before, elsewhere, track.left, track));
  EXPECT_FALSE(tracker.Regain(elsewhere, track.left, track));
}

// A point of octave 1 is looked for in level 1 alone: level 0 shows something else.
TEST(AnchorTracker, LooksAtTheLevelOfItsOctave) {
  const AnchorTracker tracker({});
  FeatureTrack track;
  track.octave = 1;
  track.left = {200.0, 200.0};
  const cv::Mat noise = Draw(
      400, 400, [](const Eigen::Vector2d&) { return 120.0; }, 20.0);
  const ImagePyramid before = {noise, Scaled(1.0)};
  ASSERT_TRUE(tracker.Anchor(before, track));
  EXPECT_FALSE(tracker.Regain({Scaled(1.0), noise}, track.left, track));
  // 3 px of the image are 1.5 of level 1: within an alignment's 2.
  ASSERT_TRUE(tracker.Follow(before, {noise, Scaled(1.05)}, {203.0, 200.0}, track));
  EXPECT_LT((track.left - Eigen::Vector2d(200.0, 200.0)).norm(), 0.2);
  EXPECT_NEAR(track.warp(0, 0), 1.05, 0.02);
}

TEST(AnchorTracker, AnImageWithoutItsOctaveDoesNotShowIt) {
  const AnchorTracker tracker({});
  FeatureTrack track;
  track.octave = 1;
  track.left = {200.0, 200.0};
  EXPECT_FALSE(tracker.Anchor({Scaled(1.0)}, track));
  ASSERT_TRUE(tracker.Anchor({Scaled(1.0), Scaled(1.0)}, track));
  EXPECT_FALSE(tracker.FindInRight({Scaled(1.0)}, track.left, track).has_value());
}

TEST(AnchorTracker, RefusesBadConfigurations) {
  EXPECT_THROW(AnchorTracker({.patch_radius_px = 1}), InputError);
  EXPECT_THROW(AnchorTracker({.max_scale = 1.0}), InputError);
}

}  // namespace
}  // namespace drydock::svin2
