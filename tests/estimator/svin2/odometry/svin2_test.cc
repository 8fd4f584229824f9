#include "estimator/svin2/odometry/svin2.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/estimator/svin2/synthetic_motion.h"
#include "tests/estimator/svin2/synthetic_tracks.h"

namespace drydock::svin2 {
namespace {

constexpr Duration kFramePeriod{66'000'000};
constexpr Duration kImuPeriod{2'000'000};
constexpr double kSurface = 6.0;  // [m]

Rig SyntheticRig() {
  Rig rig;
  rig.stereo = testing::SyntheticStereo();
  rig.imu.rate_hz = 500.0;
  rig.depth.rate_hz = 1.0;
  rig.depth.p_ID = {-0.28, -0.02, 0.03};
  rig.depth.noise_m = 1e-3;
  return rig;
}

/// The synthetic motion as a robot's computer would get it. Images are empty: points come straight
/// from the landmarks.
class SyntheticDive {
 public:
  explicit SyntheticDive(const Svin2Config& config = {}, const Rig& rig = SyntheticRig())
      : tracks_(300, 0.0) {
    estimator = std::make_unique<Svin2>(
        rig, config,
        [this](Time t, const StereoFrame&, const std::optional<MotionPrediction>&,
               const LandmarkLookup&) {
          TrackedFrame seen = tracks_.See(t, testing::MotionAt(t).T_WI);
          const bool is_silent = camera_is_silent && camera_is_silent(t);
          if (is_silent || (is_dark && is_dark(t))) {
            seen = TrackedFrame{};
            seen.t = t;
          }
          if (only_keyframes) seen.is_keyframe = true;
          return seen;
        });
  }

  void RunTo(double seconds) {
    for (; now_ <= Time::FromSeconds(seconds); now_ = now_ + kImuPeriod) {
      const bool is_silent = camera_is_silent && camera_is_silent(now_);
      if ((now_ - first_frame).ns % frame_period.ns == 0 && !is_silent) {
        Add(StereoFrame{});
        ++num_frames;
      }
      if (now_.ns % 1'000'000'000 == 0) {
        const double z = (testing::MotionAt(now_).T_WI * SyntheticRig().depth.p_ID).z();
        Add(DepthSample{kSurface - z + depth_error_m});
      }
      Add(testing::MotionImu(now_));
      for (EstimatorEvent& event : estimator->TakeEvents()) said += event.message + "\n";
    }
  }

  std::size_t NumTimed(const std::string& name) const {
    for (const StageTimings& stage : estimator->Timings())
      if (stage.name == name) return stage.count;
    return 0;
  }

  std::unique_ptr<Svin2> estimator;
  std::size_t num_frames = 0;  ///< That were given.
  std::function<bool(Time)> is_dark, camera_is_silent;
  bool only_keyframes = false;
  Time first_frame;
  Duration frame_period = kFramePeriod;
  double depth_error_m = 0.0;
  std::string said;

 private:
  void Add(const Reading& reading) { estimator->Add({now_, now_, reading}); }

