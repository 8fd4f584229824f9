#include "scenes/creatures/creatures.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "scenes/creatures/arm_shape.h"
#include "scenes/creatures/fish_shape.h"
#include "tests/scenes/every_scene.h"

namespace drydock::scenes::creatures {
namespace {
namespace fs = std::filesystem;
using Eigen::Vector3d;

constexpr std::uint64_t kSeed = 1;

Eigen::AlignedBox3d BoundsOf(const Mesh& mesh) {
  Eigen::AlignedBox3d bounds;
  for (const Vector3d& p : mesh.positions) bounds.extend(p);
  return bounds;
}

Mesh WholeFish(const FishShape& shape) {
  Mesh fish;
  for (const FishPart& part : MakeFish(shape)) fish.Append(part.mesh);
  return fish;
}

TEST(Creatures, SameSeedGivesTheSameBytes) {
  const auto make = [](std::uint64_t seed) {
    return testing::FilesMadeBy(
        [&](const fs::path& folder) { GenerateCreatures(seed, folder, 0.1); });
  };
  const auto a = make(kSeed);
  const auto b = make(kSeed);
  EXPECT_TRUE(a == b);
  for (const auto& [name, parts] : CreatureParts()) {
    for (const CreaturePart& part : parts) {
      EXPECT_TRUE(a.contains(part.mesh)) << part.mesh;
      EXPECT_TRUE(a.contains(part.texture)) << part.texture;
    }
  }
}

TEST(Creatures, AreGeneratedOnce) {
  const fs::path cache = fs::path(::testing::TempDir()) / "drydock_creatures_cache_test";
  fs::remove_all(cache);
  const fs::path folder = PrepareCreatures(cache);
  const auto written = fs::last_write_time(folder / "scene.xml");
  EXPECT_EQ(PrepareCreatures(cache), folder);
  EXPECT_EQ(fs::last_write_time(folder / "scene.xml"), written);
  fs::remove_all(cache);
}

TEST(Creatures, EveryMaterialIsPaintedAndEveryPictureUsed) {
  testing::ExpectEveryMaterialPainted(BuildCreaturesModel(), TextureTasks());
}

TEST(Creatures, MeshesAreSoundClosedAndNotTooMany) {
  const SceneModel model = BuildCreaturesModel();
  testing::ExpectSoundMeshes(model);
  EXPECT_LT(model.CountTriangles(), 20000U);
  for (const Part& part : model.parts()) {
    EXPECT_EQ(CountOpenEdges(part.mesh), 0U) << part.geom;
    EXPECT_GT(EnclosedVolume(part.mesh), 0.0) << part.geom;
  }
  for (const FishShape& shape : FishShapes())
    EXPECT_LT(WholeFish(shape).triangles.size(), 1600U) << shape.kind;
}

TEST(Fish, AreOneMetreLongAndFlat) {
  for (const FishShape& shape : FishShapes()) {
    const Mesh fish = WholeFish(shape);
    const Eigen::AlignedBox3d bounds = BoundsOf(fish);
    EXPECT_NEAR(bounds.max().x(), kOrigin, 1e-3) << shape.kind;
    EXPECT_NEAR(bounds.sizes().x(), 1.0, 0.03) << shape.kind;
    EXPECT_NEAR(bounds.max().y(), -bounds.min().y(), 1e-9) << shape.kind;
    EXPECT_GT(bounds.sizes().z(), 1.3 * bounds.sizes().y()) << shape.kind;
    // A fish of 0.3 m weighs between 0.2 and 1 kg.
    EXPECT_GT(EnclosedVolume(fish) * 0.027, 0.2e-3) << shape.kind;
    EXPECT_LT(EnclosedVolume(fish) * 0.027, 1.0e-3) << shape.kind;
  }
}

// Where a part turns it must lie in the part ahead, or a bend would show a gap.
TEST(Fish, PartsReachIntoTheOneAhead) {
  for (const FishShape& shape : FishShapes()) {
    const std::vector<FishPart> parts = MakeFish(shape);
    ASSERT_GE(parts.size(), 3U);
    for (std::size_t i = 1; i < parts.size(); ++i) {
      EXPECT_LT(parts[i].joint, parts[i - 1].joint);
      EXPECT_GT(BoundsOf(parts[i].mesh).max().x(), parts[i].joint + 0.02);
      EXPECT_NEAR(BoundsOf(parts[i - 1].mesh).min().x(), parts[i].joint, 0.05);
    }
  }
}

TEST(DiverArm, IsAsLongAsItSaysAndMirrored) {
  const Mesh right = MakeArm(Side::kRight);
  const Mesh left = MakeArm(Side::kLeft);
  const Eigen::AlignedBox3d bounds = BoundsOf(right);
  EXPECT_NEAR(bounds.max().x(), kArmReach, 0.01);
  EXPECT_NEAR(bounds.max().y(), -BoundsOf(left).min().y(), 1e-12);
  EXPECT_NEAR(bounds.min().y(), -BoundsOf(left).max().y(), 1e-12);
  // The thumb is on the inside: the right hand's is on the left.
  double thumb = 0.0;
  for (const Vector3d& p : right.positions) {
    if (p.x() > 0.28) thumb = std::max(thumb, p.y());
  }
  EXPECT_GT(thumb, 0.06);
}

// The sleeve runs on down and back: seen from ahead and above, no end of it shows.
TEST(DiverArm, HasNoEndInView) {
  const Eigen::AlignedBox3d bounds = BoundsOf(MakeArm(Side::kRight));
  EXPECT_LT(bounds.min().x(), -0.2);
  EXPECT_LT(bounds.min().z(), -0.15);
}

TEST(CreatureTextures, HaveContrast) {
  for (const TextureTask& task : TextureTasks())
    testing::ExpectContrastAtEveryScale(task.paint(kSeed, 0.5), task.name);
}

}  // namespace
}  // namespace drydock::scenes::creatures
