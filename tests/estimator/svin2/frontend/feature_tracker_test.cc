#include "estimator/svin2/frontend/feature_tracker.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "sensors_models/base/check.h"
#include "sensors_models/base/random_stream.h"
#include "tests/estimator/svin2/frontend/synthetic_dive.h"

namespace drydock::svin2 {
namespace {

using testing::HalfRig;
using testing::WallDive;

// Sideways and up, turning, and 6 mm nearer each frame.
Pose PoseAt(int k) {
  return {ExpSO3({0.004 * k, -0.002 * k, 0.003 * k}), {0.006 * k, 0.012 * k, 0.008 * k}};
}

Time TimeAt(int k) { return SampleTime({}, k, 15.0); }

FeatureTracker::Config Small(Matching matching = Matching::kBoth) {
  FeatureTracker::Config config;
  config.matching = matching;
  config.detector.max_corners = 80;
  config.detector.min_score = 2e-3;
  return config;
}

std::optional<MotionPrediction> Prediction(int k) {
  if (k == 0) return std::nullopt;
  return MotionPrediction{PoseAt(k - 1), PoseAt(k)};
}

// The tracker at work, and where on the wall each of its points was first seen.
class Dive {
 public:
  explicit Dive(const FeatureTracker::Config& config) : tracker_(config, HalfRig()) {}

  TrackedFrame Swim(int k, bool predict = true) { return See(k, wall_.See(PoseAt(k)), predict); }

  TrackedFrame See(int k, const StereoFrame& images, bool predict = true) {
    const auto lookup = [this](LandmarkId id) -> std::optional<Eigen::Vector3d> {
      const auto found = points_W_.find(id);
      return found == points_W_.end() ? std::nullopt : std::optional(found->second);
    };
    TrackedFrame frame =
        tracker_.Track(TimeAt(k), images, predict ? Prediction(k) : std::nullopt, lookup);
    for (const TrackedPoint& point : frame.points) {
      points_W_.try_emplace(point.id, wall_.PointAt(PoseAt(k), 0, point.left));
    }
    return frame;
  }

  // Of the pixels of both cameras, with the number of them.
  double RmsError(int k, const TrackedFrame& frame) const {
    double squares = 0.0;
    int n = 0;
    for (const TrackedPoint& point : frame.points) {
      const Eigen::Vector3d& p_W = points_W_.at(point.id);
      squares += (wall_.PixelOf(PoseAt(k), 0, p_W).value() - point.left).squaredNorm();
      ++n;
      if (!point.right.has_value()) continue;
      squares += (wall_.PixelOf(PoseAt(k), 1, p_W).value() - *point.right).squaredNorm();
      ++n;
    }
    return std::sqrt(squares / n);
  }

  // Where the point that was first seen as `id` is seen.
  Eigen::Vector2d PixelOf(int k, LandmarkId id) const {
    return wall_.PixelOf(PoseAt(k), 0, points_W_.at(id)).value();
  }

  FeatureTracker& tracker() { return tracker_; }
  const WallDive& wall() const { return wall_; }

