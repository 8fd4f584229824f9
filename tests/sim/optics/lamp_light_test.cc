#include "sim/optics/lamp_light.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "sim/optics/underwater_optics.h"
#include "tests/support/input_error.h"

namespace drydock::sim {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
const Pinhole kPinhole{201, 151, 150.0, 100.0, 75.0};
/// The camera looks along the body's x axis, upright, from the body's origin.
const Pose kT_IC(Eigen::Quaterniond(0.5, -0.5, 0.5, -0.5), {0, 0, 0});

/// Nothing but lamps, and no blur, so that each pixel stands for itself.
WaterConfig DarkWater(double visibility_m) {
  WaterConfig water;
  water.visibility_m = visibility_m;
  water.daylight = 0.0;
  water.forward_scatter = 0.0;
  return water;
}

/// At the camera's centre of projection, along its axis.
LampConfig CentralLamp() {
  LampConfig lamp;
  lamp.beam_deg = 60.0;
  lamp.intensity_cd = 5000.0;
  return lamp;
}

RawImage Wall(float depth, unsigned char code) {
  RawImage raw;
  raw.albedo = cv::Mat(kPinhole.height, kPinhole.width, CV_8UC3, cv::Scalar::all(code));
  raw.depth = cv::Mat(kPinhole.height, kPinhole.width, CV_32FC1, cv::Scalar(depth));
  return raw;
}

cv::Mat See(const WaterConfig& water, const std::vector<LampConfig>& lamps, const RawImage& raw,
            ImageChannels channels = ImageChannels::kColor) {
  UnderwaterOptics optics(water, kPinhole, nullptr,
                          LampLight(lamps, kT_IC, water, kPinhole, nullptr));
  cv::Mat radiance;
  optics.Apply(raw, kT_IC, channels, radiance);
  return radiance.clone();
}

/// What a white wall sends beyond a black one: the veil cancels.
cv::Vec3f SignalAt(const WaterConfig& water, const std::vector<LampConfig>& lamps, float depth,
                   int u, int v) {
  return See(water, lamps, Wall(depth, 255)).at<cv::Vec3f>(v, u) -
         See(water, lamps, Wall(depth, 0)).at<cv::Vec3f>(v, u);
}

TEST(LampLight, FallsWithTheSquareOfDistanceAndFadesBothWays) {
  const WaterConfig water = DarkWater(8.0);
  for (const float range : {0.5F, 1.F, 3.F, 6.F}) {
    const cv::Vec3f signal = SignalAt(water, {CentralLamp()}, range, 100, 75);
    for (int channel = 0; channel < 3; ++channel) {
      const double c = BeamAttenuation(water)[channel];
      const double expected = 5000.0 / kFullSunLux / (range * range) * std::exp(-2.0 * c * range);
      EXPECT_NEAR(signal[channel], expected, 1e-4 * expected) << range << " m, " << channel;
    }
  }
}

TEST(LampLight, HasHalfItsIntensityAtHalfTheBeam) {
  const WaterConfig water = DarkWater(0.0);
  // 30 degrees off the axis, to the right.
  const int u = 100 + static_cast<int>(std::lround(150.0 * std::tan(30.0 * kDegree)));
  const double tangent = (u - 100) / 150.0;
  const double cosine = 1.0 / std::sqrt(1.0 + tangent * tangent);
  const double z = 2.0;
  const double d = z / cosine;
  const double signal = SignalAt(water, {CentralLamp()}, static_cast<float>(z), u, 75)[1];
  // Irradiance falls with the incidence on the wall, too.
  EXPECT_NEAR(signal, 0.5 * 0.05 * cosine / (d * d), 0.02 * signal);
}

TEST(LampLight, ShinesWhereItPointsAndNotBehind) {
  const WaterConfig water = DarkWater(0.0);
  LampConfig lamp = CentralLamp();
  lamp.beam_deg = 40.0;
  const auto brightest = [&](double yaw_deg, double pitch_deg) {
    lamp.yaw_deg = yaw_deg;
    lamp.pitch_deg = pitch_deg;
    std::vector<cv::Mat> planes;
    cv::split(See(water, {lamp}, Wall(2.F, 255)), planes);
    cv::Point at;
    cv::minMaxLoc(planes[1], nullptr, nullptr, nullptr, &at);
    return at;
  };
  EXPECT_LT(brightest(20.0, 0.0).x, 75);  // Left is positive.
  EXPECT_GT(brightest(-20.0, 0.0).x, 125);
  EXPECT_GT(brightest(0.0, 15.0).y, 90);  // Down is positive.
  lamp.yaw_deg = 180.0;
  EXPECT_EQ(cv::norm(See(water, {lamp}, Wall(2.F, 255))), 0.0);
}

// A surface that is turned away from the lamp gets none of its light although the camera sees it.
TEST(LampLight, FollowsTheCosineOfIncidence) {
  const WaterConfig water = DarkWater(0.0);
  LampConfig lamp = CentralLamp();
  lamp.position_m = {0.0, 1.0, 0.0};  // To the left: -x of C.
  lamp.yaw_deg = -20.0;
  RawImage raw = Wall(0.F, 255);
  // A plane with normal (sin a, 0, -cos a) in C through (0, 0, 2).
  for (const double angle : {-40.0, 0.0, 30.0, 70.0}) {
    const Eigen::Vector3d n(std::sin(angle * kDegree), 0.0, -std::cos(angle * kDegree));
    for (int v = 0; v < kPinhole.height; ++v) {
      for (int u = 0; u < kPinhole.width; ++u) {
        const Eigen::Vector3d ray((u - 100) / 150.0, (v - 75) / 150.0, 1.0);
        raw.depth.at<float>(v, u) =
            static_cast<float>(-2.0 * std::cos(angle * kDegree) / n.dot(ray));
      }
    }
    const Eigen::Vector3d to_lamp = Eigen::Vector3d(-1, 0, 0) - Eigen::Vector3d(0, 0, 2);
    const double off_axis = -to_lamp.normalized().dot(
        Eigen::Vector3d(std::sin(20.0 * kDegree), 0.0, std::cos(20.0 * kDegree)));
    const double expected = 0.05 * std::exp(SharpnessOf(lamp) * (off_axis - 1.0)) *
                            std::max(0.0, n.dot(to_lamp.normalized())) / to_lamp.squaredNorm();
    const double seen = See(water, {lamp}, raw).at<cv::Vec3f>(75, 100)[1];
    EXPECT_NEAR(seen, expected, 5e-3 * expected + 1e-9) << angle;
  }
}

TEST(LampLight, SumsOverLampsAndChannels) {
  const WaterConfig water = DarkWater(6.0);
  LampConfig left = CentralLamp(), right = CentralLamp();
  left.position_m.y() = 0.3;
  right.position_m.y() = -0.2;
  right.color = {0.5, 1.0, 2.0};
  const cv::Mat both = See(water, {left, right}, Wall(2.F, 180));
  const cv::Mat sum = See(water, {left}, Wall(2.F, 180)) + See(water, {right}, Wall(2.F, 180));
  EXPECT_LT(cv::norm(both, sum, cv::NORM_INF), 1e-6);
  const cv::Mat grey = See(water, {left, right}, Wall(2.F, 180), ImageChannels::kMonochrome);
  for (const cv::Point at : {cv::Point(20, 30), cv::Point(100, 75), cv::Point(180, 140)}) {
    const cv::Vec3f& color = both.at<cv::Vec3f>(at);
    EXPECT_NEAR(grey.at<float>(at), 0.30 * color[0] + 0.45 * color[1] + 0.25 * color[2], 1e-6);
  }
}

TEST(LampLight, EndlessWaterIsFiniteLight) {
  const cv::Mat seen =
      See(DarkWater(6.0), {CentralLamp()}, Wall(std::numeric_limits<float>::infinity(), 0));
  EXPECT_TRUE(cv::checkRange(seen));
  EXPECT_GT(seen.at<cv::Vec3f>(75, 100)[1], 0.F);
  // What lies beside it is not touched.
  RawImage half = Wall(2.F, 255);
  half.depth.colRange(120, 201).setTo(std::numeric_limits<double>::infinity());
  EXPECT_TRUE(cv::checkRange(See(DarkWater(6.0), {CentralLamp()}, half)));
}

TEST(LampLight, DaylightAndLampsAdd) {
  WaterConfig day = DarkWater(6.0);
  day.daylight = 0.3;
  UnderwaterOptics by_day(day, kPinhole, nullptr);
  cv::Mat sun;
  by_day.Apply(Wall(2.F, 200), kT_IC, ImageChannels::kColor, sun);
  const cv::Mat lamp = See(DarkWater(6.0), {CentralLamp()}, Wall(2.F, 200));
  const cv::Mat both = See(day, {CentralLamp()}, Wall(2.F, 200));
  EXPECT_LT(cv::norm(both, sun + lamp, cv::NORM_INF), 1e-6);
}

TEST(LampLight, IlluminanceIsThatOfASurfaceThatFacesTheLamp) {
  const WaterConfig water = DarkWater(5.0);
  const LampLight light({CentralLamp()}, kT_IC, water, kPinhole, nullptr);
  const Eigen::Array3d at = light.IlluminanceAt({0, 0, 3});
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(at[i], 0.05 / 9.0 * std::exp(-3.0 * BeamAttenuation(water)[i]), 1e-9);
  EXPECT_EQ(light.IlluminanceAt({0, 0, -3}).maxCoeff(), 0.0);
}

TEST(LampConfig, IsReadStrictly) {
  const auto read = [](const std::string& text) {
    return ReadYaml(ParseYaml(text, "lamps.yaml"), [](YamlReader& yaml) { return ReadLamp(yaml); });
  };
  const LampConfig lamp =
      read("{position_m: [0.1, 0.2, 0.3], yaw_deg: 90, pitch_deg: 0, intensity_cd: 100}");
  EXPECT_TRUE(AxisOf(lamp).isApprox(Eigen::Vector3d::UnitY(), 1e-12));
  EXPECT_EQ(lamp.intensity_cd, 100.0);
  EXPECT_THROW(read("{yaw_deg: 90}"), InputError);
  EXPECT_THROW(read("{position_m: [0, 0, 0], beam_deg: 0}"), InputError);
  EXPECT_THROW(read("{position_m: [0, 0, 0], lumens: 5}"), InputError);
}

TEST(LampConfig, LightReachesLessFarInMurkierWater) {
  const std::vector<LampConfig> lamps = {LampConfig{}};
  EXPECT_EQ(FarthestLampLight(DarkWater(6.0), {}), 0.0);
  const double clear = FarthestLampLight(DarkWater(12.0), lamps);
  const double murky = FarthestLampLight(DarkWater(4.0), lamps);
  EXPECT_GT(clear, 5.0);
  EXPECT_LT(murky, 0.7 * clear);
}

}  // namespace
}  // namespace drydock::sim
