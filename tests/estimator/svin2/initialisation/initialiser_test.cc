#include "estimator/svin2/initialisation/initialiser.h"

#include <cmath>

#include <gtest/gtest.h>

#include "estimator/inertial/imu_integration.h"
#include "sensors_models/base/check.h"
#include "sensors_models/base/random_stream.h"
#include "sensors_models/base/yaml_node.h"
#include "tests/estimator/svin2/initialisation/synthetic_dive.h"

namespace drydock::svin2 {
namespace {

using testing::MakeSyntheticDive;
using testing::MotionKind;
using testing::RandomMotion;
using testing::SyntheticDive;
using testing::SyntheticDiveConfig;
using testing::V3Depth;
using testing::V3Stereo;

std::optional<InitialisedStart> Initialise(Initialiser& initialiser, const SyntheticDive& dive) {
  for (const auto& input : dive.inputs) {
    auto start = initialiser.Add(input.frame, input.imu, input.depth);
    if (start.has_value()) return start;
  }
  return std::nullopt;
}

struct StartError {
  double scale = 0.0;     // Of the way from the first frame, as a share; 0 below 0.2 m.
  double way = 0.0;       // The furthest from the first frame, in truth [m].
  double position = 0.0;  // Largest [m].
  double tilt = 0.0;      // Largest [rad].
  double speed = 0.0;     // Of the last frame [m/s].
};

// Against truth, moved to where the start's first frame has position 0 and yaw 0.
StartError Compare(const InitialisedStart& start, const testing::SyntheticMotion& motion) {
  const Pose first = motion.At(start.frames.front().tracked.t.Seconds()).T_WI;
  const Eigen::Quaterniond unyaw = FromYawPitchRoll(-YawOf(first.q()), 0.0, 0.0);
  StartError error;
  double by_true = 0.0, squares = 0.0;
  for (const InitialisedFrame& frame : start.frames) {
    const NavState truth = motion.At(frame.tracked.t.Seconds());
    const Eigen::Vector3d p = unyaw * (truth.T_WI.p() - first.p());
    by_true += p.dot(frame.T_WI.p());
    squares += p.squaredNorm();
    error.way = std::max(error.way, p.norm());
    error.position = std::max(error.position, (frame.T_WI.p() - p).norm());
    const Eigen::Vector3d up = frame.T_WI.q().conjugate() * Eigen::Vector3d::UnitZ();
    const Eigen::Vector3d true_up = truth.T_WI.q().conjugate() * Eigen::Vector3d::UnitZ();
    error.tilt = std::max(error.tilt, up.cross(true_up).norm());
    error.speed = (frame.v_W - unyaw * truth.v_W).norm();
  }
  // Position errors of a millimetre or two are no error of scale.
  if (error.way > 0.2) error.scale = by_true / squares - 1.0;
  return error;
}

constexpr std::uint64_t kStarts = 20;
constexpr MotionKind kKinds[] = {MotionKind::kStill, MotionKind::kMoving, MotionKind::kPitching};
constexpr double kDegree = M_PI / 180.0;

SyntheticDiveConfig NoisyDive(MotionKind kind, std::uint64_t seed) {
  SyntheticDiveConfig config;
  config.motion = RandomMotion(kind, seed);
  config.seed = seed;
  config.pixel_sigma = 0.5;
  config.imu_noise = config.depth_noise = true;
  return config;
}

// Only the integration of 10 ms steps is left, some 1e-5 of each velocity's change, and what the
// gyro's prior keeps of its bias of 0.023 rad/s: over a second, white noise of 1.6e-3
// rad/s/sqrt(Hz) knows it to 1.6e-3, so that N(0, 0.01) keeps a share of 0.16^2: 5.9e-4 rad/s.
TEST(Initialiser, FindsTheStateExactlyWithoutNoise) {
  for (const MotionKind kind : kKinds) {
    SyntheticDiveConfig config;
    config.motion = RandomMotion(kind, 3);
    config.bias.gyro = {0.02, -0.01, 0.005};
    Initialiser initialiser({}, V3Stereo(), {}, V3Depth());
    const auto start = Initialise(initialiser, MakeSyntheticDive(config));
    ASSERT_TRUE(start.has_value()) << initialiser.Why();
    const StartError error = Compare(*start, config.motion);
    EXPECT_LT(error.position, 2e-4);
    EXPECT_LT(error.tilt, 1e-4);
    EXPECT_LT(error.speed, 5e-4);
    EXPECT_NEAR(start->scale, 1.0, 1e-4);
    EXPECT_LT((start->bias.gyro - config.bias.gyro).norm(), 6e-4);
    EXPECT_LT(start->bias.accel.norm(), 1e-3);
    EXPECT_NEAR(start->report.gravity_length, kGravity.norm(), 1e-2);
    EXPECT_EQ(start->report.at_rest, kind == MotionKind::kStill);
    EXPECT_EQ(start->frames.front().T_WI.p(), Eigen::Vector3d::Zero());
    EXPECT_NEAR(YawOf(start->frames.front().T_WI.q()), 0.0, 1e-12);
  }
}

// The accelerometer's bias of 0.02 m/s^2 an axis tilts gravity by 0.02 / 9.81 = 0.11 degrees an
// axis: 0.5 are more than 3 sigma. Stereo knows its scale; over a way of 0.1 to 0.4 m, noise of
// 0.5 px at 3 m and 100 points puts the ends off by a millimetre.
TEST(Initialiser, StartsFromRestAndInMotion) {
  for (const MotionKind kind : kKinds) {
    for (std::uint64_t seed = 1; seed <= kStarts; ++seed) {
      const auto config = NoisyDive(kind, seed);
      Initialiser initialiser({}, V3Stereo(), {}, V3Depth());
      const auto start = Initialise(initialiser, MakeSyntheticDive(config));
      ASSERT_TRUE(start.has_value()) << initialiser.Why();
      EXPECT_EQ(initialiser.Status(), InitialiserStatus::kStarted);
      EXPECT_EQ(initialiser.Why(), start->report.Line());
      const StartError error = Compare(*start, config.motion);
      SCOPED_TRACE(initialiser.Why());
      EXPECT_LT(std::abs(error.scale), 0.02);
      EXPECT_LT(error.position, 0.01);
      EXPECT_LT(error.tilt, 0.5 * kDegree);
      EXPECT_LT(error.speed, 0.03);
      EXPECT_LT(error.speed, 4.0 * start->report.speed_sigma);
      EXPECT_LT(error.tilt, 3.0 * start->report.tilt_sigma_rad);
    }
  }
}

TEST(Initialiser, EveryFifthPixelMayBeWrong) {
  for (std::uint64_t seed = 1; seed <= kStarts; ++seed) {
    auto config = NoisyDive(MotionKind::kPitching, seed);
    config.outlier_share = 0.2;
    Initialiser initialiser({}, V3Stereo(), {}, V3Depth());
    const auto start = Initialise(initialiser, MakeSyntheticDive(config));
    ASSERT_TRUE(start.has_value()) << seed << initialiser.Why();
    const StartError error = Compare(*start, config.motion);
    SCOPED_TRACE(initialiser.Why());
    EXPECT_LT(std::abs(error.scale), 0.03);
    EXPECT_LT(error.tilt, 0.5 * kDegree);
    EXPECT_LT(error.speed, 0.05);
  }
}

// A baseline believed 3 % too long makes vision 3 % too large. While the rig dives by decimetres a
// second, two readings of 3 mm against 0.5 m say the scale to 1 %, and it acts.
TEST(Initialiser, DepthCorrectsAWrongBaseline) {
  InitialiserConfig config;
  config.frame_spacing_s = 0.25;
  config.stereo_scale_sigma = 0.03;
  config.wanted_scale_sigma = 0.01;
  double squares = 0.0;
  for (std::uint64_t seed = 1; seed <= kStarts; ++seed) {
    auto dive = NoisyDive(MotionKind::kPitching, seed);
    dive.motion.sway[2] = {};
    dive.motion.speed_W.z() = seed % 2 == 0 ? -0.25 : 0.25;
    Initialiser initialiser(config, testing::WithBaseline(V3Stereo(), 1.03), {}, V3Depth());
    const auto start = Initialise(initialiser, MakeSyntheticDive(dive));
    ASSERT_TRUE(start.has_value()) << initialiser.Why();
    SCOPED_TRACE(initialiser.Why());
    ASSERT_TRUE(start->report.from_depth.has_value());
    const ScaleEstimate& s1 = start->report.depth_scale;
    EXPECT_LT(s1.sigma, 0.02);
    EXPECT_NEAR(s1.value, 1.0 / 1.03, 3.5 * s1.sigma);
    EXPECT_NEAR(start->scale, s1.value * start->report.alignment_scale.value, 1e-12);
    EXPECT_LT(std::abs(Compare(*start, dive.motion).scale), 0.02);
    const double sigmas = (start->scale - 1.0 / 1.03) / start->report.alignment_scale.sigma;
    squares += sigmas * sigmas / kStarts;
  }
  // Honest: neither far too sure, nor far too careful.
  EXPECT_LT(squares, 2.0);
  EXPECT_GT(squares, 0.1);
}

TEST(Initialiser, WithoutDepthTheScaleIsTheRigs) {
  const auto dive = NoisyDive(MotionKind::kPitching, 1);
  Initialiser initialiser({}, V3Stereo(), {}, DepthSheet{});
  const auto start = Initialise(initialiser, MakeSyntheticDive(dive));
  ASSERT_TRUE(start.has_value()) << initialiser.Why();
  EXPECT_FALSE(start->report.from_depth.has_value());
  EXPECT_EQ(start->report.depth_scale.value, 1.0);
  EXPECT_NEAR(start->scale, 1.0, 0.01);
}

// What Initialise() would return at any time of a minute.
int StartsIn(Initialiser& initialiser, const SyntheticDive& dive) {
  int starts = 0;
  for (const auto& input : dive.inputs) {
    starts += initialiser.Add(input.frame, input.imu, input.depth).has_value() ? 1 : 0;
  }
  return starts;
}

TEST(Initialiser, BlueWaterAndBlackNeverStart) {
  auto config = NoisyDive(MotionKind::kMoving, 1);
  config.length_s = 20.0;
  for (const int points : {0, 14}) {
    config.max_points = points;
    Initialiser initialiser({}, V3Stereo(), {}, V3Depth());
    EXPECT_EQ(StartsIn(initialiser, MakeSyntheticDive(config)), 0);
    EXPECT_EQ(initialiser.Status(), InitialiserStatus::kTooFewLandmarks);
  }
}

TEST(Initialiser, OneEyeNeverStarts) {
  SyntheticDive dive = MakeSyntheticDive(NoisyDive(MotionKind::kMoving, 1));
  for (auto& input : dive.inputs) {
    for (TrackedPoint& point : input.frame.points) point.right.reset();
  }
  Initialiser initialiser({}, V3Stereo(), {}, V3Depth());
  EXPECT_EQ(StartsIn(initialiser, dive), 0);
  EXPECT_EQ(initialiser.Status(), InitialiserStatus::kTooFewLandmarks);
}

// A tracker that follows noise: points anywhere, or with a disparity that a landmark might have.
TEST(Initialiser, NoiseNeverStarts) {
  for (const bool with_disparity : {false, true}) {
    for (std::uint64_t seed = 1; seed <= kStarts; ++seed) {
      SyntheticDive dive = MakeSyntheticDive(NoisyDive(MotionKind::kStill, seed));
      RandomStream random(seed, "noise");
      for (auto& input : dive.inputs) {
        for (TrackedPoint& point : input.frame.points) {
          point.left = {random.Uniform(100.0, 700.0), random.Uniform(100.0, 500.0)};
          point.right = {random.Uniform(100.0, 700.0), random.Uniform(100.0, 500.0)};
          const auto right =
              StereoGeometry(V3Stereo()).Transfer(point.left, random.Uniform(0.2, 1.0));
          if (with_disparity) point.right = *right;
        }
      }
      Initialiser initialiser({}, V3Stereo(), {}, V3Depth());
      EXPECT_EQ(StartsIn(initialiser, dive), 0) << initialiser.Why();
    }
  }
}

// Dirt on the glass, or a swarm that goes along: vision at rest on a body that is not.
TEST(Initialiser, APictureThatStaysWhileTheBodyMovesNeverStarts) {
  for (std::uint64_t seed = 1; seed <= kStarts; ++seed) {
    SyntheticDive dive = MakeSyntheticDive(NoisyDive(MotionKind::kPitching, seed));
    const TrackedFrame first = dive.inputs.front().frame;
    for (auto& input : dive.inputs) input.frame.points = first.points;
    Initialiser initialiser({}, V3Stereo(), {}, V3Depth());
    EXPECT_EQ(StartsIn(initialiser, dive), 0) << initialiser.Why();
  }
}

TEST(Initialiser, BeginsAnewAfterAGapAndThenStarts) {
  const auto config = NoisyDive(MotionKind::kMoving, 4);
  SyntheticDive dive = MakeSyntheticDive(config);
  // Frames stop for 0.8 s before there are enough.
  dive.inputs.erase(dive.inputs.begin() + 10, dive.inputs.begin() + 22);
  Initialiser initialiser({}, V3Stereo(), {}, V3Depth());
  std::vector<InitialiserStatus> said;
  std::optional<InitialisedStart> start;
  for (const auto& input : dive.inputs) {
    start = initialiser.Add(input.frame, input.imu, input.depth);
    if (said.empty() || said.back() != initialiser.Status()) said.push_back(initialiser.Status());
    if (start.has_value()) break;
  }
  ASSERT_TRUE(start.has_value());
  EXPECT_GE(start->frames.front().tracked.t, dive.inputs[10].frame.t);
  EXPECT_EQ(said, (std::vector{InitialiserStatus::kWaiting, InitialiserStatus::kCollecting,
                               InitialiserStatus::kNoImu, InitialiserStatus::kCollecting,
                               InitialiserStatus::kStarted}));
}

TEST(Initialiser, WithoutImuItNeverStarts) {
  SyntheticDive dive = MakeSyntheticDive(NoisyDive(MotionKind::kMoving, 4));
  for (auto& input : dive.inputs) input.imu.clear();
  Initialiser initialiser({}, V3Stereo(), {}, V3Depth());
  EXPECT_EQ(StartsIn(initialiser, dive), 0);
  EXPECT_EQ(initialiser.Status(), InitialiserStatus::kNoImu);
}

TEST(Initialiser, IsDeterministicAndAsNewAfterAStart) {
  auto config = NoisyDive(MotionKind::kPitching, 6);
  config.outlier_share = 0.1;
  const SyntheticDive dive = MakeSyntheticDive(config);
  Initialiser initialiser({}, V3Stereo(), {}, V3Depth());
  const auto first = Initialise(initialiser, dive);
  const auto second = Initialise(initialiser, dive);
  ASSERT_TRUE(first.has_value() && second.has_value());
  ASSERT_EQ(first->frames.size(), second->frames.size());
  EXPECT_EQ(first->frames.back().T_WI.p(), second->frames.back().T_WI.p());
  EXPECT_EQ(first->frames.back().v_W, second->frames.back().v_W);
  EXPECT_EQ(first->scale, second->scale);
  EXPECT_EQ(first->report.Line(), second->report.Line());
}

TEST(InitialiserConfig, IsReadStrictly) {
  const auto read = [](const char* text) {
    return ReadYaml(ParseYaml(text, "test.yaml"), ReadInitialiserConfig);
  };
  EXPECT_EQ(read("min_landmarks: 20").vision.min_landmarks, 20);
  EXPECT_EQ(read("max_speed_sigma_m_s: 0.2").max_speed_sigma, 0.2);
  EXPECT_EQ(read("{}").min_landmarks, 15);
  EXPECT_THROW(read("min_landmark: 20"), InputError);
  EXPECT_THROW(read("min_landmarks: 5"), InputError);
  EXPECT_THROW(read("{min_frames: 10, max_frames: 9}"), InputError);
  EXPECT_THROW(read("frame_spacing_s: 0.6"), InputError);
  EXPECT_THROW(read("stereo_scale_sigma: 0"), InputError);
}

}  // namespace
}  // namespace drydock::svin2
