#include "estimator/svin2/frontend/patch_tracker.h"

#include <Eigen/LU>
#include <cmath>

#include <gtest/gtest.h>

#include "sensors_models/base/check.h"
#include "tests/estimator/svin2/frontend/synthetic_images.h"

namespace drydock::svin2 {
namespace {

using testing::Draw;
using testing::Texture;

constexpr int kWidth = 320, kHeight = 240;

std::vector<Eigen::Vector2d> Grid() {
  std::vector<Eigen::Vector2d> pixels;
  for (int y = 60; y <= 180; y += 30) {
    for (int x = 60; x <= 260; x += 40) pixels.emplace_back(x + 0.3, y - 0.4);
  }
  return pixels;
}

// An affine map of the image plane about the image's middle.
struct Warp {
  Eigen::Matrix2d A = Eigen::Matrix2d::Identity();
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();

  Eigen::Vector2d operator()(const Eigen::Vector2d& p) const {
    const Eigen::Vector2d middle(0.5 * kWidth, 0.5 * kHeight);
    return A * (p - middle) + middle + shift;
  }
  Warp Inverse() const { return {A.inverse(), -(A.inverse() * shift)}; }
};

cv::Mat Before() {
  const Texture texture(21);
  return Draw(
      kWidth, kHeight, [&](const Eigen::Vector2d& p) { return 120.0 + 30.0 * texture(p); }, 1.0, 1);
}

// The same scene, warped, with its brightness b and contrast c changed.
cv::Mat After(const Warp& warp, double contrast = 1.0, double brightness = 0.0) {
  const Texture texture(21);
  const Warp inverse = warp.Inverse();
  return Draw(
      kWidth, kHeight,
      [&](const Eigen::Vector2d& p) {
        return 120.0 + brightness + contrast * 30.0 * texture(inverse(p));
      },
      1.0, 2);
}

struct Errors {
  double rms = 0.0;
  std::size_t tracked = 0;
};

Errors TrackAcross(const Warp& warp, const cv::Mat& after,
                   const PatchTracker::Config& config = {}) {
  const PatchTracker tracker(config);
  const auto pixels = Grid();
  const auto tracks =
      tracker.Track(tracker.MakePyramid(Before()), tracker.MakePyramid(after), pixels, pixels);
  Errors errors;
  double squares = 0.0;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (!tracks[i].IsTracked()) continue;
    ++errors.tracked;
    squares += (tracks[i].pixel - warp(pixels[i])).squaredNorm();
  }
  errors.rms = std::sqrt(squares / static_cast<double>(std::max<std::size_t>(errors.tracked, 1)));
  return errors;
}

TEST(PatchTracker, FollowsShiftsToATenthOfAPixel) {
  for (const Eigen::Vector2d& shift :
       {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(0.37, -0.81), Eigen::Vector2d(7.5, 4.25)}) {
    const Warp warp{.shift = shift};
    const Errors errors = TrackAcross(warp, After(warp));
    EXPECT_GE(errors.tracked, 28U);  // Of 30.
    EXPECT_LT(errors.rms, 0.1);
  }
}

// Turned by 4 degrees, stretched by 5 % along x, sheared.
TEST(PatchTracker, FollowsAffineDeformation) {
  Warp warp{.shift = {1.3, -2.6}};
  const double angle = 0.07;
  warp.A << 1.05 * std::cos(angle), -std::sin(angle) + 0.02, 1.05 * std::sin(angle),
      std::cos(angle);
  const Errors errors = TrackAcross(warp, After(warp), {.affine = true});
  EXPECT_GE(errors.tracked, 28U);
  EXPECT_LT(errors.rms, 0.1);
}

TEST(PatchTracker, FollowsThroughChangesOfBrightnessAndContrast) {
  const Warp warp{.shift = {2.4, -1.7}};
  const Errors errors = TrackAcross(warp, After(warp, 0.8, 10.0));
  EXPECT_GE(errors.tracked, 28U);
  EXPECT_LT(errors.rms, 0.1);
}

TEST(PatchTracker, APredictionHelpsFarShifts) {
  const Warp warp{.shift = {60.4, 20.7}};
  const PatchTracker tracker({.levels = 1});
  const auto from = tracker.MakePyramid(Before()), to = tracker.MakePyramid(After(warp));
  const std::vector<Eigen::Vector2d> pixels = {{100.0, 100.0}, {150.0, 120.0}};
  for (const PatchTrack& track : tracker.Track(from, to, pixels, pixels)) {
    EXPECT_FALSE(track.IsTracked() && (track.pixel - warp(pixels[0])).norm() < 1.0);
  }
  std::vector<Eigen::Vector2d> predicted;
  predicted.reserve(pixels.size());
  for (const auto& pixel : pixels) predicted.push_back(warp(pixel) + Eigen::Vector2d(1.5, -1.0));
  const auto tracks = tracker.Track(from, to, pixels, predicted);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    ASSERT_TRUE(tracks[i].IsTracked());
    EXPECT_LT((tracks[i].pixel - warp(pixels[i])).norm(), 0.2);
  }
}

