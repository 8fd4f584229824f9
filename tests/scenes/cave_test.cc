#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "scenes/cave/cave_scene.h"
#include "scenes/cave/ground.h"
#include "scenes/cave/painting.h"
#include "scenes/cave/rock.h"
#include "scenes/cave/textures.h"
#include "scenes/cave/walls.h"
#include "scenes/mesh/shapes.h"
#include "tests/scenes/every_scene.h"

namespace drydock::scenes::cave {
namespace {
namespace fs = std::filesystem;
using Eigen::Vector3d;

constexpr std::uint64_t kSeed = 1;
const std::array kPlans = {Cavern1Plan, Cavern2Plan};

/// A cave that is made in a moment.
CavePlan Grotto() {
  CavePlan plan;
  plan.name = "grotto";
  plan.rooms = {{{0, 0, 0}, {3.0, 2.6, 2.6}}};
  plan.heaps = {{{0.5, -1.6}, {0.9, 0.6, 0.6}, 0.0, 4}};
  plan.dripstone = {{{-0.8, 1.6}, 0.6, 5, 0.6}};
  plan.scattered_blocks = 4;
  plan.scattered_stones = 12;
  plan.route = {{-0.6, 0, 0}, {-0.3, 0, 0}, {0, 0, 0}, {0.3, 0, 0}, {0.6, 0, 0}};
  return plan;
}

/// Directions all around.
std::vector<Vector3d> Directions(int count) {
  std::vector<Vector3d> directions;
  for (int i = 0; i < count; ++i) {
    const double z = -1.0 + 2.0 * (i + 0.5) / count;
    const double angle = i * std::numbers::pi * (3.0 - std::sqrt(5.0));
    const double r = std::sqrt(1.0 - z * z);
    directions.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
  }
  return directions;
}

/// How near the meshes' corners come to the route [m].
double Clearance(const SceneModel& model, const Route& route) {
  double nearest = 1e9;
  for (const Part& part : model.parts()) {
    for (const Vector3d& p : part.mesh.positions) {
      if (!route.IsFarther(p, 2.0)) nearest = std::min(nearest, route.Distance(p));
    }
  }
  return nearest;
}

TEST(CaveRoute, DistancesAreThoseToTheLine) {
  const Route route({{0, 0, 0}, {2, 0, 0}, {2, 2, 1}});
  EXPECT_NEAR(route.Distance({1.0, -0.5, 0.0}), 0.5, 1e-12);
  EXPECT_NEAR(route.Distance({-3.0, 0.0, 4.0}), 5.0, 1e-12);
  EXPECT_NEAR(route.Distance({2.0, 1.0, 0.5}), 0.0, 1e-12);
  const Route::Below over = route.Over(3.0, 1.0);
  EXPECT_NEAR(over.distance, 1.0, 1e-12);
  EXPECT_NEAR(over.z, 0.5, 1e-12);
  EXPECT_FALSE(route.IsFarther({1.0, 0.0, 0.9}, 1.0));
  EXPECT_TRUE(route.IsFarther({1.0, 0.0, 9.0}, 1.0));
}

TEST(CavePlans, RoutesBeginAtTheOriginAndStayInTheRooms) {
  for (const auto& make : kPlans) {
    const CavePlan plan = make();
    EXPECT_LT(plan.route.front().norm(), 1e-9) << plan.name;
    const Eigen::AlignedBox3d box = BoundsOf(plan, -1.2);
    for (const Vector3d& p : plan.route) EXPECT_TRUE(box.contains(p)) << plan.name;
  }
}

// Another cave is one number away: the way is free in each, and no two are the same.
TEST(CaveRock, LeavesTheCorridorFreeForEverySeed) {
  for (const auto& make : kPlans) {
    const CavePlan plan = make();
    std::vector<double> probes;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const RockField rock(plan, seed);
      const SandFloor sand(rock, seed);
      for (const Vector3d& p : plan.route) {
        for (const Vector3d& direction : Directions(48)) {
          for (const double distance : {0.4, 0.8, kCorridorRadius}) {
            const Vector3d q = p + distance * direction;
            EXPECT_GT(rock.At(q), 0.05) << plan.name << ", seed " << seed << ": " << q.transpose();
            EXPECT_GT(q.z(), sand.Height(q.x(), q.y())) << plan.name << ", seed " << seed;
          }
        }
      }
      probes.push_back(rock.CeilingOver(plan.route.front(), 8.0));
      EXPECT_GT(probes.back(), kCorridorRadius);
      EXPECT_LT(probes.back(), 6.0);
    }
    std::sort(probes.begin(), probes.end());
    EXPECT_EQ(std::adjacent_find(probes.begin(), probes.end()), probes.end()) << plan.name;
  }
}

TEST(CaveGround, LeavesTheCorridorFreeForEverySeed) {
  for (const auto& make : kPlans) {
    const CavePlan plan = make();
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const RockField rock(plan, seed);
      const SandFloor sand(rock, seed);
      SceneModel model;
      AddBreakdown(model, rock, sand, seed);
      AddDripstone(model, rock, sand, seed);
      AddSand(model, rock, sand, seed);
      EXPECT_GT(Clearance(model, rock.route()), kCorridorRadius) << plan.name << ", seed " << seed;
      // Chance leaves out a few where there is no room, not most.
      std::size_t blocks = 0;
      for (const Part& part : model.parts())
        if (part.body.starts_with("heap_0")) ++blocks;
      for (const Part& part : model.parts()) {
        EXPECT_GE(part.mesh.positions.size(), 4U) << part.geom;  // MuJoCo takes no fewer.
      }
      EXPECT_GE(2 * blocks, static_cast<std::size_t>(plan.heaps[0].blocks)) << plan.name;
    }
  }
}

