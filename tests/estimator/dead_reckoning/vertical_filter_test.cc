#include "estimator/dead_reckoning/vertical_filter.h"

#include <cmath>

#include <gtest/gtest.h>

namespace drydock {
namespace {

// An inertial height whose acceleration is wrong by a constant: the filter finds it from depth
// alone.
TEST(VerticalFilter, FindsAConstantAccelerationError) {
  VerticalFilter filter({});
  double height = 0.0, speed = 0.0, learned = 0.0;  // The truth stands still at zero.
  constexpr double kError = 0.03;
  for (int second = 0; second < 120; ++second) {
    for (int step = 0; step < 100; ++step) {
      const double acceleration = kError + learned;
      height += speed * 0.01 + 0.5 * acceleration * 1e-4;
      speed += acceleration * 0.01;
      filter.Predict(0.01);
    }
    const Eigen::Vector3d correction = filter.Update(-height);
    height += correction[0];
    speed += correction[1];
    learned += correction[2];
  }
  EXPECT_NEAR(learned, -kError, 0.003);
  EXPECT_LT(std::abs(height), 0.01);
}

TEST(VerticalFilter, TrustsDepthMoreTheLongerItWaits) {
  VerticalFilter soon({}), late({});
  soon.Predict(0.1);
  for (int i = 0; i < 100; ++i) late.Predict(0.1);
  EXPECT_LT(soon.Update(1.0)[0], late.Update(1.0)[0]);
  EXPECT_LT(late.Update(1.0)[0], 1.0);
}

}  // namespace
}  // namespace drydock
