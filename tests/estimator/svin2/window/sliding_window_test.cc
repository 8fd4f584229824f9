#include "estimator/svin2/window/sliding_window.h"

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "tests/estimator/svin2/synthetic_motion.h"
#include "tests/estimator/svin2/synthetic_tracks.h"

namespace drydock::svin2 {
namespace {

using Eigen::Vector3d;

constexpr Duration kFramePeriod{66'666'667};
constexpr Duration kImuPeriod{1'000'000};  // Fine, so that integration leaves no error to speak of.

Time FrameTime(int k) { return Time{} + Duration{k * kFramePeriod.ns}; }

/// Carries a window along the synthetic motion.
class WindowRun {
 public:
  explicit WindowRun(int landmarks = 300, double sigma_px = 0.0, const WindowConfig& config = {})
      : tracks(landmarks, sigma_px), window(config, StereoGeometry(testing::SyntheticStereo())) {}

  void Start(const NavState& state) { window.Start(state, {}, See(0)); }

  ImuPreintegration Imu(int k) const {
    const Time begin = FrameTime(k - 1), end = FrameTime(k);
    const NavState latest = window.Latest();
    return *ImuPreintegration::Over(
        testing::MotionSamples(begin, end, kImuPeriod, gyro_bias, accel_bias), begin, end,
        {latest.gyro_bias, latest.accel_bias}, ImuNoiseModel{});
  }

  TrackedFrame See(int k) {
    TrackedFrame seen = tracks.See(FrameTime(k), testing::MotionAt(FrameTime(k)).T_WI);
    if (change) change(k, seen);
    return seen;
  }

  void Step(int k) {
    window.AddFrame(See(k), Imu(k));
    window.Optimise();
    window.Slide();
  }

  void RunTo(int last) {
    Start(testing::MotionAt(Time{}));
    for (int k = 1; k <= last; ++k) Step(k);
  }

  double PositionError(int k) const {
    return (window.Latest().T_WI.p() - testing::MotionAt(FrameTime(k)).T_WI.p()).norm();
  }

