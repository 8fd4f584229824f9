#include "sim/optics/lamp_veil.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace drydock::sim {
namespace {

const Pinhole kPinhole{321, 241, 240.0, 160.0, 120.0};

WaterConfig Water() {
  WaterConfig water;
  water.visibility_m = 6.0;
  return water;
}

/// Half a metre to the right, turned inwards.
LampInCamera Lamp() {
  LampInCamera lamp;
  lamp.position_C = {0.5, -0.1, 0.1};
  lamp.axis_C = Eigen::Vector3d(-0.2, 0.1, 1.0).normalized();
  lamp.sharpness = 3.0;
  lamp.intensity = {0.03, 0.04, 0.05};
  return lamp;
}

/// The integral of the header by the midpoint rule, as plainly as can be.
Eigen::Array3d Brute(const LampInCamera& lamp, double u, double v, double range) {
  const WaterConfig water = Water();
  const Eigen::Array3d c = BeamAttenuation(water), b = ScatteringAlbedo(water) * c;
  const Eigen::Vector3d ray =
      Eigen::Vector3d((u - kPinhole.cx) / kPinhole.focal, (v - kPinhole.cy) / kPinhole.focal, 1.0)
          .normalized();
  constexpr int kSteps = 20000;
  Eigen::Array3d sum = Eigen::Array3d::Zero();
  for (int i = 0; i < kSteps; ++i) {
    const double t = 0.05 + (range - 0.05) * (i + 0.5) / kSteps;
    const Eigen::Vector3d from_lamp = t * ray - lamp.position_C;
    const double d = from_lamp.norm();
    const double cosine = from_lamp.normalized().dot(lamp.axis_C);
    if (cosine <= 0.0) continue;
    const double turned = -from_lamp.normalized().dot(ray);
    sum += lamp.intensity * std::exp(lamp.sharpness * (cosine - 1.0)) / (d * d) *
           PhaseFunction(turned) * (-c * (d + t)).exp();
  }
  return std::numbers::pi * b * sum * (range - 0.05) / kSteps;
}

// What is scattered anywhere is all there is; in natural waters 1.3 to 2 % goes backwards.
TEST(PhaseFunction, ScattersEverythingSomewhere) {
  double all = 0.0, back = 0.0;
  constexpr int kSteps = 200000;
  for (int i = 0; i < kSteps; ++i) {
    const double cosine = -1.0 + 2.0 * (i + 0.5) / kSteps;
    const double share = 2.0 * std::numbers::pi * PhaseFunction(cosine) * 2.0 / kSteps;
    all += share;
    if (cosine < 0.0) back += share;
  }
  EXPECT_NEAR(all, 1.0, 1e-3);
  EXPECT_GT(back, 0.013);
  EXPECT_LT(back, 0.020);
}

TEST(LampVeil, IsTheIntegralOfSingleScattering) {
  const LampVeil veil(Water(), kPinhole, {Lamp()});
  for (const double range : {0.4, 1.0, 3.0, 8.0}) {
    const Eigen::Array3d expected = Brute(Lamp(), 200.0, 90.0, range);
    EXPECT_TRUE(veil.Integrate(200.0, 90.0, range).isApprox(expected, 2e-3)) << range;
  }
}

TEST(LampVeil, TheTableIsCloseToTheIntegral) {
  LampVeil veil(Water(), kPinhole, {Lamp()});
  std::vector<float> range(321), sum(321);
  for (const int v : {10, 75, 121, 230}) {
    for (const float r : {0.35F, 0.8F, 2.F, 5.F}) {
      std::fill(range.begin(), range.end(), r);
      std::fill(sum.begin(), sum.end(), 0.F);
      veil.AddRow(v, range.data(), {0.F, 1.F, 0.F}, sum.data());
      // 3 % of the brightest: it is smooth light.
      const double brightest = *std::max_element(sum.begin(), sum.end());
      for (const int u : {5, 90, 160, 250, 310}) {
        const double expected = veil.Integrate(u, v, r)[1];
        EXPECT_NEAR(sum[static_cast<std::size_t>(u)], expected, 0.04 * brightest)
            << u << ", " << v << " at " << r << " m";
      }
    }
  }
}

TEST(LampVeil, IsBrighterOnTheLampsSideAndGrowsWithRange) {
  LampVeil veil(Water(), kPinhole, {Lamp()});
  const auto at = [&](float u, float r) {
    std::vector<float> range(321, r), sum(321, 0.F);
    veil.AddRow(120, range.data(), {0.3F, 0.45F, 0.25F}, sum.data());
    return sum[static_cast<std::size_t>(u)];
  };
  EXPECT_GT(at(300, 4.F), 1.5F * at(20, 4.F));
  EXPECT_GT(at(160, 1.F), at(160, 0.5F));
  EXPECT_GT(at(160, 4.F), at(160, 1.F));
  EXPECT_NEAR(at(160, 9.F), at(160, 11.F), 0.01F * at(160, 9.F));
}

TEST(LampVeil, ClearWaterHasNone) {
  WaterConfig clear;
  clear.visibility_m = 0.0;
  LampVeil veil(clear, kPinhole, {Lamp()});
  std::vector<float> range(321, 5.F), sum(321, 0.F);
  veil.AddRow(120, range.data(), {1.F, 1.F, 1.F}, sum.data());
  for (const float light : sum) EXPECT_EQ(light, 0.F);
}

}  // namespace
}  // namespace drydock::sim