// Where the corridor does its work: in a room that is too narrow for it.
TEST(CaveRock, TheCorridorIsCutIntoANarrowRoom) {
  CavePlan plan = Grotto();
  plan.rooms = {{{0, 0, 0}, {1.4, 0.7, 0.7}}};
  const RockField rock(plan, kSeed);
  for (const Vector3d& p : plan.route) {
    for (const Vector3d& direction : Directions(64))
      EXPECT_GT(rock.At(p + kCorridorRadius * direction), 0.05);
  }
  EXPECT_LT(rock.At({0.0, 1.8, 0.0}), 0.0);
}

TEST(Painting, CutsAlongTheLine) {
  Mesh ball = Rock({2, 2, 2}, 8, 0.0, 1, {});
  const double area = SurfaceArea(ball);
  Painting painting(ball, 2);
  const auto above = [](const Vector3d& p, const Vector3d&) { return p.z() - 0.3; };
  painting.Repaint(0, 0, 5, above);
  painting.Repaint(1, 0, 7, [](const Vector3d& p, const Vector3d&) { return p.x(); });
  const Mesh& mesh = painting.mesh();
  EXPECT_EQ(CountOpenEdges(mesh), 0U);
  EXPECT_NEAR(SurfaceArea(mesh), area, 1e-9);
  Mesh cap = mesh;
  cap.triangles.clear();
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& t = mesh.triangles[i];
    const Vector3d p = (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3;
    const bool is_cap = painting.LabelOf(0, i) == 5;
    if (std::abs(p.z() - 0.3) > 0.06) {
      EXPECT_EQ(is_cap, p.z() > 0.3);
    }
    if (is_cap) cap.triangles.push_back(t);
  }
  // A cap of height h has the area 2 pi r h.
  EXPECT_NEAR(SurfaceArea(cap), 2 * std::numbers::pi * 0.7, 0.15);
}

TEST(Painting, TouchesOnlyItsLabel) {
  Painting painting(Rock({2, 2, 2}, 6, 0.0, 1, {}), 1);
  painting.Repaint(0, 0, 1, [](const Vector3d& p, const Vector3d&) { return p.z(); });
  const auto count = [&painting](int label) {
    int triangles = 0;
    for (std::size_t i = 0; i < painting.mesh().triangles.size(); ++i)
      if (painting.LabelOf(0, i) == label) ++triangles;
    return triangles;
  };
  painting.Repaint(0, 1, 2, [](const Vector3d& p, const Vector3d&) { return p.x(); });
  EXPECT_GT(count(0), 50);
  EXPECT_GT(count(1), 20);
  EXPECT_GT(count(2), 20);
  for (std::size_t i = 0; i < painting.mesh().triangles.size(); ++i) {
    if (painting.LabelOf(0, i) != 2) continue;
    for (const int v : painting.mesh().triangles[i]) {
      EXPECT_GT(painting.mesh().positions[v].x(), -0.1);
      EXPECT_GT(painting.mesh().positions[v].z(), -0.1);
    }
  }
  EXPECT_EQ(CountOpenEdges(painting.mesh()), 0U);
}

TEST(Grotto, SameSeedGivesTheSameBytesAndAnotherDoesNot) {
  const auto make = [](std::uint64_t seed) {
    return testing::FilesMadeBy(
        [&](const fs::path& folder) { GenerateCave(Grotto(), seed, folder, 0.05); });
  };
  const auto a = make(kSeed);
  const auto b = make(kSeed);
  const auto c = make(kSeed + 1);
  EXPECT_TRUE(a.contains("scene.xml"));
  EXPECT_TRUE(a == b);
  EXPECT_FALSE(a.at("textures/rock_pale.png") == c.at("textures/rock_pale.png"));
  EXPECT_FALSE(a.at("meshes/cave.msh") == c.at("meshes/cave.msh"));
}

