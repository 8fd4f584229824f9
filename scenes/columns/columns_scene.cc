#include "scenes/columns/columns_scene.h"

#include <array>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "scenes/columns/sand.h"
#include "scenes/columns/stones.h"
#include "scenes/columns/textures.h"
#include "sensors_models/base/random_stream.h"

namespace drydock::scenes::columns {
namespace {
using Eigen::Vector3d;

constexpr double kDegrees = std::numbers::pi / 180.0;
constexpr double kFirstStone = 1.0;  // [m], along x

/// Sets a copy down, a little larger or smaller, turned, leaning and out of line.
void Put(SceneModel& model, const std::string& name, const Stone& stone, double x, double y,
         const Sand& sand, RandomStream& random) {
  const double scale = 1.0 + 0.02 * random.Gaussian();
  const double yaw = 3.0 * kDegrees * random.Gaussian();
  const double lean_x = 1.5 * kDegrees * random.Gaussian();
  const double lean_y = 1.5 * kDegrees * random.Gaussian();
  x += 0.04 * random.Gaussian();
  y += 0.04 * random.Gaussian();
  const Eigen::Isometry3d pose = Eigen::Translation3d(x, y, sand.Height(x, y) - 0.08) *
                                 Eigen::AngleAxisd(yaw, Vector3d::UnitZ()) *
                                 Eigen::AngleAxisd(lean_x, Vector3d::UnitX()) *
                                 Eigen::AngleAxisd(lean_y, Vector3d::UnitY());
  for (const auto& [material, mesh] : stone) {
    Mesh copy = mesh;
    for (Vector3d& p : copy.positions) p *= scale;
    copy.Transform(pose);
    model.Add(name, material, std::move(copy));
  }
}

}  // namespace

SceneModel BuildColumnsModel(std::uint64_t seed) {
  SceneModel model;
  const Sand sand(seed);
  AddSand(model, sand);
  AddRubble(model, sand, seed);
  const std::array<std::pair<const char*, Stone>, 3> shapes = {
      {{"column", MakeColumn()}, {"pillar", MakePillar()}, {"stele", MakeStele()}}};
  RandomStream random(seed, "columns/stones");
  for (int row = 0; row < kRows; ++row) {
    for (int i = 0; i < kStonesARow; ++i) {
      // The same order in every row.
      const auto& [name, stone] = shapes[static_cast<std::size_t>(i) % shapes.size()];
      Put(model, fmt::format("{}_{}_{}", name, row, i), stone, kFirstStone + kStoneSpacing * i,
          kRowSpacing * (0.5 - row), sand, random);
    }
  }
  return model;
}

void GenerateColumns(std::uint64_t seed, const std::filesystem::path& directory,
                     double texture_scale) {
  PaintTextures(TextureTasks(), seed, texture_scale, directory / "textures");
  WriteMjcf(BuildColumnsModel(seed), "columns", directory);
}

}  // namespace drydock::scenes::columns
