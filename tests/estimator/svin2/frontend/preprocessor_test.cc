#include "estimator/svin2/frontend/preprocessor.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "estimator/svin2/frontend/patch_tracker.h"
#include "sensors_models/base/check.h"
#include "tests/estimator/svin2/frontend/synthetic_images.h"

namespace drydock::svin2 {
namespace {

using testing::Draw;
using testing::Texture;

// Haze: a bright veil with little contrast left.
cv::Mat Hazy(double contrast, double noise, std::uint64_t seed = 1) {
  const Texture texture(3);
  return Draw(
      320, 240, [&](const Eigen::Vector2d& p) { return 120.0 + contrast * texture(p); }, noise,
      seed);
}

double Deviation(const cv::Mat& image) {
  cv::Scalar mean, deviation;
  cv::meanStdDev(image, mean, deviation);
  return deviation[0];
}

bool Same(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() && cv::norm(a, b, cv::NORM_L1) == 0.0;
}

Preprocessor::Config Nothing() {
  Preprocessor::Config config;
  config.denoise_sigma_px = config.background_sigma_px = 0.0;
  config.adjust_contrast = false;
  config.clahe = false;
  return config;
}

TEST(Preprocessor, LeavesTheImageAloneWithEverythingOff) {
  const cv::Mat image = Hazy(5.0, 1.0);
  EXPECT_TRUE(Same(Preprocessor(Nothing()).Process(image), image));
}

TEST(Preprocessor, KeepsSizeAndGivesGrey) {
  Preprocessor preprocessor({});
  const cv::Mat grey = Hazy(5.0, 1.0);
  cv::Mat colour;
  cv::cvtColor(grey, colour, cv::COLOR_GRAY2BGR);
  const cv::Mat of_colour = preprocessor.Process(colour);
  EXPECT_EQ(of_colour.type(), CV_8UC1);
  EXPECT_EQ(of_colour.size(), grey.size());
  // Grey stored as colour is the same image; and calls don't influence each other.
  EXPECT_TRUE(Same(of_colour, preprocessor.Process(grey)));
}

// A deviation of 5 grey levels spreads over some +-2.6 deviations between the percentiles 0.5 and
// 99.5, so 26 levels; spread over 255 that is a gain near 10, here capped at 8.
TEST(Preprocessor, ContrastAdjustmentSpreadsHaze) {
  auto config = Nothing();
  config.adjust_contrast = true;
  const cv::Mat image = Hazy(5.0, 0.0);
  EXPECT_NEAR(Deviation(Preprocessor(config).Process(image)) / Deviation(image), 8.0, 0.4);
  config.max_gain = 2.0;
  EXPECT_NEAR(Deviation(Preprocessor(config).Process(image)) / Deviation(image), 2.0, 0.1);
}

TEST(Preprocessor, ABlankImageStaysBlank) {
  const cv::Mat blank(100, 100, CV_8UC1, cv::Scalar(90));
  EXPECT_LT(Deviation(Preprocessor({}).Process(blank)), 1e-9);
}

// The left half is 6 times as hazy as the right. CLAHE makes the contrast of both more alike.
TEST(Preprocessor, ClaheEvensOutContrast) {
  const Texture texture(3);
  const cv::Mat image = Draw(320, 240, [&](const Eigen::Vector2d& p) {
    return 120.0 + (p.x() < 160 ? 4.0 : 24.0) * texture(p);
  });
  const cv::Rect left(20, 20, 100, 200), right(200, 20, 100, 200);
  auto config = Nothing();
  config.clahe = true;
  const cv::Mat evened = Preprocessor(config).Process(image);
  EXPECT_GT(Deviation(evened(left)), 2.0 * Deviation(image(left)));
  EXPECT_LT(Deviation(evened(right)) / Deviation(evened(left)), 4.5);
}

// A veil that is brightest in the middle of the image, as vignetting leaves it.
double Veil(const Eigen::Vector2d& p) {
  return 60.0 *
         std::exp(-(p - Eigen::Vector2d(160.0, 120.0)).squaredNorm() / (2.0 * 120.0 * 120.0));
}

TEST(Preprocessor, TakesTheBackgroundAway) {
  auto config = Nothing();
  config.background_sigma_px = 30.0;
  const auto veil = [](const Eigen::Vector2d& p) { return 40.0 + Veil(p); };
  EXPECT_GT(Deviation(Draw(320, 240, veil)), 10.0);
  EXPECT_LT(Deviation(Preprocessor(config).Process(Draw(320, 240, veil))), 3.0);
  // Texture stays, about the middle of the codes.
  const cv::Mat hazy = Preprocessor(config).Process(Hazy(10.0, 0.0));
  EXPECT_NEAR(Deviation(hazy), Deviation(Hazy(10.0, 0.0)), 0.5);
  EXPECT_NEAR(cv::mean(hazy)[0], 128.0, 1.0);
}

// The scene moves under a veil that stays, which holds back what is tracked.
TEST(Preprocessor, WhatStaysInTheImageHoldsNoTrackBack) {
  constexpr double kShift = 1.5;
  const Texture texture(3);
  const auto scene = [&](double shift, std::uint64_t seed) {
    const auto grey = [&](const Eigen::Vector2d& p) {
      return 60.0 + Veil(p) + 0.7 * texture(p - Eigen::Vector2d(shift, 0.0));
    };
    return Draw(320, 240, grey, 0.3, seed);
  };
  std::vector<Eigen::Vector2d> pixels;
  for (int y = 40; y <= 200; y += 20)
    for (int x = 40; x <= 280; x += 20) pixels.emplace_back(x, y);
  const auto mean_shift = [&](double background_sigma_px) {
    Preprocessor::Config config;
    config.background_sigma_px = background_sigma_px;
    Preprocessor preprocessor(config);
    const PatchTracker tracker({.min_correlation = 0.5});
    const auto tracks =
        tracker.Track(tracker.MakePyramid(preprocessor.Process(scene(0.0, 1))),
                      tracker.MakePyramid(preprocessor.Process(scene(kShift, 2))), pixels, pixels);
    double sum = 0.0;
    int tracked = 0;
    for (std::size_t i = 0; i < tracks.size(); ++i) {
      if (!tracks[i].IsTracked()) continue;
      sum += tracks[i].pixel.x() - pixels[i].x();
      ++tracked;
    }
    EXPECT_GT(tracked, 60);
    return sum / tracked;
  };
  const double held_back = kShift - mean_shift(0.0);
  EXPECT_GT(held_back, 0.1);
  EXPECT_LT(std::abs(kShift - mean_shift(30.0)), held_back / 3.0);
}

// Two exposures of one scene differ by their noise. After white noise went through a Gaussian of
// sigma s, its deviation is 1 / (2 s sqrt(pi)) of what it was: 0.35 for 0.8 px.
TEST(Preprocessor, DenoisingLowersNoise) {
  auto config = Nothing();
  const auto difference = [&config] {
    cv::Mat result;
    Preprocessor preprocessor(config);
    cv::subtract(preprocessor.Process(Hazy(10.0, 4.0, 1)), preprocessor.Process(Hazy(10.0, 4.0, 2)),
                 result, {}, CV_32F);
    return Deviation(result);
  };
  const double before = difference();
  config.denoise_sigma_px = 0.8;
  EXPECT_NEAR(difference() / before, 0.35, 0.04);
}

// The filter's fractions of a grey level must reach the result: on a ramp of 1 level in 8 px and
// noise, filtered and spread eightfold, all codes in between occur, not each eighth only.
TEST(Preprocessor, KeepsFractionsOfGreyLevels) {
  auto config = Nothing();
  config.denoise_sigma_px = 2.0;
  config.adjust_contrast = true;
  const cv::Mat image = Draw(
      320, 240, [](const Eigen::Vector2d& p) { return 100.0 + p.x() / 32.0; }, 0.7);
  const cv::Mat result = Preprocessor(config).Process(image);
  std::vector<int> counts(256);
  for (auto pixel = result.begin<std::uint8_t>(); pixel != result.end<std::uint8_t>(); ++pixel) {
    ++counts[*pixel];
  }
  EXPECT_GT(std::count_if(counts.begin(), counts.end(), [](int n) { return n > 20; }), 60);
}

// Pixel p of the halved image is pixel 2 p: a ramp says so. Noise is lower by far.
TEST(Preprocessor, HalvesBeforeAllElse) {
  const auto ramp = [](const Eigen::Vector2d& p) { return 60.0 + 0.5 * p.x(); };
  const cv::Mat halved = Preprocessor(Nothing()).Process(Draw(200, 100, ramp), 1);
  ASSERT_EQ(halved.size(), cv::Size(100, 50));
  for (const int x : {10, 50, 90}) EXPECT_NEAR(halved.at<std::uint8_t>(25, x), 60.0 + x, 1.0);
  const auto flat = [](const Eigen::Vector2d&) { return 120.0; };
  const cv::Mat noisy = Draw(200, 100, flat, 8.0);
  EXPECT_LT(Deviation(Preprocessor(Nothing()).Process(noisy, 1)), 0.5 * Deviation(noisy));
}

TEST(Preprocessor, RefusesBadConfigurations) {
  Preprocessor::Config config;
  config.low_percentile = 60.0;
  config.high_percentile = 40.0;
  EXPECT_THROW(Preprocessor{config}, InputError);
  config = {};
  config.max_gain = 0.5;
  EXPECT_THROW(Preprocessor{config}, InputError);
  config = {};
  config.denoise_sigma_px = -1.0;
  EXPECT_THROW(Preprocessor{config}, InputError);
  config = {};
  config.background_sigma_px = -1.0;
  EXPECT_THROW(Preprocessor{config}, InputError);
  config = {};
  config.clahe_tiles = 0;
  EXPECT_THROW(Preprocessor{config}, InputError);
}

}  // namespace
}  // namespace drydock::svin2
