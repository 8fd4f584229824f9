#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "scenes/bus/bus_scene.h"
#include "scenes/bus/bus_shape.h"
#include "scenes/bus/site.h"
#include "scenes/bus/textures.h"
#include "sensors_models/base/files.h"
#include "tests/scenes/every_scene.h"

namespace drydock::scenes::bus {
namespace {
namespace fs = std::filesystem;
using Eigen::Vector3d;

constexpr std::uint64_t kSeed = 1;

TEST(BusScene, SameSeedGivesTheSameBytes) {
  const auto make = [](std::uint64_t seed) {
    return testing::FilesMadeBy([&](const fs::path& folder) { GenerateBus(seed, folder, 0.1); });
  };
  const auto a = make(kSeed);
  const auto b = make(kSeed);
  EXPECT_GT(a.size(), 100U);
  EXPECT_TRUE(a.contains("scene.xml"));
  ASSERT_EQ(a.size(), b.size());
  for (const auto& [name, bytes] : a) EXPECT_TRUE(bytes == b.at(name)) << name << " differs";
}

TEST(BusScene, FilesAreReferredToRelatively) {
  const fs::path folder = fs::path(::testing::TempDir()) / "drydock_bus_mjcf_test";
  fs::remove_all(folder);
  GenerateBus(kSeed, folder, 0.05);
  const std::string xml = ReadFile(folder / "scene.xml");
  EXPECT_EQ(xml.find(folder.string()), std::string::npos);
  EXPECT_THAT(xml, ::testing::HasSubstr("meshdir=\"meshes\""));
  EXPECT_THAT(xml, ::testing::HasSubstr("<body name=\"bus_side_left\">"));
  fs::remove_all(folder);
}

TEST(BusScene, EveryMaterialIsPaintedAndEveryPictureUsed) {
  testing::ExpectEveryMaterialPainted(BuildBusModel(kSeed), TextureTasks());
}

TEST(BusScene, MeshesAreSoundAndNotTooMany) {
  const SceneModel model = BuildBusModel(kSeed);
  testing::ExpectSoundMeshes(model);
  EXPECT_LT(model.CountTriangles(), 90000U);
}

TEST(BusScene, ShellHasNoGaps) {
  // Outside and inside of a side wall together are closed but for the cuts' counterparts.
  const SceneModel model = BuildBusModel(kSeed);
  for (const std::string& side : std::vector<std::string>{"left", "right"}) {
    Mesh wall;
    for (const Part& part : model.parts()) {
      if (part.body == "bus_side_" + side || part.body == "bus_wall_" + side)
        wall.Append(part.mesh);
    }
    EXPECT_EQ(CountOpenEdges(wall), 0U) << side;
    EXPECT_GT(EnclosedVolume(wall), 0.2) << side;
  }
}

/// The nearest a mesh's vertices, edge middles and triangle middles come to a point [m].
double Clearance(const SceneModel& model, const Vector3d& p) {
  double nearest = 1e9;
  for (const Part& part : model.parts()) {
    for (const auto& t : part.mesh.triangles) {
      const Vector3d& a = part.mesh.positions[t[0]];
      const Vector3d& b = part.mesh.positions[t[1]];
      const Vector3d& c = part.mesh.positions[t[2]];
      const std::array<Vector3d, 7> probes = {
          a, b, c, (a + b) / 2, (b + c) / 2, (c + a) / 2, (a + b + c) / 3};
      for (const Vector3d& q : probes) {
        nearest = std::min(nearest, (q - p).squaredNorm());
      }
    }
  }
  return std::sqrt(nearest);
}

TEST(BusScene, WayIsFree) {
  // A coarse look (the exact one is made with rays): no corner near the way.
  const SceneModel model = BuildBusModel(kSeed);
  const std::vector<Vector3d> around = {{0, 0, 0},        {4, 0, 0},         {8, 0, 0},
                                        {12, 0.2, 0.1},   {14.2, -3.2, 0.3}, {12, -6.6, 0.2},
                                        {6.5, -6.6, 0.1}, {1, -6.5, 0},      {-1.2, -3.2, 0.1}};
  for (const Vector3d& p : around) {
    EXPECT_GT(Clearance(model, p), 0.6) << p.transpose();
  }
  const std::vector<Vector3d> through = {{1.5, kBusY, 0.3}, {4, kBusY, 0.3},     {7, kBusY, 0.3},
                                         {9.6, kBusY, 0.5}, {10.45, kBusY, 0.7}, {12, kBusY, 2.0}};
  for (const Vector3d& p : through) {
    EXPECT_GT(Clearance(model, p), 0.38) << p.transpose();
  }
}

TEST(LakeBed, TilesMeetWithoutGaps) {
  SceneModel model;
  AddLakeBed(model, LakeBed(kSeed), kSeed);
  Mesh bed;
  for (const Part& part : model.parts()) bed.Append(part.mesh);
  EXPECT_EQ(model.parts().size(), static_cast<std::size_t>(kTiles * kTiles));
  // The coarser neighbour's edge has fewer corners, on the same line: no gap, though not edge to
  // edge.
  EXPECT_NEAR(SurfaceArea(bed), std::pow(kTiles * kTile, 2), 0.08 * std::pow(kTiles * kTile, 2));
  for (const Vector3d& n : bed.normals) EXPECT_GT(n.z(), 0.2);
}

TEST(LakeBed, PicturesShareTheirRims) {
  std::vector<cv::Mat3b> pictures;
  for (const TextureTask& task : BedTextures()) pictures.push_back(task.paint(kSeed, 0.2));
  ASSERT_EQ(pictures.size(), static_cast<std::size_t>(kBedVariants));
  for (std::size_t i = 1; i < pictures.size(); ++i) {
    const cv::Mat difference = cv::abs(cv::Mat(pictures[0]) - cv::Mat(pictures[i]));
    EXPECT_EQ(cv::norm(difference.row(0), cv::NORM_INF), 0.0);
    EXPECT_EQ(cv::norm(difference.col(0), cv::NORM_INF), 0.0);
    EXPECT_GT(cv::mean(difference.rowRange(150, 200))[0], 5.0);
  }
}

TEST(BusTextures, HaveContrastFromMillimetresToDecimetres) {
  for (const TextureTask& task : TextureTasks())
    testing::ExpectContrastAtEveryScale(task.paint(kSeed, 0.5), task.name);
}

}  // namespace
}  // namespace drydock::scenes::bus
