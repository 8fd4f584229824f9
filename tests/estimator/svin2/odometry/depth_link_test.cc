#include "estimator/svin2/odometry/depth_link.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

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

// As where the start had to wait for something to see.
TEST_F(DepthLinkTest, WhatWasReadLongBeforeTheStartSaysNothing) {
  DepthLink link(Sheet(0.0), {});
  ASSERT_TRUE(link.Add(kNow - Duration{1'500'000'000}, {1.0}));
  ASSERT_TRUE(link.Add(kNow, {TrueDepth(kNow)}));
  EXPECT_TRUE(Feed(link).empty());
  EXPECT_NEAR(window_->SurfaceHeight().value(), kSurface, 1e-3);
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

// A reading each 20 ms up to the frame at `now`, each with an error of its own.
class DepthSpikes : public DepthLinkTest {
 protected:
  void Read(const std::vector<double>& errors, Time now = kNow) {
    constexpr std::int64_t kPeriod = 20'000'000;
    Time t{now.ns - kPeriod * (static_cast<std::int64_t>(errors.size()) - 1)};
    for (const double error : errors) {
      ASSERT_TRUE(link_.Add(t, {TrueDepth(t) + error}));
      t = t + Duration{kPeriod};
    }
    said_ = Feed(link_);
  }
  double SurfaceError() const { return window_->SurfaceHeight().value() - kSurface; }

  DepthLink link_{Sheet(0.0), {}};
  std::vector<EstimatorEvent> said_;
};

TEST_F(DepthSpikes, TheFirstReadingIsOutvotedByTheNextTwo) {
  Read({5.0, 0.0, 0.0, 0.0});
  EXPECT_NEAR(SurfaceError(), 0.0, 0.01);
  ASSERT_EQ(said_.size(), 2U);
  EXPECT_NE(said_[0].message.find("was not believed"), std::string::npos) << said_[0].message;
  EXPECT_EQ(said_[1].t, kNow - Duration{20'000'000});
  EXPECT_NE(said_[1].message.find("2 depths in a row"), std::string::npos) << said_[1].message;
}

TEST_F(DepthSpikes, TwoAtTheStartAreOutvotedToo) {
  Read({5.0, 5.0, 0.0, 0.0, 0.0, 0.0});
  EXPECT_NEAR(SurfaceError(), 0.0, 0.01);
  EXPECT_EQ(said_.size(), 3U);
}

TEST_F(DepthSpikes, ThoseThatDoNotAgreeOutvoteNobody) {
  Read({0.0, 5.0, -3.0, 5.0, 0.0});
  EXPECT_NEAR(SurfaceError(), 0.0, 0.01);
  EXPECT_EQ(said_.size(), 3U);
}

TEST_F(DepthSpikes, FewDoNotOutvoteMany) {
  Read({0.0, 0.0, 0.0, 5.0, 5.0, 5.0, 0.0, 5.0, 5.0, 0.0});
  EXPECT_NEAR(SurfaceError(), 0.0, 0.01);
  EXPECT_EQ(said_.size(), 5U);
}

// Those who outvoted were right, and two of their kind are no majority against them.
TEST_F(DepthSpikes, AreRefusedAfterAVoteToo) {
  Read({5.0, 0.0, 0.0, 5.0, 5.0, 0.0});
  EXPECT_NEAR(SurfaceError(), 0.0, 0.01);
  EXPECT_EQ(said_.size(), 4U);
}

// Another map has another z: what was believed in the last one counts no more.
TEST_F(DepthSpikes, AreCountedAnewInAnotherWindow) {
  Read({0.0, 0.0, 0.0});
  const Time later = kNow + Duration{1'000'000'000};
  window_ = WindowAt(later);
  Read({5.0, 0.0, 0.0}, later);
  EXPECT_NEAR(SurfaceError(), 0.0, 0.01);
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
