#include "estimator/svin2/odometry/depth_link.h"

#include <limits>
#include <memory>

#include <gtest/gtest.h>

#include "tests/estimator/svin2/synthetic_motion.h"
#include "tests/estimator/svin2/synthetic_stereo.h"

namespace drydock::svin2 {
namespace {

constexpr double kSurface = 6.0;  // [m]

DepthSheet Sheet(double lag_s) {
  DepthSheet sheet;
  sheet.rate_hz = 1.0;
  sheet.noise_m = 0.002;
  sheet.lag_s = lag_s;
  return sheet;
}

/// A window of one frame at `t`, on the truth.
std::unique_ptr<SlidingWindow> WindowAt(Time t) {
  auto window =
      std::make_unique<SlidingWindow>(WindowConfig{}, StereoGeometry(testing::SyntheticStereo()));
  TrackedFrame seen;
  seen.t = t;
  window->Start(testing::MotionAt(t), {}, seen);
  return window;
}

double TrueDepth(Time t) { return kSurface - testing::MotionAt(t).T_WI.p().z(); }

class DepthLinkTest : public ::testing::Test {
 protected:
  static constexpr Time kNow{3'000'000'000};
  DepthLinkTest() : imu_(ImuNoiseModel{}), window_(WindowAt(kNow)) {}

  std::vector<EstimatorEvent> Feed(DepthLink& link) { return link.Feed(*window_, imu_); }

  ImuBuffer imu_;
  std::unique_ptr<SlidingWindow> window_;
};

TEST_F(DepthLinkTest, AReadingCountsForWhenItWasTrue) {
  DepthLink link(Sheet(0.03), {});
  ASSERT_TRUE(link.Add(kNow, {TrueDepth(kNow - Duration{30'000'000})}));
  EXPECT_TRUE(Feed(link).empty());
  // The body rises by 0.2 m/s: 6 mm in the lag, of which the uneven part is left.
  EXPECT_NEAR(window_->SurfaceHeight().value(), kSurface, 2e-4);
}

TEST_F(DepthLinkTest, WaitsUntilTheWindowHasComeUp) {
  DepthLink link(Sheet(0.0), {});
  ASSERT_TRUE(link.Add(kNow + Duration{1}, {5.0}));
  EXPECT_TRUE(Feed(link).empty());
  EXPECT_FALSE(window_->SurfaceHeight().has_value());
  window_ = WindowAt(kNow + Duration{1});
  EXPECT_TRUE(Feed(link).empty());
  EXPECT_TRUE(window_->SurfaceHeight().has_value());
}

TEST_F(DepthLinkTest, RefusesWhatIsNoNumberOrComesTwice) {
  DepthLink link(Sheet(0.0), {});
  EXPECT_FALSE(link.Add(kNow, {std::numeric_limits<double>::quiet_NaN()}));
  EXPECT_TRUE(link.Add(kNow, {5.0}));
  EXPECT_FALSE(link.Add(kNow, {5.0}));
  EXPECT_FALSE(link.Add(kNow - Duration{1}, {5.0}));
  EXPECT_EQ(link.SinceLastFrame().size(), 1U);
  link.NextFrame();
  EXPECT_TRUE(link.SinceLastFrame().empty());
}

TEST_F(DepthLinkTest, SaysWhichReadingItDoesNotBelieve) {
  DepthLink link(Sheet(0.0), {});
  const Time before = kNow - Duration{20'000'000};
  ASSERT_TRUE(link.Add(before, {TrueDepth(before)}));
  ASSERT_TRUE(link.Add(kNow, {TrueDepth(kNow) + 1.0}));
  const std::vector<EstimatorEvent> said = Feed(link);
  ASSERT_EQ(said.size(), 1U);
  EXPECT_EQ(said.front().t, kNow);
  EXPECT_NE(said.front().message.find("was not believed"), std::string::npos);
}

TEST(DepthSigma, IsThatOfOneReading) {
  DepthSheet sheet = Sheet(0.0);
  EXPECT_NEAR(DepthSigma(sheet), 0.002, 1e-4);
  sheet.resolution_m = 0.012;
  EXPECT_NEAR(DepthSigma(sheet), 0.004, 1e-4);
  // A sensor without noise still leaves an information that is finite.
  EXPECT_GT(DepthSigma({}), 0.0);
}

}  // namespace
}  // namespace drydock::svin2
