#include "estimator/svin2/initialisation/visual_inertial_alignment.h"

#include <Eigen/Cholesky>
#include <cmath>

#include <gtest/gtest.h>

#include "estimator/inertial/imu_integration.h"
#include "sensors_models/base/random_stream.h"
#include "tests/estimator/svin2/initialisation/synthetic_dive.h"

namespace drydock::svin2 {
namespace {

using Eigen::Vector3d;
using testing::SyntheticMotion;

const Vector3d kPIC(0.04, 0.084, -0.006);

struct Scene {
  VisualMotion motion;
  std::vector<ImuPreintegration> imu;
};

struct SceneConfig {
  double scale = 1.0;  // What vision must be multiplied by.
  ImuBias bias;
  ImuNoiseModel noise;
  double position_sigma = 1e-5, turn_sigma = 1e-6;  // Of vision, believed.
  bool with_noise = false;                          // As believed, of vision and IMU.
  std::uint64_t seed = 1;
};

// Shaken by 1 to 2 m/s^2: the accelerometer sees the scale.
SyntheticMotion Shaken() {
  SyntheticMotion motion;
  motion.speed_W = {0.2, 0.1, 0.0};
  motion.sway = {{{0.1, 4.0, 0.3}, {0.08, 5.0, 1.0}, {0.1, 3.5, 2.0}}};
  motion.yaw = {0.3, 0.9, 0.2};
  motion.pitch = {0.2, 1.4, 0.7};
  motion.roll = 0.1;
  return motion;
}

Vector3d GaussianVector(RandomStream& random) {
  const double x = random.Gaussian(), y = random.Gaussian(), z = random.Gaussian();
  return {x, y, z};
}

// 11 frames over 2 s, IMU at 1 kHz, W for V but for the camera's scale.
Scene MakeScene(const SyntheticMotion& motion, const SceneConfig& config) {
  RandomStream random(config.seed, "scene");
  std::vector<TimedImuSample> samples;
  const double noise = config.with_noise ? std::sqrt(1000.0) : 0.0;
  for (std::int64_t k = 0; k <= 2000; ++k) {
    ImuSample sample = motion.Imu(0.001 * static_cast<double>(k));
    sample.angular_rate +=
        config.bias.gyro + noise * config.noise.gyro_noise_density * GaussianVector(random);
    sample.specific_force +=
        config.bias.accel + noise * config.noise.accel_noise_density * GaussianVector(random);
    samples.push_back({{k * 1'000'000}, sample});
  }
  Scene scene;
  for (std::int64_t k = 0; k <= 10; ++k) {
    const Time t{k * 200'000'000};
    const Pose T_WI = motion.At(t.Seconds()).T_WI;
    const Vector3d camera = (T_WI * kPIC) / config.scale;
    Pose T_VI(T_WI.q(), camera - T_WI.q() * kPIC);
    if (config.with_noise && k > 0) {
      Vector6d by;
      by << config.position_sigma * GaussianVector(random),
          config.turn_sigma * GaussianVector(random);
      T_VI = T_VI.BoxPlus(by);
    }
    scene.motion.t.push_back(t);
    scene.motion.T_VI.push_back(T_VI);
    if (k == 0) continue;
    const Time last = scene.motion.t[k - 1];
    scene.imu.push_back(*ImuPreintegration::Over(samples, last, t, {}, config.noise));
  }
  Eigen::VectorXd information(60);
  for (int k = 0; k < 10; ++k) {
    information.segment<3>(6 * k).setConstant(std::pow(config.position_sigma, -2));
    information.segment<3>(6 * k + 3).setConstant(std::pow(config.turn_sigma, -2));
  }
  scene.motion.information = information.asDiagonal();
  return scene;
}

TEST(GyroBias, IsWhatTurnsDifferBy) {
  SceneConfig config;
  config.bias.gyro = {0.03, -0.02, 0.05};
  const Scene scene = MakeScene(Shaken(), config);
  // With a loose prior. What is left is of second order: 0.05 rad/s over 0.2 s, squared, is 1e-4
  // rad, seen from axes that turn by 0.3 rad.
  const auto estimate = EstimateGyroBias(scene.motion, scene.imu, 10.0);
  EXPECT_LT((estimate.bias - config.bias.gyro).norm(), 2e-5);
  EXPECT_LT(estimate.chi2, 0.1);
  EXPECT_EQ(estimate.freedom, 30);
  // A prior as tight as the data leaves half. Those: 1.6e-3 rad/s/sqrt(Hz) over 2 s.
  const double sigma = 1.6e-3 / std::sqrt(2.0);
  const auto half = EstimateGyroBias(scene.motion, scene.imu, sigma);
  EXPECT_LT((half.bias - 0.5 * config.bias.gyro).norm(), 1e-3);
}

TEST(GyroBias, NoBiasExplainsAnotherMotion) {
  Scene scene = MakeScene(Shaken(), {});
  for (std::size_t k = 0; k < scene.motion.T_VI.size(); k += 2) {
    Vector6d by = Vector6d::Zero();
    by[4] = 0.01;
    scene.motion.T_VI[k] = scene.motion.T_VI[k].BoxPlus(by);
  }
  // Turns alternate by +-0.01 rad, each known to 1.6e-3 sqrt(0.2) = 7e-4: chi2 of 10 * 14^2.
  const auto estimate = EstimateGyroBias(scene.motion, scene.imu, 0.01);
  EXPECT_NEAR(estimate.chi2, 1950.0, 200.0);
}

// Vision is 10 % too small and hardly anything is believed of it beforehand.
TEST(Align, FindsScaleGravityAndSpeedsWhereTheAccelerometerSeesThem) {
  SceneConfig config;
  config.scale = 1.1;
  const SyntheticMotion motion = Shaken();
  const Scene scene = MakeScene(motion, config);
  const auto found = Align(scene.motion, scene.imu, kPIC, {{1.0, 1.0}, 0.01, 0.05});
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->scale.value, 1.1, 1e-3);
  EXPECT_LT((found->gravity_V - kGravity).norm(), 0.01);
  EXPECT_NEAR(found->free_gravity, 9.81, 0.01);
  const Vector3d first = motion.At(0.0).T_WI.p();
  for (int k = 0; k <= 10; ++k) {
    const NavState truth = motion.At(0.2 * k);
    EXPECT_LT((found->v_V[k] - truth.v_W).norm(), 1e-3) << k;
    EXPECT_LT((found->T_VI[k].p() - found->T_VI[0].p() - (truth.T_WI.p() - first)).norm(), 1e-3);
  }
  EXPECT_LT(found->bias.accel.norm(), 5e-3);
  EXPECT_LT(found->chi2, 1.0);
}

// At a constant velocity scale has no acceleration to show itself by: the prior stays as it is.
TEST(Align, LeavesTheScaleWhereNothingIsFelt) {
  SyntheticMotion motion;
  motion.speed_W = {0.3, 0.0, -0.1};
  SceneConfig config;
  config.scale = 1.1;
  const Scene scene = MakeScene(motion, config);
  const auto found = Align(scene.motion, scene.imu, kPIC, {{1.05, 0.03}, 0.01, 0.05});
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->scale.value, 1.05, 1e-6);
  EXPECT_NEAR(found->scale.sigma, 0.03, 1e-4);
  // Level: tilt and bias are one, 0.05 / 9.81.
  EXPECT_NEAR(found->tilt_sigma_rad, 0.05 / 9.81, 5e-4);
}

