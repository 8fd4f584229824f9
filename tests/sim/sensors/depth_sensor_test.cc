#include "sim/sensors/depth_sensor.h"

#include <cmath>
#include <functional>
#include <utility>

#include <gtest/gtest.h>

namespace drydock::sim {
namespace {

constexpr double kTau = 0.5;  // [s]

/// Level, at a height that a function of time in seconds gives.
class VerticalMotion final : public Motion {
 public:
  explicit VerticalMotion(std::function<double(double)> height) : height_(std::move(height)) {}

  MotionState At(Time t) const override {
    MotionState state;
    state.T_WI = Pose(Eigen::Quaterniond::Identity(), {0.0, 0.0, height_(t.Seconds())});
    return state;
  }
  Time End() const override { return Time::FromSeconds(100.0); }

 private:
  std::function<double(double)> height_;
};

DepthSheet LagOnly(double rate_hz) {
  DepthSheet sheet;
  sheet.rate_hz = rate_hz;
  sheet.lag_s = kTau;
  return sheet;
}

DepthSheet Everything() {
  DepthSheet sheet = LagOnly(10.0);
  sheet.p_ID = {0.1, 0.2, 0.3};
  sheet.noise_m = 0.004;
  sheet.offset_m = 0.5;
  sheet.resolution_m = 0.01;
  return sheet;
}

std::pair<double, double> TimeAndDepth(DepthSensor& sensor) {
  const Observation observation = sensor.Observe();
  return {observation.measurement.t.Seconds(),
          std::get<DepthSample>(observation.measurement.reading).depth};
}

double Swell(double t) { return -2.0 - 0.5 * std::sin(1.3 * t); }

TEST(DepthSensor, WithoutNoiseItSaysTheTruth) {
  const VerticalMotion motion(Swell);
  const PressureEffects none{
      .white_noise = false, .offset = false, .lag = false, .quantisation = false};
  DepthSensor without_noise(motion, Everything(), 6.0, false, 1);
  DepthSensor without_effects(motion, KeepEffects(Everything(), none), 6.0, true, 1);
  for (int k = 0; k < 100; ++k) {
    const double t = SampleTime(Time{}, k, 10.0).Seconds();
    const double truth = 6.0 - (Swell(t) + 0.3);  // The port is 0.3 m above I.
    EXPECT_DOUBLE_EQ(TimeAndDepth(without_noise).second, truth);
    EXPECT_DOUBLE_EQ(TimeAndDepth(without_effects).second, truth);
  }
}

TEST(DepthSensor, TheLagStartsInSteadyState) {
  const VerticalMotion motion([](double) { return -3.0; });
  DepthSensor sensor(motion, LagOnly(7.0), 6.0, true, 1);
  for (int k = 0; k < 50; ++k) EXPECT_DOUBLE_EQ(TimeAndDepth(sensor).second, 9.0);
}

// A jump by 2 m at 1 s is a ramp from the grid's instant before, 0.99 s. Of the ramp the lag has at
// 1 s left undone (tau / h) (1 - exp(-h / tau)) of the jump; that dies away exponentially.
TEST(DepthSensor, AStepIsFollowedExponentiallyAtEveryRate) {
  const VerticalMotion motion([](double t) { return t < 1.0 ? 0.0 : -2.0; });
  const double left = kTau / 0.01 * (1.0 - std::exp(-0.01 / kTau));
  for (const double rate : {1.0, 7.0, 10.0, 100.0, 333.0}) {
    DepthSensor sensor(motion, LagOnly(rate), 6.0, true, 1);
    for (int k = 0; k < 4 * static_cast<int>(rate); ++k) {
      const auto [t, depth] = TimeAndDepth(sensor);
      const double expected = t < 1.0 ? 6.0 : 8.0 - 2.0 * left * std::exp(-(t - 1.0) / kTau);
      ASSERT_NEAR(depth, expected, 1e-11) << rate << " Hz, " << t << " s";
    }
  }
}

// Sinking at v from rest: behind by v tau (1 - exp(-t / tau)), at last by tau v = 0.15 m.
TEST(DepthSensor, ARampIsFollowedTauTimesItsSpeedLateAtEveryRate) {
  constexpr double kSpeed = 0.3;
  const VerticalMotion motion([](double t) { return -kSpeed * t; });
  for (const double rate : {1.0, 7.0, 15.0, 100.0, 333.0}) {
    DepthSensor sensor(motion, LagOnly(rate), 6.0, true, 1);
    for (int k = 0; k < 20 * static_cast<int>(rate); ++k) {
      const auto [t, depth] = TimeAndDepth(sensor);
      const double behind = kSpeed * kTau * (1.0 - std::exp(-t / kTau));
      ASSERT_NEAR(depth, 6.0 + kSpeed * t - behind, 1e-11) << rate << " Hz, " << t << " s";
      if (t > 15.0) {
        ASSERT_NEAR(6.0 + kSpeed * t - depth, 0.15, 1e-11);
      }
    }
  }
}

// Behind the lag, a sine of w rad/s keeps 1 / sqrt(1 + (w tau)^2) of its size and is atan(w tau)
// late: the grid's straight lines are close enough to the curve.
TEST(DepthSensor, ASwellIsSmoothedAsTheEquationSays) {
  const VerticalMotion motion(Swell);
  DepthSensor sensor(motion, LagOnly(7.0), 6.0, true, 1);
  const double gain = 1.0 / std::sqrt(1.0 + std::pow(1.3 * kTau, 2.0));
  for (int k = 0; k < 200; ++k) {
    const auto [t, depth] = TimeAndDepth(sensor);
    if (t < 12.0) continue;  // What is left of the start is below exp(-24).
    const double expected = 8.0 + 0.5 * gain * std::sin(1.3 * t - std::atan(1.3 * kTau));
    EXPECT_NEAR(depth, expected, 1e-5) << t;
  }
}

TEST(DepthSensor, SensorsOfDifferentRateAgreeToTheLastBit) {
  const VerticalMotion motion(Swell);
  DepthSensor slow(motion, LagOnly(3.0), 6.0, true, 1);
  DepthSensor fast(motion, LagOnly(33.0), 6.0, true, 1);
  for (int k = 0; k < 30; ++k) {
    const auto [t, depth] = TimeAndDepth(slow);
    auto other = TimeAndDepth(fast);
    for (int skip = 0; other.first < t && skip < 33; ++skip) other = TimeAndDepth(fast);
    ASSERT_EQ(other.first, t);
    EXPECT_EQ(other.second, depth);
    for (int rest = 1; rest < 11; ++rest) fast.Observe();
  }
}

// Lag, then offset and white noise, then steps: from the streams by hand, on a depth at rest.
TEST(DepthSensor, EverythingTogetherByHand) {
  const VerticalMotion motion([](double) { return -3.0; });
  DepthSensor sensor(motion, Everything(), 6.0, true, 5);
  const RandomStream white(5, "pressure0/white"), offset(5, "pressure0/offset");
  for (std::uint64_t k = 0; k < 100; ++k) {
    const double analogue = 8.7 + 0.5 * offset.GaussianAt(0) + 0.004 * white.GaussianAt(k);
    EXPECT_NEAR(TimeAndDepth(sensor).second, 0.01 * std::round(analogue / 0.01), 1e-12);
  }
}

}  // namespace
}  // namespace drydock::sim
