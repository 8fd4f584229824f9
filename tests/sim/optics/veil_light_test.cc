#include "sim/optics/veil_light.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"
#include "tests/support/test_scene.h"

namespace drydock::sim {
namespace {

// From under a roof that is large against the visibility, looking out: near water is dark, and what
// is far is as bright as its lit share of the way.
TEST(VeilLight, IsDarkWhereTheWaterIs) {
  const testing::TemporaryFolder folder;
  const World world(testing::WriteScene(
      folder.path(), testing::BoxElement("roof", {0, 0, 2.05}, {3, 3, 0.05}) +
                         testing::BoxElement("stone", {0, -20, 0.1}, {0.1, 0.1, 0.1})));
  const RayScene rays(world);
  DaylightGrid grid(rays, {0, 0, 1});
  WaterConfig water;
  water.visibility_m = 3.0;
  water.sun_share = 1.0;
  const Pinhole pinhole{64, 48, 60.0, 32.0, 24.0};
  VeilLight veil(water, pinhole);
  // 1 m from the roof's edge, looking along -y, level.
  const Pose T_WC(Eigen::Quaterniond(Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitX())),
                  {0, -2, 1});
  veil.Look(T_WC, grid);
  const auto lit = [&](double range) {
    const std::vector<float> ranges(64, static_cast<float>(range));
    return veil.Row(24, ranges.data())[32];
  };
  EXPECT_NEAR(lit(0.5), 0.0, 0.02);
  const double c = 3.912 / 3.0;
  const double dark = 1.0 - std::exp(-c * 1.0), all = 1.0 - std::exp(-c * 10.0);
  EXPECT_NEAR(lit(10.0), (all - dark) / all, 0.08);
}

}  // namespace
}  // namespace drydock::sim
