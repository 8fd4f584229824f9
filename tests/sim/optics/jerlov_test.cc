#include "sim/optics/jerlov.h"

#include <cmath>

#include <gtest/gtest.h>

#include "sim/optics/water_config.h"

namespace drydock::sim {
namespace {

TEST(Jerlov, TypesAreFoundByName) {
  ASSERT_NE(FindJerlovType("III"), nullptr);
  EXPECT_EQ(FindJerlovType("IV"), nullptr);
  EXPECT_EQ(JerlovTypeNames().size(), 6U);
}

// Measured Kd of type III is .42, .11, .14; of 5C .54, .30, .56 (at 650, 550 and 450 nm). Kirk's
// formula is an approximation, and the wavelengths differ by 10 nm: within 45 %.
TEST(Jerlov, DiffuseAttenuationIsNearTheMeasured) {
  const Eigen::Array3d three(.42, .11, .14), coastal(.54, .30, .56);
  EXPECT_LT(((FindJerlovType("III")->DiffuseAttenuation() - three) / three).abs().maxCoeff(), 0.45);
  EXPECT_LT(((FindJerlovType("5C")->DiffuseAttenuation() - coastal) / coastal).abs().maxCoeff(),
            0.45);
}

TEST(WaterConfig, VisibilityIsWhereTwoPercentOfTheContrastAreLeft) {
  WaterConfig water;
  for (const double visibility : {3.0, 6.0, 12.0}) {
    water.visibility_m = visibility;
    EXPECT_NEAR(std::exp(-BeamAttenuation(water)[1] * visibility), 0.02, 1e-4);
  }
}

TEST(WaterConfig, ChannelsKeepTheRatiosOfTheType) {
  WaterConfig water;
  water.jerlov_type = "3C";
  const Eigen::Array3d c = BeamAttenuation(water);
  EXPECT_NEAR(c[0] / c[1], (.375 + .652) / (.118 + .675), 1e-12);
  EXPECT_NEAR(c[2] / c[1], (.231 + .636) / (.118 + .675), 1e-12);
}

}  // namespace
}  // namespace drydock::sim
