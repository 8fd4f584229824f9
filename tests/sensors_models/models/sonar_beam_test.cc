#include "sensors_models/models/sonar_beam.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace drydock {
namespace {

constexpr double kWidth = 1.4 * std::numbers::pi / 180.0;
constexpr std::size_t kRays = 192;
/// The two-way pattern, 2^(-8 (angle / width)^2), is a Gaussian exp(-angle^2 / (2 s^2)) of this s.
const double kSigma = kWidth / (4.0 * std::sqrt(std::numbers::ln2));

TEST(SonarBeam, IsThreeDecibelsDownAtHalfTheWidth) {
  EXPECT_DOUBLE_EQ(OneWayBeamPattern(0.0, kWidth), 1.0);
  EXPECT_DOUBLE_EQ(OneWayBeamPattern(0.5 * kWidth, kWidth), 0.5);
  EXPECT_DOUBLE_EQ(OneWayBeamPattern(kWidth, kWidth), 1.0 / 16.0);
}

TEST(SonarBeam, WithoutWidthItIsTheAxis) {
  const SonarBeamRays rays = MakeSonarBeamRays(0.0, kRays);
  ASSERT_EQ(rays.directions.cols(), 1);
  EXPECT_EQ(rays.directions.col(0), Eigen::Vector3d::UnitX());
  EXPECT_EQ(rays.weights(0), 1.0);
}

TEST(SonarBeam, RaysFillTheCone) {
  const SonarBeamRays rays = MakeSonarBeamRays(kWidth, kRays);
  ASSERT_EQ(rays.directions.cols(), 192);
  EXPECT_NEAR(rays.weights.sum(), 1.0, 1e-12);
  int inner = 0;
  for (Eigen::Index i = 0; i < rays.directions.cols(); ++i) {
    EXPECT_NEAR(rays.directions.col(i).norm(), 1.0, 1e-12);
    const double angle = std::acos(rays.directions(0, i));
    EXPECT_LE(angle, kWidth);
    EXPECT_NEAR(rays.weights(i) / rays.weights(0),
                OneWayBeamPattern(angle, kWidth) / OneWayBeamPattern(0.0, kWidth), 0.003);
    inner += angle < 0.5 * kWidth ? 1 : 0;
  }
  // Half of what is sent lies within half a width, of all but a sixteenth that is cast: 8/15.
  EXPECT_NEAR(inner, 192.0 * 8.0 / 15.0, 1.0);
}

// In each direction across the axis the weights have the moments of the pattern: mean 0, variance
// s^2 (2 % less, for the Gaussian is cut off at 3.3 s).
TEST(SonarBeam, WeightsHaveThePatternsMoments) {
  const SonarBeamRays rays = MakeSonarBeamRays(kWidth, kRays);
  for (const Eigen::Index axis : {1, 2}) {
    const Eigen::VectorXd across = rays.directions.row(axis);
    EXPECT_NEAR(rays.weights.dot(across) / kSigma, 0.0, 0.01);
    const double variance = rays.weights.dot(across.cwiseAbs2());
    EXPECT_NEAR(variance / (kSigma * kSigma), 0.978, 0.01);
  }
}

// What lies beyond an edge at x across the axis is the tail of a Gaussian.
TEST(SonarBeam, AnEdgeSplitsTheEnergyAsAGaussian) {
  const SonarBeamRays rays = MakeSonarBeamRays(kWidth, kRays);
  for (const double edge : {-1.5, -0.5, 0.0, 0.3, 1.0, 2.0}) {
    double beyond = 0.0;
    for (Eigen::Index i = 0; i < rays.directions.cols(); ++i) {
      if (rays.directions(1, i) > edge * kSigma) beyond += rays.weights(i);
    }
    EXPECT_NEAR(beyond, 0.5 * std::erfc(edge / std::numbers::sqrt2), 0.012) << edge;
  }
}

}  // namespace
}  // namespace drydock
