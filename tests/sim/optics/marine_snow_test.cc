#include "sim/optics/marine_snow.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "sensors_models/base/check.h"
#include "tests/sim/optics/even_light.h"

namespace drydock::sim {
namespace {

const Pinhole kPinhole{401, 301, 300.0, 200.0, 150.0};
constexpr float kNothing = std::numeric_limits<float>::infinity();

using testing::EvenLight;
using testing::WaterOf;

/// The camera looks along W's z axis from `p`.
Pose From(const Eigen::Vector3d& p) { return {Eigen::Quaterniond::Identity(), p}; }

cv::Mat Draw(const MarineSnow& snow, const Pose& T_WC, Time t = {}, float depth = kNothing,
             const LightAt& light = EvenLight(1.F), double background = 0.0) {
  const cv::Mat depths(kPinhole.height, kPinhole.width, CV_32FC1, cv::Scalar(depth));
  cv::Mat radiance(depths.size(), CV_32FC3, cv::Scalar::all(background));
  snow.AddTo(depths, T_WC, t, ImageChannels::kColor, light, radiance);
  return radiance;
}

bool SameBytes(const cv::Mat& a, const cv::Mat& b) {
  return std::memcmp(a.data, b.data, a.total() * a.elemSize()) == 0;
}

MarineSnowConfig Still(double density_m3) {
  MarineSnowConfig snow;
  snow.density_m3 = density_m3;
  snow.current_m_s.setZero();
  snow.wobble_m = 0.0;
  return snow;
}

/// A world with so little snow that one flake is alone in every view from near.
class LoneFlake : public ::testing::Test {
 protected:
  LoneFlake() {
    config_.range_m = 10.0;
    const SnowField field(config_, kSeed);
    for (double x = 0.0; x < 2000.0; x += 5.0) {
      const auto flakes = field.InView(kPinhole, From({x, 0, 0}), {});
      if (flakes.size() != 1) continue;
      flake_ = flakes.front();
      return;
    }
    ADD_FAILURE() << "no lone flake";
  }

  /// The view that has the flake on its axis at this range.
  Pose At(double range) const { return From(flake_.p_W - Eigen::Vector3d(0, 0, range)); }

  MarineSnow Snow(double visibility_m = 0.0) const {
    return {config_, WaterOf(visibility_m), kPinhole, kSeed};
  }

  static cv::Point2d Middle(const cv::Mat& radiance) {
    cv::Mat green;
    cv::extractChannel(radiance, green, 1);
    const cv::Moments moments = cv::moments(green);
    return {moments.m10 / moments.m00, moments.m01 / moments.m00};
  }

