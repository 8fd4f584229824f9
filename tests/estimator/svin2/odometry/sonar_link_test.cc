#include "estimator/svin2/odometry/sonar_link.h"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sensors_models/models/sonar_model.h"
#include "tests/estimator/svin2/synthetic_motion.h"
#include "tests/estimator/svin2/synthetic_stereo.h"

namespace drydock::svin2 {
namespace {

SonarSheet Sheet() {
  SonarSheet sheet;
  sheet.rate_hz = 10.0;
  sheet.T_IS = Pose(ExpSO3({0.1, 0.2, 0.3}), {0.2, 0.0, -0.1});
  sheet.min_range_m = 0.5;
  sheet.range_noise_m = 0.01;
  return sheet;
}

SonarPing Ping(double range, double head_angle) {
  SonarPing ping;
  ping.range = range;
  ping.head_angle = head_angle;
  return ping;
}

// A window of one frame at kNow, on the truth; the frame before was 0.1 s earlier.
class SonarLinkTest : public ::testing::Test {
 protected:
  static constexpr Time kBefore{2'900'000'000}, kNow{3'000'000'000};
  static constexpr Duration kStep{1'000'000};

  SonarLinkTest()
      : imu_(ImuNoiseModel{}), window_(WindowConfig{}, StereoGeometry(testing::SyntheticStereo())) {
    for (const TimedImuSample& sample : testing::MotionSamples(kBefore, kNow, kStep))
      imu_.Add(sample.t, sample.sample);
    TrackedFrame seen;
    seen.t = kNow;
    window_.Start(testing::MotionAt(kNow), {}, seen);
  }

  std::vector<EstimatorEvent> Feed(SonarLink& link, bool is_tracking = true) {
    return link.Feed(window_, imu_, testing::MotionAt(kBefore), is_tracking);
  }

  /// Where a ping at `t` would meet something.
  static Eigen::Vector3d EchoAt(Time t, const SonarPing& ping) {
    return testing::MotionAt(t).T_WI * Sheet().T_IS * (ping.range * SonarBeam(ping.head_angle));
  }

  /// Landmarks of a face that the beam of a ping at `t` meets at a right angle.
  static std::vector<Eigen::Vector3d> FaceAt(Time t, const SonarPing& ping) {
    const Eigen::Vector3d beam =
        testing::MotionAt(t).T_WI.q() * (Sheet().T_IS.q() * SonarBeam(ping.head_angle));
    const Eigen::Vector3d u = beam.unitOrthogonal(), v = beam.cross(u);
    std::vector<Eigen::Vector3d> face;
    for (const double a : {-0.06, 0.06})
      for (const double b : {-0.06, 0.06}) face.emplace_back(EchoAt(t, ping) + a * u + b * v);
    return face;
  }

  /// What is said to 99 pings that have 3 % more range than the landmarks that they met.
  std::string SaidOfAWrongRig(SonarLink& link, bool is_tracking) {
    std::string said;
    link.Remember(kBefore, FaceAt(kBefore, Ping(2.0, 0.3)));
    for (Time t = kBefore + kStep; t < kNow; t = t + kStep) {
      link.Add(t, Ping(2.06, 0.3));
      for (const EstimatorEvent& event : Feed(link, is_tracking)) said += event.message + "\n";
    }
    return said;
  }

  ImuBuffer imu_;
  SlidingWindow window_;
};

TEST_F(SonarLinkTest, RefusesWhatIsNoNumberOrComesTwice) {
  SonarLink link(Sheet(), {});
  EXPECT_FALSE(link.Add(kNow, Ping(std::numeric_limits<double>::quiet_NaN(), 0.0)));
  EXPECT_FALSE(link.Add(kNow, Ping(1.0, std::numeric_limits<double>::infinity())));
  EXPECT_TRUE(link.Add(kNow, Ping(1.0, 0.0)));
  EXPECT_FALSE(link.Add(kNow, Ping(1.0, 0.0)));
  EXPECT_FALSE(link.Add(kNow - kStep, Ping(1.0, 0.0)));
}

TEST_F(SonarLinkTest, PosesAPingAtItsOwnTimeAndWaitsForTheWindow) {
  SonarLink link(Sheet(), {});
  const Time t = kBefore + Duration{40'000'000};
  const SonarPing ping = Ping(2.0, 0.7);
  ASSERT_TRUE(link.Add(t, ping));
  ASSERT_TRUE(link.Add(kNow + kStep, ping));
  EXPECT_TRUE(Feed(link).empty());
  ASSERT_EQ(link.echoes().size(), 1U);
  EXPECT_EQ(link.echoes().front().t, t);
  EXPECT_LT((link.echoes().front().p_W - EchoAt(t, ping)).norm(), 1e-4);
}

TEST_F(SonarLinkTest, BelievesNoEchoThatIsTooNearOrTooFar) {
  SonarLink link(Sheet(), {});
  EXPECT_TRUE(link.Add(kBefore + kStep, Ping(0.0, 0.0)));  // No echo at all.
  EXPECT_TRUE(link.Add(kBefore + kStep + kStep, Ping(0.49, 0.0)));
  EXPECT_TRUE(link.Add(kNow, Ping(SonarConfig{}.max_range_m + 0.01, 0.0)));
  Feed(link);
  EXPECT_TRUE(link.echoes().empty());
}

TEST_F(SonarLinkTest, SaysOnceThatTheRigIsWrong) {
  SonarLink link(Sheet(), {});
  const std::string said = SaidOfAWrongRig(link, true);
  EXPECT_NE(said.find('%'), std::string::npos) << said;
  EXPECT_EQ(std::ranges::count(said, '\n'), 1) << said;
}

TEST_F(SonarLinkTest, DriftInTheDarkIsNoMatterOfTheRig) {
  SonarLink link(Sheet(), {});
  EXPECT_EQ(SaidOfAWrongRig(link, false), "");
}

// The frames of a new map know nothing of the old one's landmarks: no ping meets any.
TEST_F(SonarLinkTest, AnotherMapBeginsWithoutLandmarks) {
  SonarLink link(Sheet(), {});
  SaidOfAWrongRig(link, false);
  link.StartMap();
  std::string said;
  for (int k = 0; k < 99; ++k) {
    link.Add(kNow - Duration{900'000} + Duration{1'000 * k}, Ping(2.06, 0.3));
    for (const EstimatorEvent& event : Feed(link)) said += event.message;
  }
  EXPECT_EQ(said, "");
}

}  // namespace
}  // namespace drydock::svin2
