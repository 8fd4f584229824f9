#include "estimator/svin2/odometry/imu_buffer.h"

#include <limits>

#include <gtest/gtest.h>

#include "sensors_models/base/pose.h"

namespace drydock::svin2 {
namespace {

Time At(double ms) { return Time::FromSeconds(1e-3 * ms); }

ImuSample Turning(double rate) { return {{0, 0, rate}, {0, 0, 9.81}}; }

class ImuBufferTest : public ::testing::Test {
 protected:
  ImuBufferTest() : buffer_(ImuNoiseModel{}) {
    for (int k = 0; k <= 10; ++k) EXPECT_TRUE(buffer_.Add(At(10 * k), Turning(0.5)));
  }

  ImuBuffer buffer_;
};

TEST_F(ImuBufferTest, RefusesStampsThatDoNotRiseAndWhatIsNoNumber) {
  EXPECT_FALSE(buffer_.Add(At(100), Turning(0)));
  EXPECT_FALSE(buffer_.Add(At(55), Turning(0)));
  EXPECT_FALSE(buffer_.Add(At(110), Turning(std::numeric_limits<double>::quiet_NaN())));
  EXPECT_TRUE(buffer_.Add(At(110), Turning(0)));
}

TEST_F(ImuBufferTest, HandsOutWhatCoversASpan) {
  const auto samples = buffer_.Between(At(25), At(45));
  ASSERT_EQ(samples.size(), 4U);
  EXPECT_EQ(samples.front().t, At(20));
  EXPECT_EQ(samples.back().t, At(50));
  EXPECT_TRUE(buffer_.Covers(At(100)));
  EXPECT_FALSE(buffer_.Covers(At(101)));
}

TEST_F(ImuBufferTest, IntegratesBetweenSamples) {
  const auto delta = buffer_.Integrate(At(25), At(75), {});
  ASSERT_TRUE(delta.has_value());
  // 50 ms at 0.5 rad/s.
  EXPECT_NEAR(YawOf(delta->delta().q), 0.025, 1e-12);
  EXPECT_FALSE(buffer_.Integrate(At(75), At(75), {}).has_value());
  EXPECT_FALSE(ImuBuffer(ImuNoiseModel{}).Integrate(At(0), At(10), {}).has_value());
}

TEST_F(ImuBufferTest, KeepsTheSampleBeforeWhatItForgets) {
  buffer_.ForgetBefore(At(45));
  const auto samples = buffer_.Between(At(0), At(50));
  ASSERT_FALSE(samples.empty());
  EXPECT_EQ(samples.front().t, At(40));
  EXPECT_NEAR(YawOf(buffer_.Integrate(At(45), At(65), {})->delta().q), 0.01, 1e-12);
}

}  // namespace
}  // namespace drydock::svin2
