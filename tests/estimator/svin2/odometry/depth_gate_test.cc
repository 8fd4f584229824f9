#include "estimator/svin2/odometry/depth_gate.h"

#include <limits>

#include <gtest/gtest.h>

namespace drydock::svin2 {
namespace {

TEST(DepthGate, RefusesASpikeAndBelievesWhatFollows) {
  DepthGate gate({0.3, 0.1});
  EXPECT_TRUE(gate.Believes(Time::FromSeconds(1), 0.01));
  EXPECT_FALSE(gate.Believes(Time::FromSeconds(2), 5.0));
  EXPECT_FALSE(gate.Believes(Time::FromSeconds(2.5), -5.0));
  EXPECT_TRUE(gate.Believes(Time::FromSeconds(3), -0.02));
}

TEST(DepthGate, AllowsMoreTheLongerNothingWasBelieved) {
  // 0.3 m + 0.1 m/s * 4 s.
  DepthGate gate({0.3, 0.1});
  EXPECT_TRUE(gate.Believes(Time::FromSeconds(0), 0.0));
  EXPECT_FALSE(gate.Believes(Time::FromSeconds(4), 0.71));
  EXPECT_TRUE(gate.Believes(Time::FromSeconds(4), 0.69));
}

TEST(DepthGate, RefusesWhatIsNoNumber) {
  DepthGate gate({});
  EXPECT_FALSE(gate.Believes(Time{}, std::numeric_limits<double>::quiet_NaN()));
}

}  // namespace
}  // namespace drydock::svin2
