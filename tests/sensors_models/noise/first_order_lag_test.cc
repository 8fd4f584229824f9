#include "sensors_models/noise/first_order_lag.h"

#include <cmath>

#include <gtest/gtest.h>

namespace drydock {
namespace {

constexpr double kTau = 0.4;  // [s]

TEST(FirstOrderLag, StartsInSteadyState) {
  FirstOrderLag lag(kTau, 7.5);
  EXPECT_EQ(lag.output(), 7.5);
  for (int k = 0; k < 100; ++k) EXPECT_DOUBLE_EQ(lag.Advance(7.5, 0.1), 7.5);
}

TEST(FirstOrderLag, AStepIsFollowedExponentiallyWhateverTheRate) {
  for (const double dt : {1e-4, 0.01, 0.3, 2.0}) {
    FirstOrderLag lag(kTau, 1.0);
    EXPECT_EQ(lag.Advance(3.0, 0.0), 1.0);  // A jump has no effect yet.
    for (double t = dt; t < 4.0; t += dt) {
      ASSERT_NEAR(lag.Advance(3.0, dt), 3.0 - 2.0 * std::exp(-t / kTau), 1e-11) << dt << ' ' << t;
    }
  }
}

// x = v t from rest has the solution y = v (t - tau (1 - exp(-t / tau))).
TEST(FirstOrderLag, ARampIsFollowedTauTimesItsSlopeLateWhateverTheRate) {
  constexpr double kSpeed = 0.7;
  for (const double dt : {1e-3, 0.01, 0.3, 2.0}) {
    FirstOrderLag lag(kTau, 0.0);
    double t = 0.0;
    while (t < 12.0) {
      t += dt;
      const double expected = kSpeed * (t - kTau * (1.0 - std::exp(-t / kTau)));
      ASSERT_NEAR(lag.Advance(kSpeed * t, dt), expected, 1e-11) << dt << ' ' << t;
    }
    EXPECT_NEAR(kSpeed * t - lag.output(), kTau * kSpeed, 1e-10);
  }
}

TEST(FirstOrderLag, WithoutTimeConstantItFollowsAtOnce) {
  FirstOrderLag lag(0.0, 1.0);
  EXPECT_EQ(lag.Advance(2.0, 0.0), 2.0);
  EXPECT_EQ(lag.Advance(-3.0, 0.5), -3.0);
}

}  // namespace
}  // namespace drydock