// Another scene altogether, and one where the patch has been covered.
TEST(PatchTracker, RejectsWhatIsNotThere) {
  const Texture other(99);
  const cv::Mat elsewhere = Draw(
      kWidth, kHeight, [&](const Eigen::Vector2d& p) { return 120.0 + 30.0 * other(p); }, 1.0);
  EXPECT_LE(TrackAcross({}, elsewhere).tracked, 1U);
  const cv::Mat blank(kHeight, kWidth, CV_8UC1, cv::Scalar(120));
  EXPECT_EQ(TrackAcross({}, blank).tracked, 0U);
}

TEST(PatchTracker, RejectsWhatLeavesTheImage) {
  const PatchTracker tracker({});
  const auto pyramid = tracker.MakePyramid(Before());
  const auto tracks = tracker.Track(pyramid, pyramid, {{-4.0, 20.0}, {100.0, 100.0}},
                                    {{10.0, 20.0}, {500.0, 100.0}});
  EXPECT_EQ(tracks[0].status, TrackStatus::kOutside);
  EXPECT_EQ(tracks[1].status, TrackStatus::kOutside);
  EXPECT_TRUE(tracker.Track(pyramid, pyramid, {}, {}).empty());
}

TEST(PatchTracker, SaysHowAlikePatchesAre) {
  const PatchTracker tracker({});
  const auto pyramid = tracker.MakePyramid(Before());
  const auto tracks = tracker.Track(pyramid, pyramid, {{100.0, 100.0}}, {{100.5, 99.0}});
  ASSERT_TRUE(tracks[0].IsTracked());
  EXPECT_NEAR(tracks[0].correlation, 1.0, 1e-3);
  // Whatever the correlation, it is never above 1.
  const PatchTracker strict({.min_correlation = 1.001});
  EXPECT_EQ(strict.Track(pyramid, pyramid, {{100.0, 100.0}}, {{100.5, 99.0}})[0].status,
            TrackStatus::kUnlike);
}

// Shifted by whole pixels of the coarsest octave, so that each level is shifted alike; the fine
// level is noise, in which octave 0 finds nothing.
TEST(PatchTracker, FollowsAPatchAtItsOctave) {
  const Warp warp{.shift = {8.0, -4.0}};
  const PatchTracker tracker({});
  const cv::Mat noise = Draw(
      kWidth, kHeight, [](const Eigen::Vector2d&) { return 120.0; }, 20.0, 5);
  const cv::Mat other = Draw(
      kWidth, kHeight, [](const Eigen::Vector2d&) { return 120.0; }, 20.0, 6);
  ImagePyramid from = tracker.MakePyramid(Before()), to = tracker.MakePyramid(After(warp));
  from[0] = tracker.MakePyramid(noise)[0];
  to[0] = tracker.MakePyramid(other)[0];
  const std::vector<Eigen::Vector2d> pixels = {{120.0, 100.0}, {160.0, 120.0}, {200.0, 140.0}};
  const auto tracks = tracker.Track(from, to, pixels, pixels, {1, 0, 2});
  ASSERT_TRUE(tracks[0].IsTracked());
  EXPECT_LT((tracks[0].pixel - warp(pixels[0])).norm(), 0.2);
  EXPECT_FALSE(tracks[1].IsTracked());
  // Beyond the last level there is nothing.
  EXPECT_FALSE(tracker.Track(from, to, {pixels[0]}, {pixels[0]}, {9})[0].IsTracked());
}

TEST(PatchTracker, RefusesBadConfigurations) {
  EXPECT_THROW(PatchTracker({.window_px = 20}), InputError);
  EXPECT_THROW(PatchTracker({.levels = 0}), InputError);
}

}  // namespace
}  // namespace drydock::svin2
