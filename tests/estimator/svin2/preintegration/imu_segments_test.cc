#include "estimator/svin2/preintegration/imu_segments.h"

#include <limits>

#include <gtest/gtest.h>

namespace drydock::svin2 {
namespace {

constexpr std::int64_t kMs = 1'000'000;

/// Rate about x and force along z are what is said; the rest is 0.
TimedImuSample Sample(std::int64_t ms, double rate, double force) {
  return {{ms * kMs}, {{rate, 0, 0}, {0, 0, force}}};
}

TEST(ImuSegments, InterpolateAtBothEnds) {
  const std::vector<TimedImuSample> samples = {Sample(0, 0, 0), Sample(10, 1, 10),
                                               Sample(20, 3, 30)};
  const auto segments = CutImuSegments(samples, {4 * kMs}, {15 * kMs}, {});
  ASSERT_EQ(segments.size(), 2u);
  EXPECT_EQ(segments[0].length.ns, 6 * kMs);
  EXPECT_NEAR(segments[0].from.angular_rate.x(), 0.4, 1e-15);
  EXPECT_NEAR(segments[0].to.specific_force.z(), 10.0, 1e-14);
  EXPECT_EQ(segments[1].length.ns, 5 * kMs);
  EXPECT_NEAR(segments[1].to.angular_rate.x(), 2.0, 1e-15);
  EXPECT_NEAR(segments[1].to.specific_force.z(), 20.0, 1e-14);
}

TEST(ImuSegments, BetweenTwoSamplesThereIsOneSegment) {
  const std::vector<TimedImuSample> samples = {Sample(0, 0, 0), Sample(10, 1, 10)};
  const auto segments = CutImuSegments(samples, {2 * kMs}, {3 * kMs}, {});
  ASSERT_EQ(segments.size(), 1u);
  EXPECT_NEAR(segments[0].from.angular_rate.x(), 0.2, 1e-15);
  EXPECT_NEAR(segments[0].to.angular_rate.x(), 0.3, 1e-15);
}

TEST(ImuSegments, HoldTheNearestSampleBeyondTheEnds) {
  const std::vector<TimedImuSample> samples = {Sample(10, 1, 10), Sample(20, 3, 30)};
  const auto segments = CutImuSegments(samples, {0}, {30 * kMs}, {});
  ASSERT_EQ(segments.size(), 3u);
  EXPECT_EQ(segments[0].from.angular_rate.x(), 1.0);
  EXPECT_EQ(segments[0].length.ns, 10 * kMs);
  EXPECT_EQ(segments[2].to.specific_force.z(), 30.0);
  EXPECT_EQ(segments[2].length.ns, 10 * kMs);
}

TEST(ImuSegments, ASingleSampleFillsTheInterval) {
  const std::vector<TimedImuSample> samples = {Sample(10, 1, 10)};
  const auto segments = CutImuSegments(samples, {0}, {30 * kMs}, {});
  ASSERT_EQ(segments.size(), 2u);
  EXPECT_EQ(segments[0].length.ns + segments[1].length.ns, 30 * kMs);
}

TEST(ImuSegments, LeaveOutWhatIsNotFiniteOrRunsBackwards) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<TimedImuSample> samples = {Sample(0, 0, 0),   Sample(5, nan, 0),
                                               Sample(10, 1, 10), Sample(10, 9, 9),
                                               Sample(7, 9, 9),   Sample(20, 3, 30)};
  const auto segments = CutImuSegments(samples, {0}, {20 * kMs}, {});
  ASSERT_EQ(segments.size(), 2u);
  EXPECT_EQ(segments[0].to.angular_rate.x(), 1.0);
  EXPECT_EQ(segments[1].to.angular_rate.x(), 3.0);
}

TEST(ImuSegments, NothingWithoutSamplesOrTime) {
  const std::vector<TimedImuSample> samples = {Sample(0, 0, 0), Sample(10, 1, 10)};
  EXPECT_TRUE(CutImuSegments({}, {0}, {kMs}, {}).empty());
  EXPECT_TRUE(CutImuSegments(samples, {kMs}, {kMs}, {}).empty());
  EXPECT_TRUE(CutImuSegments(samples, {2 * kMs}, {kMs}, {}).empty());
}

TEST(ImuSegments, SaturationCastsDoubtOnItsSensorAndItsNeighbourhood) {
  ImuNoiseModel noise;
  noise.gyro_range = 2.0;
  noise.accel_range = 20.0;
  const std::vector<TimedImuSample> samples = {Sample(0, 0, 0), Sample(10, -2.0, 19.9),
                                               Sample(20, 0, 0), Sample(30, 0, 0)};
  const auto segments = CutImuSegments(samples, {0}, {30 * kMs}, noise);
  ASSERT_EQ(segments.size(), 3u);
  EXPECT_EQ(segments[0].gyro_noise_density, 100.0 * noise.gyro_noise_density);
  EXPECT_EQ(segments[1].gyro_noise_density, 100.0 * noise.gyro_noise_density);
  EXPECT_EQ(segments[2].gyro_noise_density, noise.gyro_noise_density);
  EXPECT_EQ(segments[0].accel_noise_density, noise.accel_noise_density);
}

TEST(ImuSegments, AGapCastsDoubtOnBothSensorsHoweverLittleOfItIsUsed) {
  const ImuNoiseModel noise;
  const std::vector<TimedImuSample> samples = {Sample(0, 0, 0), Sample(60, 0, 0),
                                               Sample(110, 0, 0)};
  const auto segments = CutImuSegments(samples, {58 * kMs}, {100 * kMs}, noise);
  ASSERT_EQ(segments.size(), 2u);
  EXPECT_EQ(segments[0].gyro_noise_density, 100.0 * noise.gyro_noise_density);
  EXPECT_EQ(segments[0].accel_noise_density, 100.0 * noise.accel_noise_density);
  EXPECT_EQ(segments[1].gyro_noise_density, noise.gyro_noise_density);
}

}  // namespace
}  // namespace drydock::svin2
