#include "estimator/svin2/frontend/descriptor_extractor.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sensors_models/base/check.h"
#include "tests/estimator/svin2/frontend/synthetic_images.h"

namespace drydock::svin2 {
namespace {

using testing::Draw;
using testing::Texture;

constexpr double kFocal = 400.0;
const Eigen::Vector2d kCentre(160.0, 120.0);
const Eigen::Vector3d kDown(0.0, 1.0, 0.0);  // Of a camera that is held level, in C.

CameraModel Camera() {
  return CameraModel({.width = 320,
                      .height = 240,
                      .fx = kFocal,
                      .fy = kFocal,
                      .cx = kCentre.x(),
                      .cy = kCentre.y()});
}

// A wall across the view of a camera that was turned by `roll` about its axis, so that the image
// turns the other way about its centre.
cv::Mat Wall(double roll, double noise, std::uint64_t seed) {
  const Texture texture(11);
  const Eigen::Matrix2d R = Eigen::Rotation2Dd(roll).toRotationMatrix();
  return Draw(
      320, 240, [&](const Eigen::Vector2d& p) { return 128.0 + 35.0 * texture(R * (p - kCentre)); },
      noise, seed);
}

// Points on the wall near its middle, and where the turned camera sees them.
std::vector<Eigen::Vector2d> Points(double roll) {
  const Eigen::Matrix2d R = Eigen::Rotation2Dd(-roll).toRotationMatrix();
  std::vector<Eigen::Vector2d> points;
  for (int i = -2; i <= 2; ++i) {
    for (int j = -2; j <= 2; ++j) points.push_back(kCentre + R * Eigen::Vector2d(25 * i, 22 * j));
  }
  return points;
}

double MeanDistance(const std::vector<std::optional<Descriptor>>& a,
                    const std::vector<std::optional<Descriptor>>& b, std::size_t shift) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += HammingDistance(a[i].value(), b[(i + shift) % b.size()].value());
  }
  return sum / static_cast<double>(a.size());
}

TEST(Descriptors, HammingDistanceCountsBits) {
  const Descriptor zero{};
  Descriptor other{};
  other[0] = 0b1011;
  other[7] = 1ULL << 63;
  EXPECT_EQ(HammingDistance(zero, zero), 0);
  EXPECT_EQ(HammingDistance(zero, other), 4);
}

// Held level, down is +y of the image: 90 degrees. A camera that is rolled clockwise (about its z)
// by 30 degrees sees gravity turned by -30.
TEST(Descriptors, GravityAngleFollowsTheRoll) {
  const CameraModel camera = Camera();
  EXPECT_NEAR(GravityAngle(camera, kCentre, kDown).value(), std::numbers::pi / 2.0, 1e-6);
  const double roll = std::numbers::pi / 6.0;
  const Eigen::Vector3d gravity_C(std::sin(roll), std::cos(roll), 0.0);
  EXPECT_NEAR(GravityAngle(camera, kCentre, gravity_C).value(), std::numbers::pi / 3.0, 1e-6);
  // Looking straight down, points fall towards the middle (the vanishing point): from (x, 0),
  // x > 0, towards -x. In the middle itself there is no direction.
  const Eigen::Vector3d ahead(0.0, 0.0, 9.81);
  EXPECT_NEAR(std::abs(GravityAngle(camera, {300.0, 120.0}, ahead).value()), std::numbers::pi,
              1e-6);
  EXPECT_FALSE(GravityAngle(camera, kCentre, ahead).has_value());
  EXPECT_FALSE(GravityAngle(camera, kCentre, Eigen::Vector3d::Zero()).has_value());
}

TEST(Descriptors, StayTheSameAsTheCameraRolls) {
  DescriptorExtractor extractor({});
  const CameraModel camera = Camera();
  const auto level = extractor.Describe(Wall(0.0, 1.0, 1), Points(0.0), camera, kDown);
  for (const double degrees : {0.0, 10.0, 45.0, 90.0, -135.0, 180.0}) {
    const double roll = degrees * std::numbers::pi / 180.0;
    const Eigen::Vector3d gravity_C(std::sin(roll), std::cos(roll), 0.0);
    const cv::Mat image = Wall(roll, 1.0, 2);
    const auto turned = extractor.Describe(image, Points(roll), camera, gravity_C);
    EXPECT_LT(MeanDistance(level, turned, 0), 40.0) << degrees;
    // Other places look unlike: for unrelated descriptors half of the 512 bits differ.
    EXPECT_GT(MeanDistance(level, turned, 7), 150.0) << degrees;
    // Without knowing how gravity turned they are not the same.
    if (std::abs(degrees) > 40.0) {
      const auto not_told = extractor.Describe(image, Points(roll), camera, kDown);
      EXPECT_GT(MeanDistance(level, not_told, 0), 100.0) << degrees;
    }
  }
}

// The same wall at half the size, described at half the scale, is the same wall.
TEST(Descriptors, OfALevelAreThoseOfTheHalvedImage) {
  DescriptorExtractor extractor({});
  const cv::Mat image = Wall(0.0, 1.0, 1);
  const auto as_image = extractor.Describe(image, Points(0.0), Camera(), kDown);
  std::vector<Eigen::Vector2d> twice;
  for (const Eigen::Vector2d& pixel : Points(0.0)) twice.emplace_back(2.0 * pixel);
  CameraIntrinsics large = Camera().intrinsics();
  large.width *= 2;
  large.height *= 2;
  for (double* length : {&large.fx, &large.fy, &large.cx, &large.cy}) *length *= 2.0;
  const auto as_level = extractor.Describe(image, twice, CameraModel(large), kDown, 2.0);
  ASSERT_EQ(as_level.size(), as_image.size());
  EXPECT_LT(MeanDistance(as_image, as_level, 0), 5.0);
}

TEST(Descriptors, LeavesOutWhatIsTooNearTheEdge) {
  DescriptorExtractor extractor({});
  const auto descriptors = extractor.Describe(
      Wall(0.0, 0.0, 1), {{3.0, 3.0}, {160.0, 120.0}, {318.0, 120.0}}, Camera(), kDown);
  ASSERT_EQ(descriptors.size(), 3U);
  EXPECT_FALSE(descriptors[0].has_value());
  EXPECT_TRUE(descriptors[1].has_value());
  EXPECT_FALSE(descriptors[2].has_value());
  EXPECT_TRUE(extractor.Describe(Wall(0.0, 0.0, 1), {}, Camera(), kDown).empty());
}

TEST(Descriptors, RefusesBadConfigurations) {
  EXPECT_THROW(DescriptorExtractor({.pattern_radius_px = 0.0}), InputError);
}

}  // namespace
}  // namespace drydock::svin2
