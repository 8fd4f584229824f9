#include "estimator/svin2/initialisation/depth_scale.h"

#include <cmath>

#include <gtest/gtest.h>

#include "sensors_models/base/random_stream.h"

namespace drydock::svin2 {
namespace {

using Eigen::Vector3d;

constexpr std::int64_t kMs = 1'000'000;
const Vector3d kPIC(0.1, 0.0, 0.0);

// A camera 0.1 m ahead of the body sinks at 0.4 m/s and swims at `ahead`, in truth; vision sees
// all of it larger by 1 / `scale`.
VisualHeights Sinking(double ahead, double scale) {
  VisualHeights vision;
  for (std::int64_t k = 0; k <= 15; ++k) {
    const double s = 0.2 * static_cast<double>(k);
    vision.t.push_back({k * 200 * kMs});
    vision.T_VI.emplace_back(Eigen::Quaterniond::Identity(),
                             Vector3d(ahead * s, 0.0, -0.4 * s) / scale);
  }
  return vision;
}

std::vector<TimedDepth> Readings(const DepthSheet& sheet, int count = 3) {
  std::vector<TimedDepth> readings;
  for (std::int64_t k = 0; k < count; ++k) {
    // 7 m is any depth to begin with. The lag makes the reading late.
    const double s = 0.1 + static_cast<double>(k);
    readings.push_back({Time::FromSeconds(s + sheet.lag_s), 7.0 + 0.4 * s});
  }
  return readings;
}

DepthSheet Sheet() {
  DepthSheet sheet;
  sheet.rate_hz = 1.0;
  sheet.noise_m = 0.003;
  sheet.lag_s = 0.05;
  return sheet;
}

TEST(DepthScale, IsTheFactorThatFits) {
  const DepthSheet sheet = Sheet();
  const auto scale = ScaleFromDepth(Readings(sheet), Sinking(0.0, 1.05), kPIC, sheet, {});
  ASSERT_TRUE(scale.has_value());
  EXPECT_NEAR(scale->value, 1.05, 1e-9);
  // Readings at heights -d, 0 and d about their mean, by vision d = 0.4 / 1.05 m: the sum of
  // squares is 2 d^2; a reading has 3 mm of its own and 2 mm of vision's.
  EXPECT_NEAR(scale->sigma, std::hypot(0.003, 0.002) / (std::sqrt(2.0) * 0.4 / 1.05), 1e-9);
}

// A path ahead of 0.8 m/s at 0.4 m/s down: with up tilted by 0.01 rad towards it, heights change by
// 0.01 * 0.8 / 0.4 = 2 %.
TEST(DepthScale, CountsTheTiltWhereTheWayGoesSideways) {
  DepthSheet sheet = Sheet();
  sheet.noise_m = 1e-9;
  DepthScaleConfig config;
  config.height_sigma_m = 1e-9;
  VisualHeights vision = Sinking(0.8, 1.0);
  vision.tilt_sigma_rad = 0.01;
  const auto level = ScaleFromDepth(Readings(sheet), vision, kPIC, sheet, config);
  ASSERT_TRUE(level.has_value());
  EXPECT_NEAR(level->value, 1.0, 1e-9);
  EXPECT_NEAR(level->sigma, 0.02, 1e-6);
  vision.up_V = Vector3d(0.01, 0.0, 1.0).normalized();
  const auto tilted = ScaleFromDepth(Readings(sheet), vision, kPIC, sheet, config);
  EXPECT_NEAR(tilted->value, 1.02, 1e-3);
}

// Turning about y moves the port, 0.4 m behind the camera, by 0.4 m times the sine, unscaled.
TEST(DepthScale, KnowsTheLeverArm) {
  DepthSheet sheet = Sheet();
  sheet.lag_s = 0.0;
  sheet.p_ID = {-0.3, 0.0, 0.0};
  VisualHeights vision;
  std::vector<TimedDepth> readings;
  for (std::int64_t k = 0; k <= 15; ++k) {
    const double s = 0.2 * static_cast<double>(k);
    const Eigen::Quaterniond q = FromYawPitchRoll(0.0, 0.2 * s, 0.0);
    const Vector3d camera(0.3 * s, 0.0, -0.4 * s);
    vision.t.push_back({k * 200 * kMs});
    vision.T_VI.emplace_back(q, camera / 1.1 - q * kPIC);
    if (k % 5 == 0) readings.push_back({{k * 200 * kMs}, 3.0 + 0.4 * s - 0.4 * std::sin(0.2 * s)});
  }
  const auto scale = ScaleFromDepth(readings, vision, kPIC, sheet, {});
  ASSERT_TRUE(scale.has_value());
  EXPECT_NEAR(scale->value, 1.1, 1e-9);
}

TEST(DepthScale, GoesBetweenFramesByACubic) {
  // Heights by a parabola, readings halfway between frames: chords would be 0.5 * 1 * 0.1^2 = 5 mm
  // off.
  DepthSheet sheet = Sheet();
  sheet.lag_s = 0.0;
  VisualHeights vision;
  std::vector<TimedDepth> readings;
  for (std::int64_t k = 0; k <= 10; ++k) {
    const double s = 0.2 * static_cast<double>(k);
    vision.t.push_back({k * 200 * kMs});
    vision.T_VI.emplace_back(Eigen::Quaterniond::Identity(), Vector3d(0.0, 0.0, 0.5 * s * s));
    readings.push_back({{k * 200 * kMs + 100 * kMs}, -0.5 * (s + 0.1) * (s + 0.1)});
  }
  const auto scale = ScaleFromDepth(readings, vision, kPIC, sheet, {});
  ASSERT_TRUE(scale.has_value());
  EXPECT_NEAR(scale->value, 1.0, 1e-9);
}

TEST(DepthScale, SaysNothingWithoutExcursionOrReadings) {
  const DepthSheet sheet = Sheet();
  const VisualHeights vision = Sinking(0.0, 1.0);
  EXPECT_FALSE(ScaleFromDepth({}, vision, kPIC, sheet, {}).has_value());
  EXPECT_FALSE(ScaleFromDepth(Readings(sheet, 1), vision, kPIC, sheet, {}).has_value());
  DepthScaleConfig config;
  config.min_excursion_m = 0.81;  // Three readings go through 0.8 m.
  EXPECT_FALSE(ScaleFromDepth(Readings(sheet), vision, kPIC, sheet, config).has_value());
  auto late = Readings(sheet);
  for (TimedDepth& reading : late) reading.t = reading.t + Duration{10'000 * kMs};
  EXPECT_FALSE(ScaleFromDepth(late, vision, kPIC, sheet, {}).has_value());
}

TEST(DepthScale, BeliefsCombineByTheirWeights) {
  // Information 1 and 4: the mean lies at four fifths.
  const ScaleEstimate both = Combine({1.0, 1.0}, {2.0, 0.5});
  EXPECT_NEAR(both.value, 1.8, 1e-12);
  EXPECT_NEAR(both.sigma, std::sqrt(1.0 / 5.0), 1e-12);
}

}  // namespace
}  // namespace drydock::svin2
