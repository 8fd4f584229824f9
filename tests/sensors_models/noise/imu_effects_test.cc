// Each of the IMU's errors by itself and all of them together.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "sensors_models/noise/imu_noise.h"

namespace drydock {
namespace {

constexpr ImuEffects kNone{.white_noise = false,
                           .bias_walk = false,
                           .turn_on_bias = false,
                           .scale_error = false,
                           .misalignment = false,
                           .saturation = false,
                           .quantisation = false};

/// Errors large enough to see, all different.
ImuSheet Sheet() {
  ImuSheet sheet;
  sheet.rate_hz = 100.0;
  sheet.gyro_noise_density = 2e-3;
  sheet.accel_noise_density = 3e-3;
  sheet.gyro_bias_walk = 1e-3;
  sheet.accel_bias_walk = 2e-3;
  sheet.gyro_turn_on_bias = 0.02;
  sheet.accel_turn_on_bias = 0.05;
  sheet.gyro_scale_error = 0.01;
  sheet.accel_scale_error = 0.02;
  sheet.gyro_misalignment = 0.03;
  sheet.accel_misalignment = 0.04;
  sheet.gyro_range = 0.5;
  sheet.accel_range = 10.0;
  sheet.gyro_resolution = 0.015;
  sheet.accel_resolution = 0.02;
  return sheet;
}

/// Swings past the ranges.
ImuSample TruthAt(int k) {
  const double t = 0.01 * k;
  return {{0.8 * std::sin(3.0 * t), 0.1 - 0.3 * t, 0.6 * std::cos(t)},
          {12.0 * std::sin(2.0 * t), 1.0, 9.81}};
}

TEST(ImuEffects, ScaleAndMisalignmentAreAMatrix) {
  ImuSheet sheet;
  sheet.rate_hz = 100.0;
  sheet.gyro_scale_error = 0.01;
  sheet.gyro_misalignment = 0.002;
  sheet.accel_scale_error = 0.02;
  sheet.accel_misalignment = 0.004;
  ImuNoise noise(sheet, 7);
  // By hand from the streams: three numbers of scale, six of misalignment row by row.
  RandomStream s(7, "imu0/gyro/scale_error"), n(7, "imu0/gyro/misalignment");
  const double sx = 1.0 + 0.01 * s.GaussianAt(0);
  const double sy = 1.0 + 0.01 * s.GaussianAt(1);
  const double sz = 1.0 + 0.01 * s.GaussianAt(2);
  const double xy = 0.002 * n.GaussianAt(0), xz = 0.002 * n.GaussianAt(1);
  const double yx = 0.002 * n.GaussianAt(2), yz = 0.002 * n.GaussianAt(3);
  const double zx = 0.002 * n.GaussianAt(4), zy = 0.002 * n.GaussianAt(5);
  const Eigen::Vector3d w(0.3, -0.5, 0.7);
  const Eigen::Vector3d expected(sx * (0.3 + xy * -0.5 + xz * 0.7),
                                 sy * (yx * 0.3 + -0.5 + yz * 0.7),
                                 sz * (zx * 0.3 + zy * -0.5 + 0.7));
  const ImuSample sample = noise.Corrupt({w, {0, 0, 9.81}});
  EXPECT_LT((sample.angular_rate - expected).norm(), 1e-15);
  // The accelerometer's z leans by its own numbers: 9.81 shows on x and y.
  RandomStream sa(7, "imu0/accel/scale_error"), na(7, "imu0/accel/misalignment");
  EXPECT_NEAR(sample.specific_force.x(),
              (1.0 + 0.02 * sa.GaussianAt(0)) * 0.004 * na.GaussianAt(1) * 9.81, 1e-15);
  EXPECT_NEAR(sample.specific_force.y(),
              (1.0 + 0.02 * sa.GaussianAt(1)) * 0.004 * na.GaussianAt(3) * 9.81, 1e-15);
  EXPECT_NEAR(sample.specific_force.z(), (1.0 + 0.02 * sa.GaussianAt(2)) * 9.81, 1e-14);
}

TEST(ImuEffects, SaturationAndQuantisationByHand) {
  ImuSheet sheet;
  sheet.rate_hz = 100.0;
  sheet.gyro_range = 5.0;
  sheet.accel_range = 50.0;
  sheet.gyro_resolution = 0.3;
  sheet.accel_resolution = 0.25;
  ImuNoise noise(sheet, 1);
  const ImuSample sample = noise.Corrupt({{0.46, 7.0, -7.0}, {0.62, 60.0, -49.9}});
  // 0.46 is 1.53 steps. 5 / 0.3 = 16.7: the last step in range is the 16th, 4.8.
  EXPECT_LT((sample.angular_rate - Eigen::Vector3d(0.6, 4.8, -4.8)).norm(), 1e-12);
  EXPECT_LT((sample.specific_force - Eigen::Vector3d(0.5, 50.0, -50.0)).norm(), 1e-12);
}

// The sum of squares over 100 seeds and three axes (six pairs of axes), in standard
// deviations: 99.9 % of chi-square lie within 225 and 387 for 300 degrees of freedom, 492 and 721
// for 600.
TEST(ImuEffects, ScaleAndMisalignmentHaveTheirSpread) {
  double scale = 0.0, misalignment = 0.0;
  ImuSheet only_scale, only_misalignment;
  only_scale.rate_hz = only_misalignment.rate_hz = 100.0;
  only_scale.gyro_scale_error = 5e-4;
  only_misalignment.accel_misalignment = 8.7e-4;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const ImuNoise scaled(only_scale, seed), misaligned(only_misalignment, seed);
    scale += (scaled.gyro_response() - Eigen::Matrix3d::Identity()).squaredNorm();
    misalignment += (misaligned.accel_response() - Eigen::Matrix3d::Identity()).squaredNorm();
    EXPECT_EQ(scaled.accel_response(), Eigen::Matrix3d::Identity());
    EXPECT_EQ(misaligned.accel_response().diagonal(), Eigen::Vector3d::Ones());
  }
  scale /= 5e-4 * 5e-4;
  misalignment /= 8.7e-4 * 8.7e-4;
  EXPECT_GT(scale, 225.0);
  EXPECT_LT(scale, 387.0);
  EXPECT_GT(misalignment, 492.0);
  EXPECT_LT(misalignment, 721.0);
}

TEST(ImuEffects, WithEverythingOffItSaysTheTruth) {
  ImuNoise noise(KeepEffects(Sheet(), kNone), 1);
  for (int k = 0; k < 500; ++k) {
    const ImuSample sample = noise.Corrupt(TruthAt(k));
    EXPECT_EQ(sample.angular_rate, TruthAt(k).angular_rate);
    EXPECT_EQ(sample.specific_force, TruthAt(k).specific_force);
  }
}

TEST(ImuEffects, WithEverythingOnTheSheetIsAsItWas) {
  const ImuSheet kept = KeepEffects(Sheet(), {});
  EXPECT_EQ(kept.rate_hz, 100.0);
  EXPECT_EQ(kept.gyro_noise_density, 2e-3);
  EXPECT_EQ(kept.accel_resolution, 0.02);
}

/// What the gyroscope adds under `effects` where the truth is zero.
class GyroAlone {
 public:
  explicit GyroAlone(const ImuEffects& effects) : noise_(KeepEffects(Sheet(), effects), 3) {}
  Eigen::Vector3d Next() { return noise_.Corrupt({}).angular_rate; }