// Squared errors over 100 runs, each by its sigma: 1, with a standard deviation of sqrt(2 / 100).
TEST(Align, KnowsHowWellItKnows) {
  double scale = 0.0, speed = 0.0, chi2 = 0.0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SceneConfig config;
    config.scale = 1.02;
    config.position_sigma = 0.003;
    config.turn_sigma = 0.001;
    config.with_noise = true;
    config.seed = seed;
    const SyntheticMotion motion = Shaken();
    const Scene scene = MakeScene(motion, config);
    const auto found = Align(scene.motion, scene.imu, kPIC, {{1.02, 1.0}, 0.01, 0.05});
    ASSERT_TRUE(found.has_value());
    scale += std::pow((found->scale.value - 1.02) / found->scale.sigma, 2) / 100.0;
    const Vector3d error = found->v_V[10] - motion.At(2.0).v_W;
    speed += error.squaredNorm() / 3.0 / std::pow(found->speed_sigma, 2) / 100.0;
    chi2 += found->chi2 / found->freedom / 100.0;
  }
  EXPECT_NEAR(scale, 1.0, 0.45);
  // The sigma is that of the worst axis.
  EXPECT_LT(speed, 1.2);
  EXPECT_GT(speed, 0.3);
  // The biases are as expected of none, 6 of some 120: a little low.
  EXPECT_NEAR(chi2, 1.0, 0.1);
}

TEST(Align, SaysNothingWithoutIntervals) {
  const Scene scene = MakeScene(Shaken(), {});
  EXPECT_FALSE(Align(scene.motion, {}, kPIC, {}).has_value());
  EXPECT_FALSE(Align(scene.motion, std::span(scene.imu).first(9), kPIC, {{1.0, 0.02}}).has_value());
}

}  // namespace
}  // namespace drydock::svin2
