#include "estimator/svin2/factors/level_factor.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/estimator/svin2/factors/factor_check.h"

namespace drydock::svin2 {
namespace {

using testing::Block;
using testing::Blocks;

const Pose kOdometry(FromYawPitchRoll(0.7, -0.2, 0.3), {1, 2, -3});

Blocks State(const Pose& T_WI) { return {Block(ToParameters(T_WI))}; }

TEST(LevelFactor, ValueByHand) {
  // 0.1 m higher, and tipped over by 0.02 rad to the side of W's y: up leans by sin(0.02) along -y.
  Vector6d delta = Vector6d::Zero();
  delta[2] = 0.1;
  delta[3] = 0.02;
  const Eigen::VectorXd e =
      testing::Residuals(LevelFactor(kOdometry, 0.05, 0.01), State(kOdometry.BoxPlus(delta)));
  EXPECT_NEAR(e[0], 2.0, 1e-12);
  EXPECT_NEAR(e[1], 0.0, 1e-12);
  EXPECT_NEAR(e[2], -std::sin(0.02) / 0.01, 1e-12);
}

TEST(LevelFactor, LeavesTheLevelAndYawFree) {
  const LevelFactor factor(kOdometry, 0.05, 0.01);
  for (const double yaw : {0.0, 1.0, 3.1415926, -2.0}) {
    const Pose drift(FromYawPitchRoll(yaw, 0, 0), {50, -20, 0});
    EXPECT_LT(testing::Residuals(factor, State(drift * kOdometry)).norm(), 1e-10) << yaw;
  }
}

TEST(LevelFactor, JacobianMatchesDifferences) {
  Vector6d delta;
  delta << 1, 2, 3, 0.4, -0.3, 2.0;
  for (const double share : {0.0, 1.0})
    EXPECT_LT(testing::WorstJacobianError(LevelFactor(kOdometry, 0.05, 0.01),
                                          State(kOdometry.BoxPlus(share * delta))),
              1e-6);
}

TEST(LevelFactor, RefusesStandardDeviationsOfZero) {
  EXPECT_THROW(LevelFactor(kOdometry, 0.0, 0.01), std::logic_error);
  EXPECT_THROW(LevelFactor(kOdometry, 0.05, 0.0), std::logic_error);
}

}  // namespace
}  // namespace drydock::svin2