TEST(Grotto, TheRockIsClosedAndFacesTheWater) {
  const RockField rock(Grotto(), kSeed);
  const Mesh surface = RockSurface(rock);
  EXPECT_EQ(CountOpenEdges(surface), 0U);
  // About the ellipsoid's; negative, since the outside is out of the rock.
  const double room = 4.0 / 3 * std::numbers::pi * 3.0 * 2.6 * 2.6;
  EXPECT_NEAR(EnclosedVolume(surface), -room, 0.4 * room);
  int right = 0;
  for (const auto& t : surface.triangles) {
    const Vector3d& a = surface.positions[t[0]];
    const Vector3d n =
        (surface.positions[t[1]] - a).cross(surface.positions[t[2]] - a).normalized();
    const Vector3d p = (a + surface.positions[t[1]] + surface.positions[t[2]]) / 3;
    if (rock.At(p + 0.06 * n) > rock.At(p - 0.06 * n)) ++right;
  }
  EXPECT_GT(right, 0.99 * static_cast<double>(surface.triangles.size()));
}

/// Both shipped caves, each made once.
class ShippedCave : public ::testing::TestWithParam<int> {
 protected:
  ShippedCave() : plan_(kPlans.at(GetParam())()), model_(BuildCaveModel(plan_, kSeed)) {}

  CavePlan plan_;
  SceneModel model_;
};

/// The middles of edges that have no partner in the same body.
std::vector<Vector3d> OpenEdges(const Mesh& mesh) {
  using Corner = std::array<long long, 3>;
  const auto corner = [](const Vector3d& p) {
    return Corner{std::llround(p.x() * 1e6), std::llround(p.y() * 1e6), std::llround(p.z() * 1e6)};
  };
  std::map<std::pair<Corner, Corner>, std::pair<int, Vector3d>> edges;
  for (const auto& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      const Vector3d& from = mesh.positions[t[i]];
      const Vector3d& to = mesh.positions[t[(i + 1) % 3]];
      const Corner a = corner(from);
      const Corner b = corner(to);
      if (a == b) continue;
      auto& [balance, middle] = edges[std::minmax(a, b)];
      balance += a < b ? 1 : -1;
      middle = 0.5 * (from + to);
    }
  }
  std::vector<Vector3d> open;
  for (const auto& [ends, edge] : edges)
    if (edge.first != 0) open.push_back(edge.second);
  return open;
}

TEST_P(ShippedCave, IsSoundClosedAndFree) {
  testing::ExpectSoundMeshes(model_);
  testing::ExpectEveryMaterialPainted(model_, TextureTasks());
  EXPECT_GT(model_.CountTriangles(), 100000U);
  EXPECT_LT(model_.CountTriangles(), 350000U);
  EXPECT_LT(model_.parts().size(), 800U);
  const RockField rock(plan_, kSeed);
  const SandFloor sand(rock, kSeed);
  EXPECT_GT(Clearance(model_, rock.route()), kCorridorRadius);
  Mesh walls;
  Mesh floor;
  for (const Part& part : model_.parts()) {
    if (part.body == "cave") walls.Append(part.mesh);
    if (part.body == "sand") floor.Append(part.mesh);
    EXPECT_GE(part.mesh.positions.size(), 4U) << part.geom;
    if (part.body != "cave") continue;
    // Small enough that culling leaves out what is not seen.
    Eigen::AlignedBox3d box;
    for (const Vector3d& p : part.mesh.positions) box.extend(p);
    EXPECT_LT(box.sizes().maxCoeff(), 6.3) << part.geom;
  }
  // No gaps: the walls' rim is buried in the sand, the sand's rim in the rock.
  for (const Vector3d& p : OpenEdges(walls))
    EXPECT_LT(p.z(), sand.Height(p.x(), p.y()) - 0.02) << p.transpose();
  for (const Vector3d& p : OpenEdges(floor)) EXPECT_LT(rock.At(p), 0.0) << p.transpose();
}

INSTANTIATE_TEST_SUITE_P(All, ShippedCave, ::testing::Values(0, 1));

TEST(CaveTextures, MeetThemselves) {
  for (const TextureTask& task : TextureTasks()) {
    testing::ExpectMeetsItself(task.paint(kSeed, 0.4), 49, task.name);
  }
}

TEST(CaveTextures, HaveContrastFromMillimetresToDecimetres) {
  for (const TextureTask& task : TextureTasks())
    testing::ExpectContrastAtEveryScale(task.paint(kSeed, 0.5), task.name);
}

}  // namespace
}  // namespace drydock::scenes::cave
