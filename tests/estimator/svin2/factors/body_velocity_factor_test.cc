#include "estimator/svin2/factors/body_velocity_factor.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "estimator/svin2/factors/speed_bias.h"
#include "tests/estimator/svin2/factors/factor_check.h"

namespace drydock::svin2 {
namespace {

using Eigen::Vector3d;
using testing::Block;
using testing::Blocks;

Blocks States(const Pose& T_WI, const Vector3d& v_W) {
  return {Block(ToParameters(T_WI)), Block(ToParameters(SpeedBias{v_W, {{1, 2, 3}, {4, 5, 6}}}))};
}

TEST(BodyVelocityFactor, ValueByHand) {
  // Turned left by 90 degrees: what goes north in W goes ahead in I.
  const Pose T_WI(FromYawPitchRoll(M_PI / 2, 0.0, 0.0), {7, 8, 9});
  const BodyVelocityFactor factor({0.4, 0.0, 0.1}, 0.5);
  const Eigen::VectorXd e = testing::Residuals(factor, States(T_WI, {0.2, 0.9, 0.0}));
  EXPECT_LT((e - Vector3d(1.0, -0.4, -0.2)).norm(), 1e-12);
}

TEST(BodyVelocityFactor, JacobianMatchesDifferences) {
  const BodyVelocityFactor factor({0.4, 0.1, -0.1}, 0.3);
  for (const Vector3d& v_W : {Vector3d(0, 0, 0), Vector3d(0.3, -0.5, 0.2)}) {
    const Pose T_WI(FromYawPitchRoll(0.7, -0.4, 1.1), {1, 2, 3});
    EXPECT_LT(testing::WorstJacobianError(factor, States(T_WI, v_W)), 1e-7);
  }
}

TEST(BodyVelocityFactor, RefusesAStandardDeviationOfZero) {
  EXPECT_THROW(BodyVelocityFactor(Vector3d::Zero(), 0.0), std::logic_error);
}

}  // namespace
}  // namespace drydock::svin2