 private:
  WallDive wall_;
  FeatureTracker tracker_;
  std::map<LandmarkId, Eigen::Vector3d> points_W_;
};

std::set<LandmarkId> IdsOf(const TrackedFrame& frame) {
  std::set<LandmarkId> ids;
  for (const TrackedPoint& point : frame.points) ids.insert(point.id);
  return ids;
}

std::size_t Shared(const TrackedFrame& a, const TrackedFrame& b) {
  const auto ids = IdsOf(b);
  std::size_t shared = 0;
  for (const LandmarkId id : IdsOf(a)) shared += ids.contains(id) ? 1 : 0;
  return shared;
}

class AllWays : public ::testing::TestWithParam<Matching> {};

// After 5 frames a point has moved by some 25 px, and the errors have not added up.
TEST_P(AllWays, FollowsAMovingWallToATenthOfAPixel) {
  Dive dive(Small(GetParam()));
  const TrackedFrame first = dive.Swim(0);
  EXPECT_TRUE(first.is_keyframe);
  EXPECT_EQ(first.tracked, 0);
  EXPECT_EQ(first.empty_quadrants, 0);
  EXPECT_GE(first.points.size(), 60U);
  TrackedFrame frame;
  for (int k = 1; k <= 5; ++k) {
    frame = dive.Swim(k);
    EXPECT_LT(dive.RmsError(k, frame), 0.2);  // Of two coordinates.
    EXPECT_EQ(frame.t, TimeAt(k));
    EXPECT_TRUE(std::ranges::is_sorted(frame.points, {}, &TrackedPoint::id));
  }
  // Corners must be found afresh where descriptors do it all; patches lose those at the edge.
  EXPECT_GE(Shared(first, frame), GetParam() == Matching::kDescriptors ? 10U : 45U);
}

INSTANTIATE_TEST_SUITE_P(Matchings, AllWays,
                         ::testing::Values(Matching::kPatches, Matching::kDescriptors,
                                           Matching::kBoth));

TEST(FeatureTracker, StereoFindsNearlyAllOfAWall) {
  Dive dive(Small());
  const TrackedFrame frame = dive.Swim(0);
  std::size_t in_stereo = 0;
  for (const TrackedPoint& point : frame.points) in_stereo += point.right.has_value() ? 1 : 0;
  // Those at the left edge lie outside the right image.
  EXPECT_GE(in_stereo, frame.points.size() * 3 / 4);
  EXPECT_LT(dive.RmsError(0, frame), 0.2);
}

TEST(FeatureTracker, WorksWithoutPrediction) {
  Dive dive(Small());
  const TrackedFrame first = dive.Swim(0, false);
  for (int k = 1; k < 4; ++k) dive.Swim(k, false);
  const TrackedFrame last = dive.Swim(4, false);
  EXPECT_GE(Shared(first, last), first.points.size() * 3 / 5);
  EXPECT_LT(dive.RmsError(4, last), 0.2);
}

TEST(FeatureTracker, BlankImagesEndTracksButNothingElse) {
  Dive dive(Small());
  dive.Swim(0);
  StereoFrame blank;
  for (cv::Mat& image : blank.images) image = cv::Mat::zeros(300, 400, CV_8UC1);
  const TrackedFrame nothing = dive.See(1, blank);
  EXPECT_TRUE(nothing.points.empty());
  EXPECT_FALSE(nothing.is_keyframe);
  EXPECT_EQ(nothing.empty_quadrants, 4);
  const TrackedFrame afterwards = dive.Swim(2);
  EXPECT_TRUE(afterwards.is_keyframe);
  EXPECT_GE(afterwards.points.size(), 60U);
}

TEST(FeatureTracker, WaitsWhereImagesCannotBeUsed) {
  Dive dive(Small());
  const TrackedFrame first = dive.Swim(0);
  StereoFrame bad = dive.wall().See(PoseAt(1));
  bad.images[1] = cv::Mat::zeros(100, 100, CV_8UC1);
  EXPECT_TRUE(dive.See(1, bad).points.empty());
  bad.images[1] = cv::Mat::zeros(300, 400, CV_32FC1);
  EXPECT_TRUE(dive.See(1, bad).points.empty());
  EXPECT_TRUE(dive.See(1, StereoFrame{}).points.empty());
  EXPECT_GE(Shared(first, dive.Swim(1)), first.points.size() * 4 / 5);
}

TEST(FeatureTracker, RestartForgetsTracksButNeverAnId) {
  Dive dive(Small());
  const TrackedFrame first = dive.Swim(0);
  dive.tracker().Restart();
  const TrackedFrame second = dive.Swim(1);
  EXPECT_TRUE(second.is_keyframe);
  EXPECT_EQ(second.tracked, 0);
  EXPECT_EQ(first.points.front().id, 1U);
  EXPECT_EQ(second.points.front().id, first.points.back().id + 1);
}

TEST(FeatureTracker, IsDeterministic) {
  Dive one(Small()), two(Small());
  for (int k = 0; k < 4; ++k) {
    const TrackedFrame a = one.Swim(k), b = two.Swim(k);
    ASSERT_EQ(a.points.size(), b.points.size());
    for (std::size_t i = 0; i < a.points.size(); ++i) {
      EXPECT_EQ(a.points[i].id, b.points[i].id);
      EXPECT_EQ(a.points[i].left, b.points[i].left);
      EXPECT_EQ(a.points[i].right, b.points[i].right);
      EXPECT_EQ(a.points[i].sigma_px, b.points[i].sigma_px);
    }
  }
}

// For one frame something swims before the cameras; then the wall is back where it was.
std::size_t ComeBack(Matching matching) {
  Dive dive(Small(matching));
  const TrackedFrame first = dive.Swim(0);
  const WallDive other(2.5, 99);
  dive.See(1, other.See(PoseAt(1)));
  for (int k = 2; k < 6; ++k) dive.See(k, other.See(PoseAt(k)));
  TrackedFrame back = dive.Swim(6);
  for (int k = 7; k < 10 && !back.is_keyframe; ++k) back = dive.Swim(k);
  return Shared(first, back);
}

// What places are recognised by: the points that are tracked, as this very frame shows them.
TEST(FeatureTracker, DescribesPointsAtKeyframes) {
  FeatureTracker::Config config = Small();
  config.keyframes.max_gap = 4;
  Dive dive(config);
  const DescriptorExtractor extractor({});
  int keyframes = 0;
  for (int k = 0; k < 6; ++k) {
    const TrackedFrame frame = dive.Swim(k);
    if (!frame.is_keyframe) {
      for (const TrackedPoint& point : frame.points) EXPECT_FALSE(point.descriptor.has_value());
      continue;
    }
    ++keyframes;
    Preprocessor preprocessor({});
    std::vector<Eigen::Vector2d> pixels;
    pixels.reserve(frame.points.size());
    for (const TrackedPoint& point : frame.points) pixels.push_back(point.left);
    const Pose T_WC = PoseAt(k) * dive.wall().geometry().T_IC(0);
    const Eigen::Vector3d down = k == 0 ? Eigen::Vector3d(Eigen::Vector3d::UnitY())
                                        : T_WC.q().conjugate() * -Eigen::Vector3d::UnitZ();
    const auto expected =
        extractor.Describe(preprocessor.Process(dive.wall().See(PoseAt(k)).images[0]), pixels,
                           dive.wall().geometry().camera(0), down);
    int alike = 0, described = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
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

TEST(FeatureTracker, DescriptorsRegainOldIds) {
  EXPECT_EQ(ComeBack(Matching::kPatches), 0U);
  EXPECT_GE(ComeBack(Matching::kBoth), 15U);
}

// The scene stands still but for one piece that is pasted elsewhere: RANSAC drops what is on it.
TEST(FeatureTracker, DropsWhatMovesOnItsOwn) {
  Dive dive(Small());
  const TrackedFrame first = dive.Swim(0);
  StereoFrame moved = dive.wall().See(PoseAt(0));
  const cv::Rect from(150, 100, 100, 80);
  const cv::Mat piece = moved.images[0](from).clone();
  piece.copyTo(moved.images[0](from + cv::Point(8, 8)));
  const auto lookup = [&](LandmarkId id) -> std::optional<Eigen::Vector3d> {
    for (const TrackedPoint& point : first.points) {
      if (point.id == id) return dive.wall().PointAt(PoseAt(0), 0, point.left);
    }
    return std::nullopt;
  };
  const TrackedFrame frame =
      dive.tracker().Track(TimeAt(1), moved, MotionPrediction{PoseAt(0), PoseAt(0)}, lookup);
  EXPECT_GE(frame.points.size(), 40U);
  for (const TrackedPoint& point : frame.points) {
    const auto p_W = lookup(point.id);
    if (!p_W.has_value()) continue;
    const Eigen::Vector2d error = dive.wall().PixelOf(PoseAt(0), 0, *p_W).value() - point.left;
    EXPECT_LT(error.norm(), 3.0);
  }
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
  Preprocessor preprocessor({});
  std::vector<Eigen::Vector2d> pixels;
  pixels.reserve(frame.points.size());
  for (const TrackedPoint& point : frame.points) pixels.push_back(point.left);
  const Pose T_WC = PoseAt(3) * dive.wall().geometry().T_IC(0);
  const auto expected = DescriptorExtractor({}).Describe(
      preprocessor.Process(dive.wall().See(PoseAt(3)).images[0]), pixels,
      dive.wall().geometry().camera(0), T_WC.q().conjugate() * -Eigen::Vector3d::UnitZ());
  for (std::size_t i = 0; i < pixels.size(); ++i)
    EXPECT_EQ(frame.points[i].descriptor, expected[i]) << i;
}

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

TEST(FeatureTracker, RefusesBadConfigurations) {
  FeatureTracker::Config none, unsure, negative;
  none.octaves = 0;
  unsure.sigma.coarse_px = 0.0;
  negative.unfollowed.enough_points = -1;
  for (const FeatureTracker::Config& config : {none, unsure, negative})
    EXPECT_THROW(FeatureTracker(config, HalfRig()), InputError);
}

}  // namespace
}  // namespace drydock::svin2
