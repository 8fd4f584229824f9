#include "estimator/svin2/factors/depth_factor.h"

#include <array>
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "estimator/svin2/factors/speed_bias.h"
#include "sensors_models/models/pressure_model.h"
#include "tests/estimator/svin2/factors/factor_check.h"
#include "tests/estimator/svin2/synthetic_motion.h"

namespace drydock::svin2 {
namespace {

using Eigen::Vector3d;
using testing::Block;
using testing::Blocks;

const Vector3d kPort(-0.282, -0.019, 0.032);

DepthObservation Observation(double depth, Duration since_frame) {
  DepthObservation observation;
  observation.depth = depth;
  observation.p_ID = kPort;
  observation.since_frame = since_frame;
  observation.sigma = 0.02;
  return observation;
}

Blocks States(const NavState& state, double surface) {
  return {Block(ToParameters(state.T_WI)), Block(ToParameters(SpeedBias{state.v_W, {}})),
          Block(std::array{surface})};
}

TEST(DepthFactor, ValueAndDerivativesByHand) {
  // Level, 1 m up, rising at 0.5 m/s: 20 ms before the frame the port was at 1.032 - 0.01 m. It
  // read 11 m below a surface at 12 m, so it was at 1 m: the estimate is 0.022 m too high.
  NavState state;
  state.T_WI = Pose(Eigen::Quaterniond::Identity(), {3, 4, 1});
  state.v_W = {0.1, 0.2, 0.5};
  const DepthFactor factor(Observation(11.0, {-20'000'000}));
  EXPECT_NEAR(testing::Residuals(factor, States(state, 12.0))[0], 0.022 / 0.02, 1e-12);
  const auto jacobians = testing::TangentJacobians(factor, States(state, 12.0));
  Eigen::Matrix<double, 1, 6> by_pose;
  // Rolling (about x) lifts the port by its y, pitching (nose down) lifts it by -x.
  by_pose << 0, 0, 1, -0.019, 0.282, 0;
  EXPECT_LT((jacobians[0] - by_pose / 0.02).norm(), 1e-12);
  Eigen::Matrix<double, 1, 9> by_speed = Eigen::Matrix<double, 1, 9>::Zero();
  by_speed[2] = -0.02 / 0.02;
  EXPECT_LT((jacobians[1] - by_speed).norm(), 1e-12);
  EXPECT_NEAR(jacobians[2](0, 0), -1.0 / 0.02, 1e-12);
}

TEST(DepthFactor, IsSigned) {
  NavState state;
  const Blocks states = States(state, 5.0 + kPort.z());
  EXPECT_GT(testing::Residuals(DepthFactor(Observation(5.1, {})), states)[0], 0);
  EXPECT_LT(testing::Residuals(DepthFactor(Observation(4.9, {})), states)[0], 0);
}

TEST(DepthFactor, VanishesAtTruth) {
  // The surface is 7 m above W's origin.
  const NavState now = testing::MotionAt({2'000'000'000});
  const DepthFactor factor(Observation(DepthBelowSurface(now.T_WI, kPort, 7.0), {}));
  EXPECT_LT(std::abs(testing::Residuals(factor, States(now, 7.0))[0]), 1e-9);
}

TEST(DepthFactor, CarriesHeightOverToTheReading) {
  const NavState frame = testing::MotionAt({2'000'000'000});
  const NavState later = testing::MotionAt({2'033'000'000});
  const double depth = DepthBelowSurface(later.T_WI, kPort, 7.0);
  const auto error = [&](Duration since_frame) {
    return 0.02 * std::abs(testing::Residuals(DepthFactor(Observation(depth, since_frame)),
                                              States(frame, 7.0))[0]);
  };
  EXPECT_LT(error({33'000'000}), 3e-3);
  EXPECT_GT(error({0}), 5e-3);
}

TEST(DepthFactor, JacobiansMatchDifferences) {
  const NavState state = testing::MotionAt({2'000'000'000});
  EXPECT_LT(
      testing::WorstJacobianError(DepthFactor(Observation(3.0, {15'000'000})), States(state, 3.0)),
      1e-6);
}

TEST(DepthFactor, RefusesAReadingWithoutUncertainty) {
  DepthObservation observation = Observation(3.0, {});
  observation.sigma = 0.0;
  EXPECT_THROW(DepthFactor{observation}, std::logic_error);
}

}  // namespace
}  // namespace drydock::svin2
