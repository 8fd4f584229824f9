#include "sim/optics/underwater_optics.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

namespace drydock::sim {
namespace {

const Pinhole kPinhole{201, 151, 150.0, 100.0, 75.0};
/// Camera that looks along W's x axis, upright.
const Pose kForward(Eigen::Quaterniond(0.5, -0.5, 0.5, -0.5), {0, 0, 0});

/// A wall of one albedo (sRGB code) that faces the camera at `depth`.
RawImage Wall(float depth, unsigned char code) {
  RawImage raw;
  raw.albedo = cv::Mat(kPinhole.height, kPinhole.width, CV_8UC3, cv::Scalar::all(code));
  raw.depth = cv::Mat(kPinhole.height, kPinhole.width, CV_32FC1, cv::Scalar(depth));
  return raw;
}

/// The camera swims just under the surface, where daylight is full. There is no blur, so that each
/// pixel stands for itself.
WaterConfig Water(double visibility_m) {
  WaterConfig water;
  water.visibility_m = visibility_m;
  water.surface_z_m = 0.0;
  water.forward_scatter = 0.0;
  return water;
}

cv::Mat See(const WaterConfig& water, const RawImage& raw, const Pose& T_WC = kForward) {
  UnderwaterOptics optics(water, kPinhole, nullptr);
  cv::Mat radiance;
  optics.Apply(raw, T_WC, ImageChannels::kColor, radiance);
  return radiance.clone();
}

cv::Vec3f Centre(const cv::Mat& radiance) { return radiance.at<cv::Vec3f>(75, 100); }

// White minus black cancels the veil: what is left is Beer-Lambert's law.
TEST(UnderwaterOptics, SignalFollowsBeerLambert) {
  const WaterConfig water = Water(12.0);
  const auto signal = [&](float range) {
    return Centre(See(water, Wall(range, 255))) - Centre(See(water, Wall(range, 0)));
  };
  const cv::Vec3f near = signal(0.5F);
  for (const float range : {1.F, 2.F, 4.F, 8.F}) {
    const cv::Vec3f far = signal(range);
    for (int channel = 0; channel < 3; ++channel) {
      const double expected = std::exp(-BeamAttenuation(water)[channel] * (range - 0.5));
      EXPECT_NEAR(far[channel] / near[channel], expected, 1e-4 * expected)
          << range << " m, channel " << channel;
    }
  }
}

TEST(UnderwaterOptics, RangeCountsAlongTheRayNotTheAxis) {
  const WaterConfig water = Water(6.0);
  const cv::Mat black = See(water, Wall(2.F, 0)), white = See(water, Wall(2.F, 255));
  // At the middle of the left edge, whose ray is level, the light goes a longer way.
  const double longer = 2.0 * (std::sqrt(1.0 + std::pow(100.0 / 150.0, 2)) - 1.0);
  const float edge = (white.at<cv::Vec3f>(75, 0) - black.at<cv::Vec3f>(75, 0))[1];
  const float middle = (Centre(white) - Centre(black))[1];
  EXPECT_NEAR(edge / middle, std::exp(-BeamAttenuation(water)[1] * longer), 1e-4);
}

TEST(UnderwaterOptics, TheVeilTendsToThatOfDeepWater) {
  const WaterConfig water = Water(6.0);
  const cv::Vec3f deep = Centre(See(water, Wall(std::numeric_limits<float>::infinity(), 0)));
  for (int channel = 0; channel < 3; ++channel) {
    EXPECT_NEAR(deep[channel], water.veil * ScatteringAlbedo(water)[channel], 1e-5);
    const double c = BeamAttenuation(water)[channel];
    for (const float range : {1.F, 3.F, 9.F}) {
      EXPECT_NEAR(Centre(See(water, Wall(range, 0)))[channel],
                  deep[channel] * (1.0 - std::exp(-c * range)), 1e-5);
    }
  }
}

TEST(UnderwaterOptics, VisibilityIsWhatItSays) {
  // Koschmieder: a black object against the water behind it.
  for (const double visibility : {3.0, 6.0, 12.0}) {
    const WaterConfig water = Water(visibility);
    const float background = Centre(See(water, Wall(std::numeric_limits<float>::infinity(), 0)))[1];
    const float object = Centre(See(water, Wall(static_cast<float>(visibility), 0)))[1];
    EXPECT_NEAR((background - object) / background, 0.02, 0.0005);
  }
}

TEST(UnderwaterOptics, ClearWaterShowsTheAlbedo) {
  WaterConfig water = Water(0.0);
  water.sun_share = 0.0;
  const RawImage raw = Wall(5.F, 188);  // sRGB 188 is linear 0.5029.
  const cv::Vec3f seen = Centre(See(water, raw));
  // A wall gets 0.625 of the diffuse light that a floor gets.
  for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(seen[channel], 0.5029 * 0.625, 1e-4);
  EXPECT_EQ(Centre(See(water, Wall(std::numeric_limits<float>::infinity(), 188))),
            cv::Vec3f(0, 0, 0));
}

// A floor seen from above at a slant: its normal must come out of the depth image as W's z axis.
TEST(UnderwaterOptics, FloorsFaceUpwards) {
  WaterConfig water = Water(0.0);
  water.sun_share = 1.0;
  water.sun_azimuth_deg = 30.0;
  water.sun_elevation_deg = 60.0;
  const Pose T_WC = Pose(FromYawPitchRoll(0.4, 0.9, 0.1), {0, 0, 2}) * kForward;
  RawImage raw = Wall(0.F, 255);
  for (int v = 0; v < kPinhole.height; ++v) {
    for (int u = 0; u < kPinhole.width; ++u) {
      const Eigen::Vector3d ray((u - kPinhole.cx) / kPinhole.focal,
                                (v - kPinhole.cy) / kPinhole.focal, 1.0);
      raw.depth.at<float>(v, u) = static_cast<float>(-2.0 / (T_WC.q() * ray).z());
    }
  }
  const cv::Mat radiance = See(water, raw, T_WC);
  const double expected = std::sin(60.0 * std::numbers::pi / 180.0);
  for (int v = 5; v < kPinhole.height; v += 10) {
    for (int u = 5; u < kPinhole.width; u += 10)
      EXPECT_NEAR(radiance.at<cv::Vec3f>(v, u)[1], expected, 2e-3);
  }
}

TEST(UnderwaterOptics, ItIsBrighterUpwards) {
  const Pose tilted = Pose(FromYawPitchRoll(0.0, -0.3, 0.0), {0, 0, 0}) * kForward;
  const RawImage open = Wall(std::numeric_limits<float>::infinity(), 0);
  EXPECT_GT(Centre(See(Water(12.0), open, tilted))[1], 1.02F * Centre(See(Water(12.0), open))[1]);
}

// All light, that of surfaces and that of the veil, fades with the camera's depth as exp(-Kd
// depth).
TEST(UnderwaterOptics, DaylightFadesWithDepth) {
  WaterConfig water = Water(12.0);
  const RawImage raw = Wall(2.F, 200);
  const cv::Vec3f shallow = Centre(See(water, raw));
  water.surface_z_m = 10.0;
  water.daylight = 0.5;
  const cv::Vec3f deep = Centre(See(water, raw));
  for (int channel = 0; channel < 3; ++channel) {
    const double expected = 0.5 * std::exp(-10.0 * DiffuseAttenuation(water)[channel]);
    EXPECT_NEAR(deep[channel] / shallow[channel], expected, 1e-5);
  }
}

TEST(UnderwaterOptics, MonochromeIsAWeightedSum) {
  UnderwaterOptics optics(Water(12.0), kPinhole, nullptr);
  cv::Mat color, monochrome;
  optics.Apply(Wall(2.F, 200), kForward, ImageChannels::kColor, color);
  optics.Apply(Wall(2.F, 200), kForward, ImageChannels::kMonochrome, monochrome);
  const cv::Vec3f c = Centre(color);
  EXPECT_NEAR(monochrome.at<float>(75, 100), 0.30F * c[0] + 0.45F * c[1] + 0.25F * c[2], 1e-6);
}

}  // namespace
}  // namespace drydock::sim
