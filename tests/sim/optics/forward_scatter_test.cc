#include "sim/optics/forward_scatter.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

namespace drydock::sim {
namespace {

constexpr double kFocal = 575.0;
constexpr int kSize = 257;
constexpr int kMiddle = 128;

/// What becomes of a bright vertical line at `range`.
cv::Mat BlurredLine(const WaterConfig& water, double range) {
  cv::Mat line(kSize, kSize, CV_32FC1, cv::Scalar(0.0));
  line.col(kMiddle).setTo(1.0);
  cv::Mat seen(kSize, kSize, CV_32FC1, cv::Scalar(0.0));
  ForwardScatter scatter(water, kFocal);
  scatter.AddTo(line, cv::Mat(kSize, kSize, CV_32FC1, cv::Scalar(range)), seen);
  return seen.row(kMiddle).clone();
}

/// Total light and variance across the line [px^2].
std::pair<double, double> Moments(const cv::Mat& row) {
  double light = 0.0, variance = 0.0;
  for (int u = 0; u < row.cols; ++u) {
    light += row.at<float>(0, u);
    variance += row.at<float>(0, u) * std::pow(u - kMiddle, 2.0);
  }
  return {light, variance / light};
}

// The spread of all light, sharp and bent, is tau (focal theta)^2 / 3: in proportion to the range.
// No light is lost.
TEST(ForwardScatter, SpreadGrowsWithRange) {
  WaterConfig water;
  water.visibility_m = 6.0;
  const double bend = kFocal * water.forward_scatter_deg * std::numbers::pi / 180.0;
  const double b = (ScatteringAlbedo(water) * BeamAttenuation(water))[1];
  for (const double range : {1.0, 2.0, 4.0, 6.0}) {
    const auto [light, variance] = Moments(BlurredLine(water, range));
    const double tau = water.forward_scatter * b * range;
    EXPECT_NEAR(light, 1.0, 1e-3) << range;
    EXPECT_NEAR(variance / (tau * bend * bend / 3.0), 1.0, 0.05) << range;
  }
}

// What is not bent, exp(-tau), stays within its pixel.
TEST(ForwardScatter, TheRestStaysSharp) {
  WaterConfig water;
  water.visibility_m = 6.0;
  const double b = (ScatteringAlbedo(water) * BeamAttenuation(water))[1];
  const double sharp = std::exp(-water.forward_scatter * b * 3.0);
  const cv::Mat row = BlurredLine(water, 3.0);
  EXPECT_NEAR(row.at<float>(0, kMiddle) - row.at<float>(0, kMiddle + 1), sharp, 0.01);
}

TEST(ForwardScatter, NoneIsNone) {
  WaterConfig water;
  water.forward_scatter = 0.0;
  EXPECT_EQ(BlurredLine(water, 5.0).at<float>(0, kMiddle), 1.F);
  EXPECT_EQ(BlurredLine(water, 5.0).at<float>(0, kMiddle + 1), 0.F);
}

}  // namespace
}  // namespace drydock::sim
