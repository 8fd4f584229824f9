#include "sensors_models/models/sonar_model.h"

#include <numbers>

#include <gtest/gtest.h>

namespace drydock {
namespace {

TEST(SonarModel, TheHeadTurnsByStepsAndWraps) {
  SonarSheet sheet;
  sheet.step_rad = std::numbers::pi / 200.0;  // 0.9 degrees
  EXPECT_EQ(SonarHeadAngle(sheet, 0), 0.0);
  EXPECT_NEAR(SonarHeadAngle(sheet, 100), std::numbers::pi / 2.0, 1e-12);
  EXPECT_NEAR(SonarHeadAngle(sheet, 401), std::numbers::pi / 200.0, 1e-9);
}

TEST(SonarModel, PointsLieInTheScanPlane) {
  EXPECT_LT((SonarPoint(0.0, 2.0) - Eigen::Vector3d(2, 0, 0)).norm(), 1e-12);
  EXPECT_LT((SonarPoint(std::numbers::pi / 2.0, 3.0) - Eigen::Vector3d(0, 3, 0)).norm(), 1e-12);
}

TEST(SonarModel, BinsLieEndToEnd) {
  SonarSheet sheet;
  sheet.max_range_m = 6.0;
  sheet.bins = 250;
  sheet.range_noise_m = 0.01;
  EXPECT_DOUBLE_EQ(SonarBinLength(sheet), 0.024);
  EXPECT_DOUBLE_EQ(SonarBinCentre(sheet, 0), 0.012);
  EXPECT_DOUBLE_EQ(SonarBinCentre(sheet, 249), 5.988);
  EXPECT_NEAR(SonarRangeSigma(sheet), 0.01217, 1e-5);  // sqrt(0.01^2 + 0.024^2 / 12)
  sheet.bins = 0;
  EXPECT_DOUBLE_EQ(SonarRangeSigma(sheet), 0.01);
}

// The SVIn2 rig scans across the travel: S's plane is the body's y-z plane.
TEST(SonarModel, TheRigScansAcrossTheTravel) {
  const Rig rig = LoadRig(FindRig("svin2_v3"));
  for (const double angle : {0.0, 0.7, 2.0, 4.5}) {
    EXPECT_NEAR((rig.sonar.T_IS.q() * SonarBeam(angle)).x(), 0.0, 1e-12);
  }
  EXPECT_LT((rig.sonar.T_IS.q() * SonarBeam(0.0) - Eigen::Vector3d::UnitY()).norm(), 1e-12);
}

}  // namespace
}  // namespace drydock