  static constexpr std::uint64_t kSeed = 5;
  MarineSnowConfig config_ = Still(2e-5);
  SnowFlake flake_;
};

TEST_F(LoneFlake, IsSeenUnderAnAngleThatFallsWithRange) {
  // The solid angle falls as 1 / range^2: in clear water the light does.
  const double near = cv::sum(Draw(Snow(), At(0.5)))[1];
  ASSERT_GT(near, 0.0);
  for (const double range : {1.0, 2.0, 4.0}) {
    const double far = cv::sum(Draw(Snow(), At(range)))[1];
    EXPECT_NEAR(far * range * range / (near * 0.25), 1.0, 0.01) << range;
  }
  const double largest =
      flake_.albedo * M_PI / 4.0 * std::pow(kPinhole.focal * flake_.size / 0.5, 2);
  EXPECT_LT(near, 1.001 * largest);
  EXPECT_GT(near, 0.4 / 2.5 * largest);
}

TEST_F(LoneFlake, FadesWithTheWaterBeforeIt) {
  const MarineSnow snow = Snow(6.0), clear = Snow();
  for (const double range : {0.5, 2.0, 5.0}) {
    // Aside of the axis, where the way is longer than the depth.
    const Pose T_WC = At(range) * From({0.5 * range, 0, 0});
    const cv::Scalar seen = cv::sum(Draw(snow, T_WC)), bare = cv::sum(Draw(clear, T_WC));
    ASSERT_GT(bare[1], 0.0);
    for (int i = 0; i < 3; ++i) {
      const double expected = std::exp(-BeamAttenuation(WaterOf(6.0))[i] * range * std::sqrt(1.25));
      EXPECT_NEAR(seen[i] / bare[i], expected, 1e-4 * expected) << range << " m, channel " << i;
    }
  }
}

TEST_F(LoneFlake, IsAsBrightAsItsLight) {
  const auto here = [&](const Eigen::Vector3d& p_W) {
    EXPECT_LT((p_W - flake_.p_W).norm(), 1e-9);
    return Eigen::Array3f(0.5F, 1.F, 2.F);
  };
  const cv::Scalar sum = cv::sum(Draw(Snow(), At(1.0), {}, kNothing, here));
  EXPECT_NEAR(sum[0] / sum[1], 0.5, 1e-5);
  EXPECT_NEAR(sum[2] / sum[1], 2.0, 1e-5);
}

TEST_F(LoneFlake, DoesNotShowAgainstItsOwnRadiance) {
  const auto own = static_cast<float>(flake_.albedo);
  cv::Mat radiance = Draw(Snow(6.0), At(1.0), {}, kNothing, EvenLight(1.F), own);
  double low = 0.0, high = 0.0;
  cv::minMaxLoc(radiance.reshape(1), &low, &high);
  EXPECT_NEAR(low, own, 1e-6);
  EXPECT_NEAR(high, own, 1e-6);
  // It is darker than a brighter background.
  radiance = Draw(Snow(6.0), At(0.5), {}, kNothing, EvenLight(1.F), 3.0);
  cv::minMaxLoc(radiance.reshape(1), &low, &high);
  EXPECT_LT(low, 2.9);
}

TEST_F(LoneFlake, IsHiddenByWhatIsNearer) {
  EXPECT_EQ(cv::sum(Draw(Snow(), At(2.0), {}, 1.99F))[1], 0.0);
  EXPECT_EQ(cv::sum(Draw(Snow(), At(2.0), {}, 2.01F))[1], cv::sum(Draw(Snow(), At(2.0)))[1]);
}

TEST_F(LoneFlake, HasTheDisparityOfItsDepth) {
  constexpr double kBaseline = 0.142;
  for (const double depth : {0.4, 0.77, 1.5, 3.0}) {
    const Pose left = At(depth), right = left * From({kBaseline, 0, 0});
    const cv::Point2d l = Middle(Draw(Snow(), left)), r = Middle(Draw(Snow(), right));
    EXPECT_NEAR(l.x, kPinhole.cx, 0.1);
    EXPECT_NEAR(l.x - r.x, kPinhole.focal * kBaseline / depth, 0.1) << depth;
    EXPECT_NEAR(l.y, r.y, 0.1);
  }
}

TEST_F(LoneFlake, MovesInTheImageWithTheCurrent) {
  config_.current_m_s = {0.1, -0.05, 0.0};
  const Time later = Time::FromSeconds(2.0);
  const cv::Point2d before = Middle(Draw(Snow(), At(1.0)));
  const cv::Point2d after = Middle(Draw(Snow(), At(1.0), later));
  EXPECT_NEAR(after.x - before.x, kPinhole.focal * 0.2, 0.1);
  EXPECT_NEAR(after.y - before.y, kPinhole.focal * -0.1, 0.1);
}

TEST_F(LoneFlake, SwaysAboutItsPlace) {
  config_.wobble_m = 0.02;
  double farthest = 0.0;
  for (double t = 0.0; t < 10.0; t += 0.1) {
    const cv::Point2d at = Middle(Draw(Snow(), At(1.0), Time::FromSeconds(t)));
    farthest = std::max(farthest, std::hypot(at.x - kPinhole.cx, at.y - kPinhole.cy));
  }
  EXPECT_GT(farthest, 0.9 * 0.02 * kPinhole.focal);
  EXPECT_LT(farthest, 1.45 * 0.02 * kPinhole.focal);
}

TEST_F(LoneFlake, IsBlurredOutOfFocus) {
  config_.focus_m = 2.0;
  const auto highest = [&](double aperture, double range) {
    config_.aperture_m = aperture;
    const cv::Mat seen = Draw(Snow(), At(range));
    double high = 0.0;
    cv::minMaxLoc(seen.reshape(1), nullptr, &high);
    return std::pair(high, cv::sum(seen)[1]);
  };
  const auto sharp = highest(0.0, 0.2), blurred = highest(0.02, 0.2);
  EXPECT_LT(blurred.first, 0.5 * sharp.first);
  EXPECT_NEAR(blurred.second / sharp.second, 1.0, 0.01);  // No light is lost.
  EXPECT_EQ(highest(0.02, 2.0), highest(0.0, 2.0));
}

TEST_F(LoneFlake, FadesAwayBeforeItsRangeEnds) {
  const double whole = cv::sum(Draw(Snow(), At(4.0)))[1] * 16.0;
  EXPECT_NEAR(cv::sum(Draw(Snow(), At(9.0)))[1] * 81.0 / whole, 0.5, 0.01);
  EXPECT_EQ(cv::sum(Draw(Snow(), At(10.001)))[1], 0.0);
}

TEST_F(LoneFlake, IsDimmedBySiltInFrontOfIt) {
  SiltCloud cloud;
  cloud.position_m = flake_.p_W - Eigen::Vector3d(0, 0, 1);
  cloud.radius_m = 0.3;
  cloud.attenuation_1_m = 2.0;
  cloud.rise_s = 0.0;
  const Silt silt({cloud}, WaterOf(0.0), kPinhole, 1);
  const cv::Mat depths(kPinhole.height, kPinhole.width, CV_32FC1, cv::Scalar(kNothing));
  cv::Mat radiance(depths.size(), CV_32FC3, cv::Scalar::all(0.0));
  Snow().AddTo(depths, At(2.0), {}, ImageChannels::kColor, EvenLight(1.F), radiance, &silt);
  const double tau = silt.DepthBetween(At(2.0).p(), flake_.p_W, {});
  ASSERT_GT(tau, 0.1);
  EXPECT_NEAR(cv::sum(radiance)[1] / cv::sum(Draw(Snow(), At(2.0)))[1], std::exp(-tau), 1e-5);
}

/// Views in all directions from places far apart.
std::vector<Pose> ManyViews(int count) {
  std::vector<Pose> views;
  views.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    views.emplace_back(FromYawPitchRoll(0.7 * i, 0.3 * i, 0.2 * i), Eigen::Vector3d(20 * i, -i, 3));
  return views;
}

TEST(SnowField, HasTheDensityAskedFor) {
  MarineSnowConfig config;
  config.density_m3 = 7.3;
  config.range_m = 4.0;
  const SnowField field(config, 1);
  constexpr double kFrom = 0.5, kTo = 3.0;  // Depths; the corners at 3 m are within 4 m.
  double count = 0.0;
  for (const Pose& T_WC : ManyViews(40)) {
    for (const SnowFlake& flake : field.InView(kPinhole, T_WC, Time::FromSeconds(17.0))) {
      const Eigen::Vector3d p_C = T_WC.Inverse() * flake.p_W;
      const double u = kPinhole.cx + kPinhole.focal * p_C.x() / p_C.z();
      const double v = kPinhole.cy + kPinhole.focal * p_C.y() / p_C.z();
      if (p_C.z() > kFrom && p_C.z() < kTo && u > -0.5 && u < kPinhole.width - 0.5 && v > -0.5 &&
          v < kPinhole.height - 0.5) {
        count += 1.0;
      }
    }
  }
  const double solid = kPinhole.width * kPinhole.height / std::pow(kPinhole.focal, 2);
  const double expected = 40 * 7.3 * solid * (std::pow(kTo, 3) - std::pow(kFrom, 3)) / 3.0;
  EXPECT_NEAR(count, expected, 4.0 * std::sqrt(expected));
}

TEST(SnowField, NumbersFallAsTheCubeOfTheSize) {
  MarineSnowConfig config;
  std::vector<double> sizes;
  for (const SnowFlake& flake :
       SnowField(config, 3).InView(kPinhole, From({0, 0, 0}), Time::FromSeconds(1.0)))
    sizes.push_back(flake.size);
  ASSERT_GT(sizes.size(), 500U);
  const auto inverse2 = [](double x) { return 1.0 / (x * x); };
  for (const double size : {0.0021, 0.0025, 0.003, 0.004, 0.006}) {
    const auto larger =
        std::count_if(sizes.begin(), sizes.end(), [&](double s) { return s > size; });
    const double share = (inverse2(size) - inverse2(0.007)) / (inverse2(0.002) - inverse2(0.007));
    const auto total = static_cast<double>(sizes.size());
    EXPECT_NEAR(static_cast<double>(larger) / total, share,
                4.0 * std::sqrt(share * (1.0 - share) / total));
  }
}

// Flakes are found again by their albedo.
std::vector<SnowFlake> SortedByAlbedo(std::vector<SnowFlake> flakes) {
  std::sort(flakes.begin(), flakes.end(),
            [](const SnowFlake& a, const SnowFlake& b) { return a.albedo < b.albedo; });
  return flakes;
}

TEST(SnowField, DriftsWithTheCurrent) {
  MarineSnowConfig config = Still(5.0);
  config.current_m_s = {0.2, -0.1, -0.01};
  const SnowField field(config, 1);
  const auto before = SortedByAlbedo(field.InView(kPinhole, From({0, 0, 0}), {}));
  // The camera drifts along: it keeps the same flakes, over many cells.
  const Eigen::Vector3d way = 100.0 * config.current_m_s;
  const auto after = SortedByAlbedo(field.InView(kPinhole, From(way), Time::FromSeconds(100.0)));
  ASSERT_GT(before.size(), 20U);
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_LT((after[i].p_W - before[i].p_W - way).norm(), 1e-9);
}

TEST(SnowField, IsTheSameFromEverywhere) {
  const SnowField field(MarineSnowConfig{}, 1);
  const Time t = Time::FromSeconds(3.3);
  const auto left = field.InView(kPinhole, From({0, 0, 0}), t);
  const auto right = field.InView(kPinhole, From({0.142, 0, 0}), t);
  std::size_t shared = 0;
  for (const SnowFlake& a : left) {
    shared +=
        static_cast<std::size_t>(std::any_of(right.begin(), right.end(), [&](const SnowFlake& b) {
          return a.p_W == b.p_W && a.size == b.size && a.axis_W == b.axis_W;
        }));
  }
  EXPECT_GT(shared, left.size() * 8 / 10);
  EXPECT_LT(shared, left.size());
}

TEST(MarineSnow, LightGrowsWithDensity) {
  // Small flakes, which do not hide each other.
  MarineSnowConfig config;
  config.size_min_m = config.size_max_m = 0.001;
  const auto added = [&](double density) {
    config.density_m3 = density;
    const MarineSnow snow(config, WaterOf(12.0), kPinhole, 1);
    double sum = 0.0;
    for (const Pose& T_WC : ManyViews(400)) {
      const cv::Mat depths(kPinhole.height, kPinhole.width, CV_32FC1, cv::Scalar(kNothing));
      cv::Mat radiance(depths.size(), CV_32FC1, cv::Scalar(0.0));
      snow.AddTo(depths, T_WC, {}, ImageChannels::kMonochrome, EvenLight(1.F), radiance);
      sum += cv::sum(radiance)[0];
    }
    return sum;
  };
  const double few = added(10.0);
  EXPECT_NEAR(added(40.0) / few, 4.0, 0.2);
}

TEST(MarineSnow, IsTheSameOnEveryRunAndHangsOnTheSeed) {
  const MarineSnowConfig config;
  const Time t = Time::FromSeconds(12.3);
  const MarineSnow snow(config, WaterOf(12.0), kPinhole, 1);
  const cv::Mat once = Draw(snow, From({1, 2, 3}), t);
  EXPECT_GT(cv::sum(once)[1], 0.0);
  EXPECT_TRUE(SameBytes(once, Draw(snow, From({1, 2, 3}), t)));
  const MarineSnow again(config, WaterOf(12.0), kPinhole, 1),
      other(config, WaterOf(12.0), kPinhole, 2);
  EXPECT_TRUE(SameBytes(once, Draw(again, From({1, 2, 3}), t)));
  EXPECT_FALSE(SameBytes(once, Draw(other, From({1, 2, 3}), t)));
}

// White ones near, black ones far: the far ones might as well not be there.
TEST(MarineSnow, NearFlakesCoverFarOnes) {
  MarineSnowConfig config = Still(2000.0);
  config.size_min_m = config.size_max_m;
  const MarineSnow snow(config, WaterOf(0.0), kPinhole, 1);
  const LightAt light = [](const Eigen::Vector3d& p_W) {
    return Eigen::Array3f::Constant(p_W.z() < 1.F ? 1.F : 0.F).eval();
  };
  const cv::Mat all = Draw(snow, From({0, 0, 0}), {}, kNothing, light);
  const cv::Mat near = Draw(snow, From({0, 0, 0}), {}, 1.F, light);
  EXPECT_GT(cv::mean(near)[1], 0.01);
  // Some ranges are longer than the depths of flakes that are deeper.
  EXPECT_LT(cv::norm(all, near, cv::NORM_L1) / cv::norm(near, cv::NORM_L1), 0.01);
}

TEST(MarineSnow, NoneLeavesTheImageAlone) {
  const MarineSnow snow(Still(0.0), WaterOf(12.0), kPinhole, 1);
  const cv::Mat image = Draw(snow, From({1, 2, 3}), {}, kNothing, EvenLight(1.F), 0.3);
  EXPECT_TRUE(SameBytes(image, cv::Mat(image.size(), CV_32FC3, cv::Scalar::all(0.3))));
}

TEST(MarineSnow, MonochromeIsAWeightedSum) {
  const MarineSnow snow(MarineSnowConfig{}, WaterOf(6.0), kPinhole, 1);
  const cv::Mat color = Draw(snow, From({1, 2, 3}));
  const cv::Mat depths(kPinhole.height, kPinhole.width, CV_32FC1, cv::Scalar(kNothing));
  cv::Mat grey(depths.size(), CV_32FC1, cv::Scalar(0.0));
  snow.AddTo(depths, From({1, 2, 3}), {}, ImageChannels::kMonochrome, EvenLight(1.F), grey);
  const cv::Scalar sum = cv::sum(color);
  const double expected = 0.30 * sum[0] + 0.45 * sum[1] + 0.25 * sum[2];
  EXPECT_NEAR(cv::sum(grey)[0] / expected, 1.0, 1e-3);
}

MarineSnowConfig Read(const std::string& text) {
  return ReadYaml(ParseYaml(text, "s.yaml"), [](YamlReader& yaml) { return ReadMarineSnow(yaml); });
}

TEST(MarineSnowConfig, IsReadStrictly) {
  EXPECT_EQ(Read("{}\n").density_m3, MarineSnowConfig{}.density_m3);
  const MarineSnowConfig snow = Read(
      "{density_m3: 9, size_min_m: 0.001, size_max_m: 0.002, range_m: 5, albedo: 0.3,"
      " current_m_s: [1, 2, 3], wobble_m: 0, aperture_m: 0.002, focus_m: 1}\n");
  EXPECT_EQ(snow.density_m3, 9.0);
  EXPECT_EQ(snow.current_m_s, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(snow.focus_m, 1.0);
  EXPECT_THROW(Read("{density_m3: -1}\n"), InputError);
  EXPECT_THROW(Read("{range_m: 100}\n"), InputError);
  EXPECT_THROW(Read("{size_min_m: 0.008}\n"), InputError);  // Larger than size_max_m.
  EXPECT_THROW(Read("{flakes: 3}\n"), InputError);
}

}  // namespace
}  // namespace drydock::sim
