#include "sensors_models/models/pressure_model.h"

#include <numbers>

#include <gtest/gtest.h>

namespace drydock {
namespace {

TEST(PressureModel, DepthIsPositiveDownwardsAndSeesTheLeverArm) {
  const Eigen::Vector3d p_ID(-0.3, 0.0, 0.1);
  EXPECT_NEAR(DepthBelowSurface(Pose(Eigen::Quaterniond::Identity(), {1, 2, -4}), p_ID, 6.0), 9.9,
              1e-12);
  // Nose down by 90 degrees: the port, behind the origin, comes to lie above it.
  const Pose nose_down(FromYawPitchRoll(0.0, std::numbers::pi / 2.0, 0.0), {0, 0, 0});
  EXPECT_NEAR(DepthBelowSurface(nose_down, p_ID, 0.0), -0.3, 1e-12);
}

}  // namespace
}  // namespace drydock
