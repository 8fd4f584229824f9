#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "scenes/columns/columns_scene.h"
#include "scenes/columns/sand.h"
#include "scenes/columns/stones.h"
#include "scenes/columns/textures.h"
#include "tests/scenes/every_scene.h"

namespace drydock::scenes::columns {
namespace {
namespace fs = std::filesystem;
using Eigen::Vector3d;

constexpr std::uint64_t kSeed = 1;

/// The parts of the standing stones by their bodies.
std::map<std::string, Mesh> StonesOf(const SceneModel& model) {
  std::map<std::string, Mesh> stones;
  for (const Part& part : model.parts()) {
    if (part.body != "sand" && !part.body.starts_with("rubble"))
      stones[part.body].Append(part.mesh);
  }
  return stones;
}

TEST(ColumnsScene, SameSeedGivesTheSameBytes) {
  const auto make = [](std::uint64_t seed) {
    return testing::FilesMadeBy(
        [&](const fs::path& folder) { GenerateColumns(seed, folder, 0.1); });
  };
  const auto a = make(kSeed);
  const auto b = make(kSeed);
  const auto c = make(kSeed + 1);
  EXPECT_TRUE(a.contains("scene.xml"));
  EXPECT_TRUE(a == b);
  EXPECT_FALSE(a.at("textures/stone.png") == c.at("textures/stone.png"));
}

TEST(ColumnsScene, EveryMaterialIsPaintedAndEveryPictureUsed) {
  testing::ExpectEveryMaterialPainted(BuildColumnsModel(kSeed), TextureTasks());
}

TEST(ColumnsScene, MeshesAreSoundAndNotTooMany) {
  const SceneModel model = BuildColumnsModel(kSeed);
  testing::ExpectSoundMeshes(model);
  EXPECT_LT(model.CountTriangles(), 60000U);
}

TEST(ColumnsScene, ShapesAreClosed) {
  for (const auto& make : {MakeColumn, MakePillar, MakeStele}) {
    Mesh all;
    for (const auto& [material, mesh] : make()) all.Append(mesh);
    EXPECT_EQ(CountOpenEdges(all), 0U);
    EXPECT_GT(EnclosedVolume(all), 0.2);
    double top = 0.0;
    for (const Vector3d& p : all.positions) top = std::max(top, p.z());
    EXPECT_GT(top, 1.4);
    EXPECT_LT(top, 1.8);
  }
}

// Look-alikes: within a shape all copies have the same picture on the same corners and the same
// size within a few percent, but no two are the same.
TEST(ColumnsScene, StonesOfAShapeDifferLittle) {
  const auto stones = StonesOf(BuildColumnsModel(kSeed));
  EXPECT_EQ(stones.size(), static_cast<std::size_t>(kRows * kStonesARow));
  std::map<std::string, std::vector<const Mesh*>> shapes;
  for (const auto& [name, mesh] : stones) shapes[name.substr(0, name.find('_'))].push_back(&mesh);
  ASSERT_EQ(shapes.size(), 3U);
  for (const auto& [shape, copies] : shapes) {
    ASSERT_GE(copies.size(), 8U) << shape;
    std::set<double> volumes;
    for (const Mesh* copy : copies) {
      EXPECT_EQ(copy->uvs, copies.front()->uvs) << shape;
      const double scale = std::cbrt(EnclosedVolume(*copy) / EnclosedVolume(*copies.front()));
      EXPECT_NEAR(scale, 1.0, 0.12) << shape;
      EXPECT_TRUE(volumes.insert(EnclosedVolume(*copy)).second) << shape;
    }
  }
}

TEST(ColumnsScene, StonesStandInTheSandAndLeaveTheLanesFree) {
  const Sand sand(kSeed);
  for (const auto& [name, mesh] : StonesOf(BuildColumnsModel(kSeed))) {
    double lowest = 1e9;
    double highest = -1e9;
    for (const Vector3d& p : mesh.positions) {
      lowest = std::min(lowest, p.z() - sand.Height(p.x(), p.y()));
      highest = std::max(highest, p.z() - sand.Height(p.x(), p.y()));
      const double from_lane = std::abs(std::remainder(p.y(), kRowSpacing));
      EXPECT_GT(from_lane, 0.9) << name;
    }
    EXPECT_LT(lowest, 0.0) << name;
    EXPECT_GT(highest, 1.2) << name;
  }
}

TEST(ColumnsTextures, SandAndStoneMeetThemselves) {
  for (const TextureTask& task : TextureTasks()) {
    if (task.name == "inscription") continue;
    testing::ExpectMeetsItself(task.paint(kSeed, 0.5), 99, task.name);
  }
}

TEST(ColumnsTextures, HaveContrastFromMillimetresToDecimetres) {
  for (const TextureTask& task : TextureTasks())
    testing::ExpectContrastAtEveryScale(task.paint(kSeed, 0.5), task.name);
}

}  // namespace
}  // namespace drydock::scenes::columns