  testing::SyntheticTracks tracks_;
  Time now_;
};

/// How far the way between two published poses is from the true one.
double ErrorBetween(const Trajectory& odometry, std::size_t i, std::size_t j) {
  const auto true_way =
      testing::MotionAt(odometry[i].t).T_WI.Inverse() * testing::MotionAt(odometry[j].t).T_WI;
  const auto way = odometry[i].T_WI.Inverse() * odometry[j].T_WI;
  return way.BoxMinus(true_way).norm();
}

TEST(Svin2, FollowsTheTruthFromAKnownStart) {
  SyntheticDive dive;
  dive.estimator->Start(testing::MotionAt(Time{}));
  dive.RunTo(6.0);
  const Trajectory& odometry = dive.estimator->Odometry();
  ASSERT_EQ(odometry.size(), 91U);  // 0 to 5.94 s; each as soon as the IMU has come up to it.
  for (const StampedPose& pose : odometry)
    // Depth is carried from its own time to the nearest frame at constant speed.
    ASSERT_LT(pose.T_WI.BoxMinus(testing::MotionAt(pose.t).T_WI).norm(), 1e-3);
  ASSERT_TRUE(dive.estimator->Latest().has_value());
  EXPECT_EQ(dive.estimator->Latest()->status, TrackingStatus::kTracking);
  EXPECT_TRUE(dive.estimator->Latest()->pose_covariance.has_value());
  EXPECT_GT(dive.estimator->Latest()->vision->landmarks_in_view, 30);
  EXPECT_GT(dive.estimator->Latest()->vision->tracked_points, 30);
  EXPECT_FALSE(dive.estimator->Map().landmarks.empty());
  EXPECT_EQ(dive.said, "");
}

// At 10 Hz, each reading 80 ms before a frame: also then one of them is what the others refer to,
// and one that is 3 m wrong is found out.
TEST(Svin2, UsesDepthWhereFramesAreRareToo) {
  Rig rig = SyntheticRig();
  rig.stereo.rate_hz = 10.0;
  SyntheticDive dive({}, rig);
  dive.frame_period = Duration{100'000'000};
  dive.first_frame = Time{80'000'000};
  dive.estimator->Start(testing::MotionAt(Time{}));
  dive.RunTo(3.5);
  EXPECT_EQ(dive.said, "");
  dive.depth_error_m = 3.0;
  dive.RunTo(4.5);
  EXPECT_NE(dive.said.find("was not believed"), std::string::npos) << dive.said;
}

// The surface that the first reading found 5 m too high is given up, and pulls at nothing.
TEST(Svin2, SurvivesASpikeInTheFirstDepth) {
  SyntheticDive dive;
  dive.depth_error_m = 5.0;
  dive.estimator->Start(testing::MotionAt(Time{}));
  dive.RunTo(0.5);
  dive.depth_error_m = 0.0;
  dive.RunTo(6.0);
  EXPECT_NE(dive.said.find("the surface is found anew"), std::string::npos) << dive.said;
  EXPECT_EQ(std::ranges::count(dive.said, '\n'), 2) << dive.said;
  for (const StampedPose& pose : dive.estimator->Odometry())
    ASSERT_LT(pose.T_WI.BoxMinus(testing::MotionAt(pose.t).T_WI).norm(), 1e-3);
}

TEST(Svin2, InitialisesItselfInMotion) {
  SyntheticDive dive;
  dive.estimator->Start(std::nullopt);
  dive.RunTo(8.0);
  const Trajectory& odometry = dive.estimator->Odometry();
  ASSERT_GT(odometry.size(), 60U);
  EXPECT_LT(ErrorBetween(odometry, 0, odometry.size() - 1), 0.02);
  // Level: gravity was found.
  const Eigen::Vector3d up = odometry.back().T_WI.q().conjugate() * Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d true_up =
      testing::MotionAt(odometry.back().t).T_WI.q().conjugate() * Eigen::Vector3d::UnitZ();
  EXPECT_LT((up - true_up).norm(), 5e-3);
  EXPECT_NE(dive.said.find("initialised: started in motion"), std::string::npos) << dive.said;
}

TEST(Svin2, SaysNothingWhileThereIsNothingToSee) {
  SyntheticDive dive;
  dive.is_dark = [](Time) { return true; };
  dive.estimator->Start(std::nullopt);
  dive.RunTo(5.0);
  EXPECT_TRUE(dive.estimator->Odometry().empty());
  EXPECT_FALSE(dive.estimator->Latest().has_value());
}

TEST(Svin2, ReckonsThroughDarkness) {
  SyntheticDive dive;
  dive.is_dark = [](Time t) { return t > Time::FromSeconds(4) && t < Time::FromSeconds(8); };
  dive.estimator->Start(testing::MotionAt(Time{}));
  dive.RunTo(7.0);
  EXPECT_EQ(dive.estimator->Latest()->status, TrackingStatus::kDeadReckoning);
  EXPECT_EQ(dive.estimator->Latest()->vision->landmarks_in_view, 0);
  EXPECT_EQ(dive.estimator->Latest()->vision->empty_quadrants, 4);
  dive.RunTo(10.0);
  EXPECT_EQ(dive.estimator->Latest()->status, TrackingStatus::kTracking);
  EXPECT_EQ(dive.estimator->Latest()->map_id, 0);
  const StampedPose& last = dive.estimator->Odometry().back();
  EXPECT_LT((last.T_WI.p() - testing::MotionAt(last.t).T_WI.p()).norm(), 0.02);
}

// Nothing comes from the cameras: no black images, nothing at all.
TEST(Svin2, ReckonsOnThroughACamerasSilence) {
  SyntheticDive dive;
  dive.camera_is_silent = [](Time t) {
    return t > Time::FromSeconds(3) && t < Time::FromSeconds(7);
  };
  dive.estimator->Start(testing::MotionAt(Time{}));
  dive.RunTo(6.5);
  const auto latest = dive.estimator->Latest();
  EXPECT_EQ(latest->status, TrackingStatus::kDeadReckoning);
  EXPECT_GT(latest->state.t, Time::FromSeconds(5.7)) << "twice a second";
  EXPECT_LT((latest->state.T_WI.p() - testing::MotionAt(latest->state.t).T_WI.p()).norm(), 0.02);
  dive.RunTo(10.0);
  EXPECT_EQ(dive.estimator->Latest()->status, TrackingStatus::kTracking);
  EXPECT_EQ(dive.estimator->Latest()->map_id, 0);
  EXPECT_EQ(dive.NumTimed("front end"), dive.num_frames) << "a silence is no stereo frame";
  EXPECT_NE(dive.said.find("vision failed (0 landmarks in view"), std::string::npos) << dive.said;
  EXPECT_NE(dive.said.find("vision is back"), std::string::npos) << dive.said;
}

TEST(Svin2, StartsANewMapAfterItWasLost) {
  Svin2Config config;
  config.report_keyframes = true;
  config.tracking.longest_blindness_s = 2.0;
  SyntheticDive dive(config);
  dive.only_keyframes = true;  // The lost map reports some while the new one is being found.
  dive.is_dark = [](Time t) { return t > Time::FromSeconds(3) && t < Time::FromSeconds(7); };
  dive.estimator->Start(testing::MotionAt(Time{}));
  dive.RunTo(6.5);
  EXPECT_EQ(dive.estimator->Latest()->status, TrackingStatus::kLost);
  dive.RunTo(11.0);
  EXPECT_EQ(dive.estimator->Latest()->status, TrackingStatus::kTracking);
  EXPECT_EQ(dive.estimator->Latest()->map_id, 1);
  EXPECT_NE(dive.said.find("initialised"), std::string::npos);
  // One pose a frame all the way, and the new map lies where the old one was.
  EXPECT_EQ(dive.estimator->Odometry().size(), 167U);
  const StampedPose& last = dive.estimator->Odometry().back();
  EXPECT_LT((last.T_WI.p() - testing::MotionAt(last.t).T_WI.p()).norm(), 0.2);
  // The new map begins some frames back, and yet keyframes are reported as time goes on.
  const std::vector<Keyframe> keyframes = dive.estimator->TakeKeyframes();
  for (std::size_t k = 1; k < keyframes.size(); ++k)
    EXPECT_LT(keyframes[k - 1].t, keyframes[k].t) << k;
  EXPECT_EQ(keyframes.front().map_id, 0);
  EXPECT_EQ(keyframes.back().map_id, 1);
}

/// How far a body is thought to be from where it is after 40 s of darkness, begun with a tilt of
/// 0.02 rad that nothing shows.
double ErrorAfterDarkness(double habit_sigma) {
  Svin2Config config;
  config.tracking.longest_blindness_s = 2.0;
  config.habit.sigma = habit_sigma;
  SyntheticDive dive(config);
  dive.is_dark = [](Time) { return true; };
  NavState tilted = testing::MotionAt(Time{});
  tilted.T_WI = Pose(ExpSO3({0.02, 0.0, 0.0}) * tilted.T_WI.q(), tilted.T_WI.p());
  dive.estimator->Start(tilted);
  dive.RunTo(40.0);
  EXPECT_EQ(dive.estimator->Latest()->status, TrackingStatus::kLost);
  const StampedPose& last = dive.estimator->Odometry().back();
  return (last.T_WI.p() - testing::MotionAt(last.t).T_WI.p()).norm();
}

TEST(Svin2, DoesNotRunAwayWhenItIsLost) {
  EXPECT_GT(ErrorAfterDarkness(0.0), 50.0) << "as an IMU does by itself";
  EXPECT_LT(ErrorAfterDarkness(SwimmingHabit::Config{}.sigma), 15.0) << "it swims by 8 m";
}

}  // namespace
}  // namespace drydock::svin2
