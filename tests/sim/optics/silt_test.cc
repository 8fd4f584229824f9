#include "sim/optics/silt.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "sensors_models/base/check.h"
#include "tests/sim/optics/even_light.h"

namespace drydock::sim {
namespace {

const Pinhole kPinhole{203, 151, 150.0, 100.0, 75.0};
constexpr float kNothing = std::numeric_limits<float>::infinity();

using testing::EvenLight;
using testing::WaterOf;

/// One blob that is there at once and for ever.
SiltCloud Cloud(const Eigen::Vector3d& position, double radius, double attenuation) {
  SiltCloud cloud;
  cloud.position_m = position;
  cloud.radius_m = radius;
  cloud.attenuation_1_m = attenuation;
  cloud.rise_s = 0.0;
  cloud.puffs = 1;
  return cloud;
}

/// The camera looks along W's z axis from `p`.
Pose From(const Eigen::Vector3d& p) { return {Eigen::Quaterniond::Identity(), p}; }

cv::Mat Depths(float depth) {
  return {kPinhole.height, kPinhole.width, CV_32FC1, cv::Scalar(depth)};
}

/// What `silt` makes of an even image.
cv::Mat See(const Silt& silt, double background, float light, const cv::Mat& depths,
            const Pose& T_WC = From({0, 0, 0}), Time t = {}) {
  cv::Mat radiance(depths.size(), CV_32FC3, cv::Scalar::all(background));
  silt.AddTo(depths, T_WC, t, ImageChannels::kColor, EvenLight(light), radiance);
  return radiance;
}

bool Untouched(const cv::Mat& radiance, double background) {
  const cv::Mat before(radiance.size(), CV_32FC3, cv::Scalar::all(background));
  return std::memcmp(radiance.data, before.data, before.total() * before.elemSize()) == 0;
}

Eigen::Vector3d RayOf(int u, int v) {
  return {(u - kPinhole.cx) / kPinhole.focal, (v - kPinhole.cy) / kPinhole.focal, 1.0};
}

/// By Simpson's rule.
double Integrate(const SiltBlob& blob, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  constexpr int kSteps = 4000;
  const auto density = [&](int i) {
    const Eigen::Vector3d p = from + (to - from) * i / kSteps;
    const double x = (p - blob.centre_W).norm() / blob.sigma;
    return blob.attenuation * std::exp(-0.5 * x * x);
  };
  double sum = density(0) + density(kSteps);
  for (int i = 1; i < kSteps; ++i) sum += (i % 2 == 1 ? 4.0 : 2.0) * density(i);
  return sum * (to - from).norm() / (3.0 * kSteps);
}

TEST(SiltBlob, OpticalDepthIsTheIntegral) {
  const SiltBlob blob{{0.3, -0.2, 2.0}, 0.7, 5.0};
  const Eigen::Vector3d start(0.1, 0, 0.2);
  for (const Eigen::Vector3d& end :
       {Eigen::Vector3d(0.4, 0, 9), Eigen::Vector3d(1, -1, 2), Eigen::Vector3d(0.3, -0.2, 2.0),
        Eigen::Vector3d(0, 0, -4), Eigen::Vector3d(3, 3, 3)}) {
    EXPECT_NEAR(OpticalDepth(blob, start, end), Integrate(blob, start, end), 1e-9);
  }
  EXPECT_EQ(OpticalDepth(blob, start, start), 0.0);
}

// Nothing lights the cloud: what is behind it comes through by exp(-tau).
TEST(Silt, ExtinguishesByTheIntegralUpToEachPixel) {
  for (const Eigen::Vector3d& centre :
       {Eigen::Vector3d(0.2, 0.1, 2.0), Eigen::Vector3d(0, 0, 0.1), Eigen::Vector3d(-0.8, 0, -0.3),
        Eigen::Vector3d(1.5, 1, 1.5)}) {
    const Silt silt({Cloud(centre, 0.6, 3.0)}, WaterOf(0.0), kPinhole, 1);
    const SiltBlob blob{centre, 0.6, 3.0};
    cv::Mat depths = Depths(0.F);
    for (int v = 0; v < depths.rows; ++v) {
      for (int u = 0; u < depths.cols; ++u)
        depths.at<float>(v, u) = 0.1F + 0.03F * static_cast<float>((7 * u + 13 * v) % 150);
    }
    const cv::Mat seen = See(silt, 1.0, 0.F, depths);
    for (int v = 0; v < depths.rows; v += 15) {
      for (int u = 0; u < depths.cols; u += 11) {
        const Eigen::Vector3d end = static_cast<double>(depths.at<float>(v, u)) * RayOf(u, v);
        const double tau = Integrate(blob, {0, 0, 0}, end);
        EXPECT_NEAR(-std::log(seen.at<cv::Vec3f>(v, u)[1]), tau, 1e-4 + 1e-4 * tau)
            << u << ", " << v << " with the cloud at " << centre.transpose();
      }
    }
  }
}

TEST(Silt, BothEyesSeeThroughTheSameCloud) {
  SiltCloud cloud = Cloud({0.1, 0, 2}, 0.5, 2.0);
  cloud.puffs = 8;
  const Silt silt({cloud}, WaterOf(0.0), kPinhole, 1);
  const Eigen::Vector3d point(0.0, 0.0, 3.0);
  for (const double x : {0.0, 0.16}) {  // A whole number of pixels at this depth.
    const cv::Mat seen = See(silt, 1.0, 0.F, Depths(3.F), From({x, 0, 0}));
    const int u = static_cast<int>(std::lround(kPinhole.cx - kPinhole.focal * x / 3.0));
    const double tau = silt.DepthBetween({x, 0, 0}, point, {});
    ASSERT_GT(tau, 0.5);
    EXPECT_NEAR(-std::log(seen.at<cv::Vec3f>(75, u)[1]), tau, 1e-4);
  }
}

// A cloud before a field as bright as itself cannot be seen, through whatever water.
TEST(Silt, KeepsAFieldOfItsOwnRadiance) {
  SiltCloud cloud = Cloud({0.2, 0, 2}, 0.8, 4.0);
  cloud.albedo = {0.3, 0.3, 0.3};
  cloud.puffs = 10;
  for (const double visibility : {0.0, 4.0}) {
    const Silt silt({cloud}, WaterOf(visibility), kPinhole, 1);
    const cv::Mat seen = See(silt, 0.3 * 0.5, 0.5F, Depths(3.F));
    double low = 0.0, high = 0.0;
    cv::minMaxLoc(seen.reshape(1), &low, &high);
    EXPECT_NEAR(low, 0.15, 1e-6);
    EXPECT_NEAR(high, 0.15, 1e-6);
  }
}

TEST(Silt, DenseSiltShowsItsAlbedo) {
  SiltCloud cloud = Cloud({0, 0, 0}, 3.0, 30.0);
  const Silt silt({cloud}, WaterOf(0.0), kPinhole, 1);
  const cv::Vec3f seen = See(silt, 1.0, 0.5F, Depths(5.F)).at<cv::Vec3f>(75, 100);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(seen[i], 0.5 * cloud.albedo[i], 1e-5);
}

// A thin cloud before black: its light comes from its middle on average.
TEST(Silt, ShinesThroughTheWaterBeforeIt) {
  const SiltCloud cloud = Cloud({0, 0, 3}, 0.2, 0.5);
  const WaterConfig water = WaterOf(6.0);
  const Silt silt({cloud}, water, kPinhole, 1);
  const cv::Vec3f seen = See(silt, 0.0, 1.F, Depths(kNothing)).at<cv::Vec3f>(75, 100);
  const double opacity = 1.0 - std::exp(-0.5 * 0.2 * std::sqrt(2.0 * std::numbers::pi));
  for (int i = 0; i < 3; ++i) {
    const double expected = opacity * cloud.albedo[i] * std::exp(-3.0 * BeamAttenuation(water)[i]);
    EXPECT_NEAR(seen[i] / expected, 1.0, 0.03);
  }
}

TEST(Silt, IsLitAtItsNearSide) {
  const Silt silt({Cloud({0, 0, 4}, 1.0, 20.0)}, WaterOf(0.0), kPinhole, 1);
  double nearest = 1e9, farthest = 0.0;
  const LightAt light = [&](const Eigen::Vector3d& p_W) {
    if (p_W.head<2>().norm() < 0.3) {
      nearest = std::min(nearest, p_W.z());
      farthest = std::max(farthest, p_W.z());
    }
    return Eigen::Array3f::Ones().eval();
  };
  cv::Mat radiance(kPinhole.height, kPinhole.width, CV_32FC3, cv::Scalar::all(0.0));
  silt.AddTo(Depths(kNothing), From({0, 0, 0}), {}, ImageChannels::kColor, light, radiance);
  // tau reaches ln 2 there.
  EXPECT_NEAR(OpticalDepth({{0, 0, 4}, 1.0, 20.0}, {0, 0, 0}, {0, 0, nearest}), std::log(2.0),
              0.05);
  EXPECT_LT(farthest, 3.0);
}

TEST(Silt, WhereThereIsNoneNothingChanges) {
  EXPECT_TRUE(Untouched(See(Silt({}, WaterOf(6.0), kPinhole, 1), 0.7, 1.F, Depths(3.F)), 0.7));
  // Behind the camera, beside the view, without density.
  for (const SiltCloud& cloud : {Cloud({0, 0, -4}, 0.5, 5.0), Cloud({9, 0, 2}, 0.5, 5.0),
                                 Cloud({0, 9, 2}, 0.5, 5.0), Cloud({0, 0, 2}, 0.5, 0.0)}) {
    EXPECT_TRUE(
        Untouched(See(Silt({cloud}, WaterOf(6.0), kPinhole, 1), 0.7, 1.F, Depths(3.F)), 0.7));
  }
  // A corner of the image stays as it was.
  const cv::Mat seen = See(Silt({Cloud({0.9, 0.7, 2}, 0.05, 5.0)}, WaterOf(6.0), kPinhole, 1), 0.7,
                           1.F, Depths(3.F));
  EXPECT_TRUE(Untouched(seen(cv::Rect(0, 0, 60, 60)).clone(), 0.7));
  EXPECT_FALSE(Untouched(seen, 0.7));
}

TEST(Silt, ComesUpAndSettles) {
  SiltCloud cloud = Cloud({0, 0, 2}, 0.5, 2.0);
  cloud.from_s = 10.0;
  cloud.rise_s = 4.0;
  cloud.to_s = 20.0;
  cloud.settle_s = 10.0;
  const Silt silt({cloud}, WaterOf(0.0), kPinhole, 1);
  const auto tau = [&](double t) {
    return silt.DepthBetween({0, 0, 0}, {0, 0, 9}, Time::FromSeconds(t));
  };
  const double full = 2.0 * 0.5 * std::sqrt(2.0 * std::numbers::pi);
  EXPECT_EQ(tau(9.9), 0.0);
  EXPECT_NEAR(tau(12.0), 0.5 * full, 1e-3);
  EXPECT_NEAR(tau(14.0), full, 1e-3);
  EXPECT_NEAR(tau(20.0), full, 1e-3);
  EXPECT_NEAR(tau(25.0), 0.5 * full, 1e-3);
  EXPECT_EQ(tau(30.0), 0.0);
  for (const double t : {10.01, 13.99, 20.01, 29.99})  // Without kinks.
    EXPECT_NEAR(tau(t), std::abs(t - 20.0) < 9.0 ? full : 0.0, 1e-3) << t;
  for (const double t : {9.9, 30.1}) {
    const cv::Mat seen = See(silt, 0.7, 1.F, Depths(3.F), From({0, 0, 0}), Time::FromSeconds(t));
    EXPECT_TRUE(Untouched(seen, 0.7)) << t;
  }
}

TEST(Silt, DriftsAndThinsOutAsItGrows) {
  SiltCloud cloud = Cloud({0, 0, 2}, 0.5, 2.0);
  cloud.from_s = 5.0;
  cloud.current_m_s = {0.1, 0, 0.02};
  cloud.growth_m_s = 0.05;
  const SiltBlob young = *BlobAt(cloud, 5.0), old = *BlobAt(cloud, 15.0);
  EXPECT_LT((old.centre_W - young.centre_W - Eigen::Vector3d(1, 0, 0.2)).norm(), 1e-12);
  EXPECT_NEAR(old.sigma, 1.0, 1e-12);
  // The silt in it stays.
  EXPECT_NEAR(old.attenuation * std::pow(old.sigma, 3), young.attenuation * std::pow(0.5, 3),
              1e-12);
}

// Looked at along each axis, over a plane of parallel rays: as much silt, about the same middle, as
// wide as one blob would be.
TEST(Silt, PuffsMakeUpTheCloud) {
  const Eigen::Vector3d centre(0.3, -0.2, 0.1);
  SiltCloud cloud = Cloud(centre, 0.5, 2.0);
  const Silt one({cloud}, WaterOf(0.0), kPinhole, 7);
  cloud.puffs = 12;
  const Silt silt({cloud}, WaterOf(0.0), kPinhole, 7);
  constexpr double kStep = 0.05;
  double squares = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    double sum = 0.0, difference = 0.0, square = 0.0;
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (double a = -3.0; a <= 3.0; a += kStep) {
      for (double b = -3.0; b <= 3.0; b += kStep) {
        Eigen::Vector3d from, to, off;
        off[axis] = 0.0;
        off[(axis + 1) % 3] = a;
        off[(axis + 2) % 3] = b;
        from = to = centre + off;
        from[axis] -= 20.0;
        to[axis] += 20.0;
        const double tau = silt.DepthBetween(from, to, {});
        sum += tau;
        middle += tau * off;
        square += tau * off.squaredNorm();
        difference += std::abs(tau - one.DepthBetween(from, to, {}));
      }
    }
    const double silt_in_all = 2.0 * std::pow(0.5 * std::sqrt(2.0 * std::numbers::pi), 3);
    EXPECT_NEAR(sum * kStep * kStep, silt_in_all, 1e-3 * silt_in_all);
    EXPECT_LT(middle.norm() / sum, 1e-3);
    EXPECT_GT(difference / sum, 0.1);  // It has a shape.
    squares += square / sum;
  }
  // Each coordinate, of variance sigma^2, is seen twice.
  EXPECT_NEAR(squares, 6.0 * 0.5 * 0.5, 2e-3);
}

TEST(Silt, NearerCloudsCoverFartherOnes) {
  SiltCloud near = Cloud({0, 0, 2}, 0.3, 30.0), far = Cloud({0, 0, 6}, 0.3, 30.0);
  near.albedo.setConstant(0.1);
  far.albedo.setConstant(0.9);
  for (const auto& clouds : {std::vector{near, far}, std::vector{far, near}}) {
    const Silt silt(clouds, WaterOf(0.0), kPinhole, 1);
    EXPECT_NEAR(See(silt, 0.0, 1.F, Depths(9.F)).at<cv::Vec3f>(75, 100)[1], 0.1, 1e-3);
  }
}

TEST(Silt, MonochromeIsAWeightedSum) {
  const Silt silt({Cloud({0, 0, 2}, 0.5, 2.0)}, WaterOf(8.0), kPinhole, 1);
  const cv::Vec3f color = See(silt, 0.0, 1.F, Depths(3.F)).at<cv::Vec3f>(60, 90);
  cv::Mat grey(kPinhole.height, kPinhole.width, CV_32FC1, cv::Scalar(0.0));
  silt.AddTo(Depths(3.F), From({0, 0, 0}), {}, ImageChannels::kMonochrome, EvenLight(1.F), grey);
  EXPECT_NEAR(grey.at<float>(60, 90), 0.30F * color[0] + 0.45F * color[1] + 0.25F * color[2], 1e-6);
}

TEST(Silt, TakesDaylightFromWhatIsBelow) {
  const Silt silt({Cloud({0, 0, 0}, 0.5, 4.0)}, WaterOf(8.0), kPinhole, 1);
  EXPECT_NEAR(silt.DaylightLeft({0, 0, 4}, {}), 1.0, 1e-6);
  const double through = 4.0 * 0.5 * std::sqrt(2.0 * std::numbers::pi);
  EXPECT_NEAR(silt.DaylightLeft({0, 0, -4}, {}), std::exp(-0.15 * through), 1e-6);
  EXPECT_NEAR(silt.DaylightLeft({4, 0, -4}, {}), 1.0, 1e-6);
}

std::vector<SiltCloud> Read(const std::string& text) {
  return ReadYaml(ParseYaml(text, "s.yaml"), [](YamlReader& yaml) {
    std::vector<SiltCloud> clouds;
    yaml.List("silt", [&](YamlReader& cloud) { clouds.push_back(ReadSiltCloud(cloud)); });
    return clouds;
  });
}

TEST(SiltConfig, IsReadStrictly) {
  const auto clouds = Read(
      "silt:\n"
      "  - {position_m: [1, 2, 3]}\n"
      "  - {position_m: [0, 0, 0], radius_m: 2, attenuation_1_m: 9, from_s: 3, to_s: 8, rise_s: 1,"
      " settle_s: 2, current_m_s: [1, 0, 0], growth_m_s: 0.1, albedo: [0.1, 0.2, 0.3], puffs: "
      "4}\n");
  ASSERT_EQ(clouds.size(), 2U);
  EXPECT_EQ(clouds[0].position_m, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(clouds[0].radius_m, SiltCloud{}.radius_m);
  EXPECT_EQ(clouds[1].puffs, 4);
  EXPECT_EQ(clouds[1].albedo, Eigen::Vector3d(0.1, 0.2, 0.3));
  EXPECT_THROW(Read("silt: [{radius_m: 2}]\n"), InputError);  // Where?
  EXPECT_THROW(Read("silt: [{position_m: [0, 0, 0], radius_m: 0}]\n"), InputError);
  EXPECT_THROW(Read("silt: [{position_m: [0, 0, 0], from_s: 4, to_s: 4}]\n"), InputError);
  EXPECT_THROW(Read("silt: [{position_m: [0, 0, 0], mud: 1}]\n"), InputError);
}

}  // namespace
}  // namespace drydock::sim
