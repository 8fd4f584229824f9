// What the feature tracker does where fine corners are few: in haze.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "sensors_models/base/random_stream.h"
#include "tests/estimator/svin2/frontend/tracked_wall.h"

namespace drydock::svin2 {
namespace {

using testing::Dive;
using testing::IdsOf;
using testing::PoseAt;
using testing::Small;

// The same view through haze that leaves a share of its contrast, by a noisy camera.
StereoFrame Hazy(StereoFrame frame, double share, double noise, std::uint64_t seed) {
  RandomStream random(seed, "haze");
  for (cv::Mat& image : frame.images) {
    image = image.clone();
    for (int y = 0; y < image.rows; ++y) {
      for (int x = 0; x < image.cols; ++x) {
        auto& pixel = image.at<std::uint8_t>(y, x);
        const double level = 120.0 + share * (pixel - 120.0) + noise * random.Gaussian();
        pixel = static_cast<std::uint8_t>(std::clamp(std::lround(level), 0L, 255L));
      }
    }
  }
  return frame;
}

int SeenTwice(const TrackedFrame& frame) {
  return static_cast<int>(std::ranges::count_if(
      frame.points, [](const TrackedPoint& point) { return point.right.has_value(); }));
}

class Haze : public ::testing::Test {
 protected:
  // Frames of which the signal is 1.5 grey levels and the noise 4.
  static TrackedFrame Swim(Dive& dive, int k) {
    const auto seed = static_cast<std::uint64_t>(k) + 1;
    return dive.See(k, Hazy(dive.wall().See(PoseAt(k)), 0.05, 4.0, seed));
  }
  static FeatureTracker::Config WithOctaves(int octaves) {
    FeatureTracker::Config config;
    config.octaves = octaves;
    return config;
  }
};

TEST_F(Haze, HidesFineCornersBeforeCoarseOnes) {
  Dive fine(WithOctaves(1)), coarse(WithOctaves(3));
  TrackedFrame by_fine, by_coarse;
  for (int k = 0; k <= 3; ++k) {
    by_fine = Swim(fine, k);
    by_coarse = Swim(coarse, k);
  }
  EXPECT_GE(SeenTwice(by_coarse), 20);
  EXPECT_GE(SeenTwice(by_coarse), 2 * SeenTwice(by_fine));
}

// A coarse point is known to its sigma, about: the outermost tenth aside, for some are lost.
TEST_F(Haze, LeavesCoarsePointsTheirAccuracy) {
  Dive dive(WithOctaves(3));
  for (int k = 0; k <= 3; ++k) Swim(dive, k);
  const TrackedFrame frame = Swim(dive, 4);
  std::vector<double> errors;
  for (const TrackedPoint& point : frame.points) {
    if (!point.right.has_value() || point.sigma_px < 0.5) continue;
    errors.push_back((dive.PixelOf(4, point.id) - point.left).norm() / point.sigma_px);
  }
  ASSERT_GE(errors.size(), 10U);
  std::ranges::sort(errors);
  EXPECT_LT(errors[errors.size() / 2], 3.0);
  EXPECT_LT(errors[errors.size() * 9 / 10], 8.0);
}

TEST_F(Haze, ShowsCoarseCornersToRecognise) {
  FeatureTracker::Config config = WithOctaves(1);
  config.describe_every = Duration{700'000'000};
  config.unfollowed.octave = 1;  // The rig's images are small.
  Dive dive(config);
  const TrackedFrame frame = Swim(dive, 0);
  ASSERT_TRUE(frame.is_described);
  EXPECT_GE(frame.unfollowed.size(), 10U);
  const LandmarkId last = frame.points.empty() ? 0 : frame.points.back().id;
  for (const TrackedPoint& point : frame.unfollowed) {
    EXPECT_GT(point.id, last);
    EXPECT_TRUE(point.right.has_value() && point.descriptor.has_value());
  }
  // Nobody follows them.
  const TrackedFrame next = Swim(dive, 1);
  for (const TrackedPoint& point : frame.unfollowed) EXPECT_FALSE(IdsOf(next).contains(point.id));
}

TEST(FeatureTracker, LooksForNothingCoarseWhereFineCornersAreEnough) {
  FeatureTracker::Config config = Small();
  config.describe_every = Duration{700'000'000};
  config.enough_points = config.unfollowed.enough_points = 40;
  FeatureTracker::Config fine_alone = config;
  fine_alone.octaves = 1;
  Dive dive(config), same(fine_alone);
  for (int k = 0; k <= 3; ++k) {
    const TrackedFrame frame = dive.Swim(k), other = same.Swim(k);
    EXPECT_TRUE(frame.unfollowed.empty());
    ASSERT_EQ(IdsOf(frame), IdsOf(other));
    for (std::size_t i = 0; i < frame.points.size(); ++i)
      EXPECT_EQ(frame.points[i].left, other.points[i].left);
  }
}

}  // namespace
}  // namespace drydock::svin2