 private:
  ImuNoise noise_;
};

double ClipByHand(double value) { return std::min(0.5, std::max(-0.5, value)); }

// 33 steps of 0.015 are 0.495, the last within 0.5.
double RoundByHand(double value, bool clipped) {
  const double steps = std::round(value / 0.015);
  return 0.015 * (clipped ? std::min(33.0, std::max(-33.0, steps)) : steps);
}

// All 128 choices of effects: what is on adds what it adds alone, sample by sample, so switching
// one off takes away exactly its own and leaves the random numbers of all others as they were.
TEST(ImuEffects, EachSwitchTakesAwayItsOwnAndNothingElse) {
  for (unsigned choice = 0; choice < 128; ++choice) {
    const auto on = [&](unsigned bit) { return ((choice >> bit) & 1U) != 0; };
    const ImuEffects effects{on(0), on(1), on(2), on(3), on(4), on(5), on(6)};
    ImuNoise noise(KeepEffects(Sheet(), effects), 3);
    GyroAlone white({.white_noise = on(0),
                     .bias_walk = false,
                     .turn_on_bias = false,
                     .saturation = false,
                     .quantisation = false});
    GyroAlone walk({.white_noise = false,
                    .bias_walk = on(1),
                    .turn_on_bias = false,
                    .saturation = false,
                    .quantisation = false});
    GyroAlone turn_on({.white_noise = false,
                       .bias_walk = false,
                       .turn_on_bias = on(2),
                       .saturation = false,
                       .quantisation = false});
    ImuEffects scale_only = kNone, misalignment_only = kNone;
    scale_only.scale_error = on(3);
    misalignment_only.misalignment = on(4);
    const Eigen::Matrix3d response =
        ImuNoise(KeepEffects(Sheet(), scale_only), 3).gyro_response() *
        ImuNoise(KeepEffects(Sheet(), misalignment_only), 3).gyro_response();
    for (int k = 0; k < 300; ++k) {
      Eigen::Vector3d expected = response * TruthAt(k).angular_rate;
      expected += white.Next() + walk.Next() + turn_on.Next();
      if (on(5)) expected = expected.unaryExpr([](double v) { return ClipByHand(v); });
      if (on(6)) expected = expected.unaryExpr([&](double v) { return RoundByHand(v, on(5)); });
      const Eigen::Vector3d measured = noise.Corrupt(TruthAt(k)).angular_rate;
      ASSERT_LT((measured - expected).norm(), 1e-12) << "effects " << choice << ", sample " << k;
    }
  }
}

}  // namespace
}  // namespace drydock