  testing::SyntheticTracks tracks;
  SlidingWindow window;
  std::function<void(int k, TrackedFrame& seen)> change;
  Vector3d gyro_bias = Vector3d::Zero(), accel_bias = Vector3d::Zero();
};

TEST(SlidingWindow, StaysAtTheTruthWithoutNoise) {
  WindowRun run;
  run.RunTo(75);
  const NavState truth = testing::MotionAt(FrameTime(75));
  const NavState latest = run.window.Latest();
  EXPECT_EQ(latest.t, truth.t);
  // What is left is the IMU's trapezoidal rule at 1 kHz.
  EXPECT_LT(latest.T_WI.BoxMinus(truth.T_WI).norm(), 1e-5);
  EXPECT_LT((latest.v_W - truth.v_W).norm(), 1e-4);
}

TEST(SlidingWindow, FindsGyroBiasAndVelocityFromAWrongStart) {
  WindowRun run;
  run.gyro_bias = {0.01, -0.005, 0.008};
  run.accel_bias = {0.03, -0.02, 0.04};
  NavState start = testing::MotionAt(Time{});
  start.v_W += Vector3d(0.3, -0.2, 0.1);
  run.Start(start);
  for (int k = 1; k <= 75; ++k) run.Step(k);
  const NavState latest = run.window.Latest();
  EXPECT_LT((latest.gyro_bias - run.gyro_bias).norm(), 2e-4);
  EXPECT_LT((latest.v_W - testing::MotionAt(FrameTime(75)).v_W).norm(), 2e-3);
  EXPECT_LT(run.PositionError(75), 5e-3);
}

TEST(SlidingWindow, KeepsItsSize) {
  WindowRun run;
  run.RunTo(75);
  const std::size_t landmarks = run.window.LandmarkPositions().size();
  EXPECT_GT(landmarks, 50U);
  EXPECT_LE(landmarks, 300U);
  EXPECT_LE(run.window.NumFrames(), 8);
  EXPECT_GE(run.window.NumFrames(), 3);
  EXPECT_GT(run.window.LandmarksInView(), 30);
}

TEST(SlidingWindow, NoiseGivesTheErrorThatItsCovarianceSays) {
  double sum = 0.0;
  constexpr int kRuns = 10;
  for (int seed = 0; seed < kRuns; ++seed) {
    WindowRun run(300, 0.5);
    run.tracks = testing::SyntheticTracks(300, 0.5, static_cast<std::uint64_t>(seed) + 1);
    run.RunTo(45);
    const auto covariance = run.window.LatestCovariance();
    ASSERT_TRUE(covariance.has_value());
    const Vector6d error = run.window.Latest().T_WI.BoxMinus(testing::MotionAt(FrameTime(45)).T_WI);
    sum += error.dot(covariance->ldlt().solve(error));
  }
  // 60 degrees of freedom; the IMU is exact, so that errors are smaller than its noise allows.
  EXPECT_LT(sum / (6 * kRuns), 1.5);
  EXPECT_GT(sum / (6 * kRuns), 0.05);
}

TEST(SlidingWindow, CarriesOnByInertiaWithoutPoints) {
  WindowRun run;
  run.change = [](int k, TrackedFrame& seen) {
    if (k > 30 && k <= 60) {
      seen.points.clear();
      seen.is_keyframe = false;
    }
  };
  run.RunTo(60);
  EXPECT_EQ(run.window.LandmarksInView(), 0);
  EXPECT_FALSE(run.window.SeesEnough());
  EXPECT_LT(run.PositionError(60), 5e-3);
  for (int k = 61; k <= 75; ++k) run.Step(k);
  EXPECT_GT(run.window.LandmarksInView(), 30);
  EXPECT_TRUE(run.window.SeesEnough());
  EXPECT_LT(run.PositionError(75), 5e-3);
}

/// The position's standard deviation [m] after 2 s in the dark that begin 3 s after the only
/// keyframe.
double DoubtInTheDark(const WindowConfig& config) {
  WindowRun run(300, 0.0, config);
  run.change = [](int k, TrackedFrame& seen) {
    seen.is_keyframe = k == 0;
    if (k > 45) seen.points.clear();
  };
  run.RunTo(75);
  EXPECT_LE(run.window.NumFrames(), config.keyframes + config.recent_frames);
  const auto covariance = run.window.LatestCovariance();
  return covariance ? std::sqrt(covariance->diagonal().head<3>().sum()) : NAN;
}

TEST(SlidingWindow, GoesIntoTheDarkWithWhatItSawLast) {
  EXPECT_LT(DoubtInTheDark({}), 0.2);
  WindowConfig forgetful;
  forgetful.min_landmarks = 0;
  EXPECT_GT(DoubtInTheDark(forgetful), 1.0) << "where the last frames are forgotten";
}

TEST(SlidingWindow, LinksToNoFrameThatIsNoKeyframeThoughItStays) {
  WindowRun run;
  run.change = [](int k, TrackedFrame& seen) {
    seen.is_keyframe = k == 0;
    if (k > 20) seen.points.clear();
  };
  run.RunTo(26);
  const auto link = run.window.LinkToKeyframe();
  ASSERT_TRUE(link.has_value());
  const Pose way = testing::MotionAt(Time{}).T_WI.Inverse() * testing::MotionAt(FrameTime(26)).T_WI;
  EXPECT_LT(link->T_before_now.BoxMinus(way).norm(), 1e-2);
}

TEST(SlidingWindow, OutliersDoNotMoveIt) {
  WindowRun run;
  run.change = [](int k, TrackedFrame& seen) {
    for (TrackedPoint& point : seen.points)
      if ((point.id + static_cast<unsigned>(k)) % 7 == 0) point.left.x() += 25.0;
  };
  run.RunTo(45);
  EXPECT_LT(run.PositionError(45), 2e-3);
}

TEST(SlidingWindow, DepthHoldsTheHeight) {
  // The IMU's accelerometer is biased upwards and nothing is seen: only pressure can tell.
  const Vector3d p_ID(-0.28, -0.02, 0.03);
  const auto height_error = [&](bool with_depth) {
    WindowRun run;
    run.accel_bias = {0.0, 0.0, 0.05};
    run.change = [](int k, TrackedFrame& seen) {
      if (k > 5) seen.points.clear();
    };
    run.Start(testing::MotionAt(Time{}));
    const auto depth_at = [&](Time t) { return 6.0 - (testing::MotionAt(t).T_WI * p_ID).z(); };
    if (with_depth) run.window.AddDepth(Time{}, {depth_at(Time{}), p_ID, {}, 2e-3});
    for (int k = 1; k <= 60; ++k) {
      run.window.AddFrame(run.See(k), run.Imu(k));
      if (with_depth && k % 15 == 0) {
        run.window.AddDepth(FrameTime(k), {depth_at(FrameTime(k)), p_ID, {}, 2e-3});
      }
      run.window.Optimise();
      run.window.Slide();
    }
    return std::abs(run.window.Latest().T_WI.p().z() -
                    testing::MotionAt(FrameTime(60)).T_WI.p().z());
  };
  EXPECT_GT(height_error(false), 0.05);
  EXPECT_LT(height_error(true), 5e-3);
}

// A state found from frames that the window sees as well may be off as far as they let it be. It
// must not count twice, as what they say and as what was known before.
TEST(SlidingWindow, AStartsBiasIsNoPriorWhereAnotherIsGiven) {
  const auto gyro_bias_after = [](const std::optional<ImuBias>& expected) {
    WindowRun run(0);  // In the dark nothing but the prior tells.
    NavState found = testing::MotionAt(Time{});
    found.gyro_bias = {0.01, 0.0, 0.0};
    StartSigmas sigmas;
    sigmas.speed_bias.gyro_bias = 1e-5;
    run.window.Start(found, sigmas, run.See(0), expected);
    for (int k = 1; k <= 5; ++k) run.Step(k);
    return run.window.Latest().gyro_bias.x();
  };
  EXPECT_NEAR(gyro_bias_after(std::nullopt), 0.01, 1e-6);
  EXPECT_NEAR(gyro_bias_after(ImuBias{}), 0.0, 1e-6);
}

TEST(SlidingWindow, AWrongFirstDepthIsOneOfMany) {
  // It reads 20 mm too deep. Taken for exact it would lift all heights by as much, later readings
  // being as sure; as an estimate the surface comes to where the readings are on average.
  const Vector3d p_ID(-0.28, -0.02, 0.03);
  WindowRun run;
  StartSigmas level;
  level.roll_pitch = 1e-4;
  run.window.Start(testing::MotionAt(Time{}), level, run.See(0));
  EXPECT_FALSE(run.window.SurfaceHeight().has_value());
  const auto depth_at = [&](int k) {
    return 6.0 - (testing::MotionAt(FrameTime(k)).T_WI * p_ID).z();
  };
  run.window.AddDepth(FrameTime(0), {depth_at(0) + 0.02, p_ID, {}, 0.01});
  EXPECT_NEAR(run.window.SurfaceHeight().value(), 6.02, 1e-9);
  constexpr int kLast = 75;
  for (int k = 1; k <= kLast; ++k) {
    run.window.AddFrame(run.See(k), run.Imu(k));
    if (k % 5 == 0) run.window.AddDepth(FrameTime(k), {depth_at(k), p_ID, {}, 0.01});
    run.window.Optimise();
    run.window.Slide();
  }
  EXPECT_NEAR(run.window.SurfaceHeight().value(), 6.0, 0.02 / 3.0);
  EXPECT_LT(run.PositionError(kLast), 0.02 / 3.0);
}

TEST(SlidingWindow, ADepthFarFromAllFramesSaysLittle) {
  // Half a second before the first frame, at constant speed: 1/2 0.5 m/s^2 (0.5 s)^2 = 6 cm.
  WindowRun run;
  run.Start(testing::MotionAt(FrameTime(0)));
  run.window.AddDepth(FrameTime(0) - Duration{500'000'000}, {6.1, Vector3d::Zero(), {}, 2e-3});
  for (int k = 1; k <= 5; ++k) {
    run.window.AddFrame(run.See(k), run.Imu(k));
    const double depth = 6.0 - testing::MotionAt(FrameTime(k)).T_WI.p().z();
    run.window.AddDepth(FrameTime(k), {depth, Vector3d::Zero(), {}, 2e-3});
    run.window.Optimise();
  }
  EXPECT_NEAR(run.window.SurfaceHeight().value(), 6.0, 1e-3);
}

TEST(SlidingWindow, PingsAtWhatHasDepartedDoNotTellTheAbsolutePosition) {
  // Landmarks that are no longer estimated lie all around, held where the window thinks them to be.
  // They drifted with it: however many pings, position and yaw stay as unsure as without.
  const auto covariance = [](bool with_sonar) {
    WindowRun run(300, 0.5);
    run.Start(testing::MotionAt(Time{}));
    for (int k = 1; k <= 75; ++k) {
      run.window.AddFrame(run.See(k), run.Imu(k));
      const Pose T_WI = run.window.Latest().T_WI;
      const double angle = 0.7 * k;
      const Vector3d wall = T_WI * Vector3d(0.0, 2.0 * std::cos(angle), 2.0 * std::sin(angle));
      SonarRangeObservation ping;
      ping.range = 2.0;
      ping.sigma_range = 0.01;
      ping.sigma_patch = 0.03;
      if (with_sonar) run.window.AddSonar(ping, {}, std::array{wall});
      run.window.Optimise();
      run.window.Slide();
    }
    return run.window.LatestCovariance().value();
  };
  const auto with = covariance(true), without = covariance(false);
  for (const int axis : {0, 1, 2, 5}) {
    EXPECT_GT(with(axis, axis), 0.6 * without(axis, axis)) << axis;
    EXPECT_LT(with(axis, axis), 1.2 * without(axis, axis)) << axis;
  }
}

TEST(SlidingWindow, SameInputsSameBytes) {
  WindowRun first(300, 0.5), second(300, 0.5);
  first.RunTo(30);
  second.RunTo(30);
  const NavState a = first.window.Latest(), b = second.window.Latest();
  EXPECT_EQ(a.T_WI.p(), b.T_WI.p());
  EXPECT_EQ(a.T_WI.q().coeffs(), b.T_WI.q().coeffs());
  EXPECT_EQ(a.v_W, b.v_W);
}

TEST(SlidingWindow, LinksLeadFromTheNewestKeyframeAsItHasMoved) {
  WindowRun run;
  int keyframe = 0, newest = 0;  // Before the frame at hand, and with it.
  run.change = [&](int k, TrackedFrame& seen) {
    keyframe = newest;
    seen.is_keyframe = k % 12 == 0;
    if (seen.is_keyframe) newest = k;
  };
  run.Start(testing::MotionAt(Time{}));
  for (int k = 1; k <= 45; ++k) {
    run.Step(k);
    const auto link = run.window.LinkToKeyframe();
    ASSERT_TRUE(link.has_value()) << k;
    const Pose T_before_now = testing::MotionAt(FrameTime(keyframe)).T_WI.Inverse() *
                              testing::MotionAt(FrameTime(k)).T_WI;
    EXPECT_LT(link->T_before_now.BoxMinus(T_before_now).norm(), 1e-5) << k;
  }
  EXPECT_EQ(keyframe, 36);
}

TEST(SlidingWindow, LinksHaveTheErrorThatTheirCovarianceSays) {
  double sum = 0.0;
  constexpr int kRuns = 6;
  for (std::uint64_t seed = 1; seed <= kRuns; ++seed) {
    WindowRun run(300, 0.5);
    run.tracks = testing::SyntheticTracks(300, 0.5, seed);
    run.change = [&](int k, TrackedFrame& seen) { seen.is_keyframe = k % 12 == 0; };
    run.RunTo(45);
    const OdometryLink link = run.window.LinkToKeyframe().value();
    const Vector6d error = link.T_before_now.BoxMinus(
        testing::MotionAt(FrameTime(36)).T_WI.Inverse() * testing::MotionAt(FrameTime(45)).T_WI);
    sum += error.dot(link.covariance.ldlt().solve(error));
  }
  // 36 degrees of freedom; the IMU is exact, so that errors are smaller than its noise allows.
  EXPECT_LT(sum / (6 * kRuns), 1.5);
  EXPECT_GT(sum / (6 * kRuns), 0.05);
}

TEST(SlidingWindow, LinksTheLatestFrameToTheKeyframeBefore) {
  WindowRun run(300, 0.3);
  run.Start(testing::MotionAt(Time{}));
  EXPECT_FALSE(run.window.LinkToKeyframe()) << "to itself";
  for (int k = 1; k <= 12; ++k) run.Step(k);
  const OdometryLink link = run.window.LinkToKeyframe().value();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> eigen(link.covariance);
  EXPECT_GT(eigen.eigenvalues().minCoeff(), 0.0);
  // Less is doubtful since the keyframe than since the start.
  const auto absolute = run.window.LatestCovariance().value();
  EXPECT_LT(link.covariance.diagonal().head<3>().sum(), absolute.diagonal().head<3>().sum());
  // One of the frames before is where it leads to, and within what it admits to.
  const Pose T_W_before = run.window.Latest().T_WI * link.T_before_now.Inverse();
  double nearest = 1.0;
  int keyframe = 0;
  for (int k = 0; k < 12; ++k) {
    const double apart = (testing::MotionAt(FrameTime(k)).T_WI.p() - T_W_before.p()).norm();
    if (apart < nearest) keyframe = k;
    nearest = std::min(nearest, apart);
  }
  EXPECT_LT(nearest, 0.01);
  const Pose truth =
      testing::MotionAt(FrameTime(keyframe)).T_WI.Inverse() * testing::MotionAt(FrameTime(12)).T_WI;
  const Vector6d error = link.T_before_now.BoxMinus(truth);
  EXPECT_LT(error.dot(link.covariance.llt().solve(error)), 22.5) << "1 of 1000, 6 dof";
}

}  // namespace
}  // namespace drydock::svin2
