#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "scenes/cemetery/cemetery_scene.h"
#include "scenes/cemetery/graves.h"
#include "scenes/cemetery/inscriptions.h"
#include "scenes/cemetery/site.h"
#include "scenes/cemetery/stones.h"
#include "scenes/cemetery/textures.h"
#include "tests/scenes/every_scene.h"

namespace drydock::scenes::cemetery {
namespace {
namespace fs = std::filesystem;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr std::uint64_t kSeed = 1;

TEST(CemeteryScene, SameSeedGivesTheSameBytes) {
  const auto make = [](std::uint64_t seed) {
    return testing::FilesMadeBy(
        [&](const fs::path& folder) { GenerateCemetery(seed, folder, 0.1); });
  };
  const auto a = make(kSeed);
  const auto b = make(kSeed);
  const auto c = make(kSeed + 1);
  EXPECT_TRUE(a.contains("scene.xml"));
  EXPECT_TRUE(a == b);
  for (const char* other : {"textures/silt.png", "textures/inscriptions.png", "meshes/ground.msh",
                            "meshes/gravestone_00.msh"}) {
    EXPECT_FALSE(a.at(other) == c.at(other)) << other;
  }
}

TEST(CemeteryScene, EveryMaterialIsPaintedAndEveryPictureUsed) {
  testing::ExpectEveryMaterialPainted(BuildCemeteryModel(kSeed), TextureTasks());
}

// No part but the ground's tiles reaches further than 4 m, so that what is out of view is not
// drawn.
TEST(CemeteryScene, MeshesAreSoundSmallAndNotTooMany) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const SceneModel model = BuildCemeteryModel(seed);
    testing::ExpectSoundMeshes(model);
    EXPECT_LT(model.CountTriangles(), 80000U) << seed;
    for (const Part& part : model.parts()) {
      Eigen::AlignedBox3d box;
      for (const Vector3d& p : part.mesh.positions) box.extend(p);
      const double longest = box.sizes().head<2>().maxCoeff();
      EXPECT_LT(longest, part.body == "ground" ? 6.1 : 4.0) << part.geom;
    }
  }
}

TEST(CemeteryStones, AreClosedAndOfTheirInscriptionsStone) {
  RandomStream random(kSeed, "test");
  for (int i = 0; i < 10 * kShapes; ++i) {
    const int inscription = i % kInscriptions;
    const Object stone = MakeStone(static_cast<Shape>(i % kShapes), inscription, random);
    ASSERT_EQ(stone.size(), 2U);
    EXPECT_EQ(stone[0].first, IsPale(inscription) ? "limestone" : "slate");
    EXPECT_EQ(stone[1].first, "inscriptions");
    const UvRect cell = InscriptionCell(inscription);
    for (const Vector2d& uv : stone[1].second.uvs) {
      EXPECT_GE(uv.x(), cell.low.x());
      EXPECT_LE(uv.x(), cell.high.x());
    }
    Mesh all;
    for (const auto& [material, mesh] : stone) all.Append(mesh);
    EXPECT_EQ(CountOpenEdges(all), 0U) << i % kShapes;
    EXPECT_GT(EnclosedVolume(all), 0.03);
    double top = 0.0;
    for (const Vector3d& p : all.positions) top = std::max(top, p.z());
    EXPECT_GT(top, 0.35);
    EXPECT_LT(top, 1.4);
  }
}

TEST(CemeteryGraves, NoNameComesTwice) {
  std::set<std::string> names;
  for (const Inscription& inscription : Inscriptions(kSeed)) {
    EXPECT_TRUE(names.insert(inscription.first_name + inscription.surname).second);
  }
  EXPECT_EQ(names.size(), static_cast<std::size_t>(kInscriptions));
  EXPECT_GE(kInscriptions, 16);
}

TEST(CemeteryGraves, AlongTheWayNoInscriptionComesTwice) {
  std::vector<Grave> graves = LayOutGraves(kSeed);
  std::sort(graves.begin(), graves.end(), [](const Grave& a, const Grave& b) {
    return DistanceToWay(a.foot) < DistanceToWay(b.foot);
  });
  std::set<int> seen;
  for (int i = 0; i < kInscriptions; ++i) {
    EXPECT_TRUE(seen.insert(graves[i].inscription).second) << i;
  }
  // All that are so near that haze of 4 m shows their letters.
  EXPECT_GT(DistanceToWay(graves[kInscriptions - 1].foot), 2.0);
}

TEST(CemeteryGraves, AnotherSeedDealsOtherwise) {
  const std::vector<Grave> a = LayOutGraves(1);
  const std::vector<Grave> b = LayOutGraves(2);
  int same = 0;
  const std::size_t count = std::min(a.size(), b.size());
  for (std::size_t i = 0; i < count; ++i) same += a[i].inscription == b[i].inscription ? 1 : 0;
  EXPECT_LT(same, 12);
  EXPECT_NE(Inscriptions(1).front().dates, Inscriptions(2).front().dates);
}

TEST(CemeteryGraves, SomeLeanAndSomeHaveFallen) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const std::vector<Grave> graves = LayOutGraves(seed);
    EXPECT_GT(graves.size(), 60U);
    EXPECT_LT(graves.size(), 90U);
    int fallen = 0;
    int leaning = 0;
    std::map<Shape, int> shapes;
    for (const Grave& grave : graves) {
      fallen += grave.fallen ? 1 : 0;
      leaning += !grave.fallen && std::hypot(grave.tip, grave.lean) > 0.1 ? 1 : 0;
      ++shapes[grave.shape];
    }
    EXPECT_GE(fallen, 3) << seed;
    EXPECT_LE(fallen, 20) << seed;
    EXPECT_GE(leaning, 8) << seed;
    ASSERT_EQ(shapes.size(), static_cast<std::size_t>(kShapes)) << seed;
    for (const auto& [shape, count] : shapes) EXPECT_GE(count, 4) << seed;
  }
}

TEST(CemeteryScene, StonesStandInTheSilt) {
  const Ground ground(kSeed);
  std::map<std::string, Mesh> stones;
  const SceneModel model = BuildCemeteryModel(kSeed);
  for (const Part& part : model.parts()) {
    if (part.body.starts_with("gravestone")) stones[part.body].Append(part.mesh);
  }
  EXPECT_EQ(stones.size(), LayOutGraves(kSeed).size());
  for (const auto& [name, mesh] : stones) {
    double lowest = 1e9;
    double highest = -1e9;
    for (const Vector3d& p : mesh.positions) {
      lowest = std::min(lowest, p.z() - ground.Height(p.head<2>()));
      highest = std::max(highest, p.z() - ground.Height(p.head<2>()));
    }
    EXPECT_LT(lowest, -0.01) << name;
    EXPECT_GT(highest, 0.04) << name;
  }
}

/// How near a triangle comes to what lies within `band` [m] of the way, aside and in height:
/// points on it no further apart than 0.1 m are asked.
double NearestToWay(const Vector3d& a, const Vector3d& b, const Vector3d& c, double band) {
  const double ab = (b - a).norm();
  const double bc = (c - b).norm();
  const double ca = (a - c).norm();
  const double longest = std::max({ab, bc, ca});
  const Vector3d middle = (a + b + c) / 3.0;
  const double distance = std::hypot(std::max(0.0, DistanceToWay(middle.head<2>()) - band),
                                     std::max(0.0, std::abs(middle.z()) - band));
  if (longest < 0.1 || distance > 1.5 + longest) return distance;
  if (longest == ab) {
    const Vector3d m = 0.5 * (a + b);
    return std::min(NearestToWay(a, m, c, band), NearestToWay(m, b, c, band));
  }
  if (longest == bc) {
    const Vector3d m = 0.5 * (b + c);
    return std::min(NearestToWay(a, b, m, band), NearestToWay(a, m, c, band));
  }
  const Vector3d m = 0.5 * (c + a);
  return std::min(NearestToWay(a, b, m, band), NearestToWay(m, b, c, band));
}

TEST(CemeteryScene, TheWayStaysFreeAtAnySeed) {
  constexpr double kClearance = 0.43;  // And sway.
  constexpr double kBand = 0.1;        // The rounds of a dive are that far from the way.
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    double nearest = 1e9;
    std::string geom;
    const SceneModel model = BuildCemeteryModel(seed);
    for (const Part& part : model.parts()) {
      for (const auto& t : part.mesh.triangles) {
        const auto& p = part.mesh.positions;
        const double distance = NearestToWay(p[t[0]], p[t[1]], p[t[2]], kBand);
        if (distance < nearest) geom = part.geom;
        nearest = std::min(nearest, distance);
      }
    }
    EXPECT_GT(nearest, kClearance) << geom << ", seed " << seed;
    EXPECT_LT(nearest, 1.0) << "Is there anything at all?";
  }
}

/// The way by a step of 0.25 m: place and direction, clockwise.
std::vector<std::pair<Vector2d, double>> Way() {
  std::vector<std::pair<Vector2d, double>> way;
  const double straight = kEast - kWest - 2.0 * kCornerRadius;
  const Vector2d middle(0.5 * (kWest + kEast), 0.5 * (kSouth + kNorth));
  for (int side = 0; side < 4; ++side) {
    const Eigen::Rotation2Dd turn(-0.5 * std::numbers::pi * side);
    for (double s = -0.5 * straight; s <= 0.5 * straight; s += 0.25) {
      way.emplace_back(middle + turn * Vector2d(s, 0.5 * (kNorth - kSouth)),
                       -0.5 * std::numbers::pi * side);
    }
    for (double angle = 0.0; angle < 0.5 * std::numbers::pi; angle += 0.15) {
      const Vector2d out(std::sin(angle), std::cos(angle));
      const Vector2d corner = Vector2d::Constant(0.5 * straight) + kCornerRadius * out;
      way.emplace_back(middle + turn * corner, -0.5 * std::numbers::pi * side - angle);
    }
  }
  return way;
}

TEST(CemeterySite, TheWayIsARoundedSquare) {
  const auto way = Way();
  for (const auto& [p, yaw] : way) EXPECT_NEAR(SignedDistanceToWay(p), 0.0, 1e-9);
  EXPECT_NEAR(SignedDistanceToWay({0.5 * (kWest + kEast), kNorth + 1.3}), 1.3, 1e-9);
  EXPECT_NEAR(SignedDistanceToWay({kEast - 0.7, -4.0}), -0.7, 1e-9);
}

// The silt's picture repeats. Two stretches of the way with the same view of it would be a false
// loop to find.
TEST(CemeterySite, NoTwoStretchesOfTheWayShowTheSameSilt) {
  const auto way = Way();
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Ground ground(seed);
    double nearest = 1e9;
    for (const auto& [p, p_yaw] : way) {
      for (const auto& [q, q_yaw] : way) {
        if ((p - q).norm() < 2.0) continue;
        const double turned = std::remainder(p_yaw - q_yaw, 2.0 * std::numbers::pi);
        if (std::abs(turned) > 0.6) continue;
        Vector2d apart = ground.Uv(p) - ground.Uv(q);
        apart -= apart.array().round().matrix();
        nearest = std::min(nearest, kSiltPeriod * apart.norm());
      }
    }
    EXPECT_GT(nearest, 0.6) << seed;
  }
}

TEST(CemeteryTextures, WhatRepeatsMeetsItself) {
  for (const TextureTask& task : TextureTasks()) {
    if (task.name == "inscriptions" || task.name == "plants") continue;
    testing::ExpectMeetsItself(task.paint(kSeed, 0.5), 99, task.name);
  }
}

TEST(CemeteryTextures, HaveContrastFromMillimetresToDecimetres) {
  for (const TextureTask& task : TextureTasks())
    testing::ExpectContrastAtEveryScale(task.paint(kSeed, 0.5), task.name);
}

/// The lines of text of one cell, in grey.
cv::Mat1f TextOf(const cv::Mat3b& atlas, int inscription) {
  const UvRect rect = InscriptionCell(inscription, true);
  const Vector2d size(atlas.cols, atlas.rows);
  const Vector2d low = rect.low.cwiseProduct(size);
  const Vector2d high = rect.high.cwiseProduct(size);
  const cv::Rect pixels(cv::Point(static_cast<int>(low.x()), static_cast<int>(low.y())),
                        cv::Point(static_cast<int>(high.x()), static_cast<int>(high.y())));
  cv::Mat1b grey;
  cv::cvtColor(atlas(pixels), grey, cv::COLOR_RGB2GRAY);
  cv::Mat1f text;
  grey.convertTo(text, CV_32F);
  cv::resize(text, text, {112, 88}, 0, 0, cv::INTER_AREA);
  return text;
}

// What letters change of the bare stone: clearly everywhere, and nowhere as elsewhere.
TEST(CemeteryTextures, EachCellHasLettersOfItsOwn) {
  const cv::Mat3b written = PaintInscriptions(Inscriptions(kSeed), kSeed, 0.5);
  const cv::Mat3b bare = PaintInscriptions(std::vector<Inscription>(kInscriptions), kSeed, 0.5);
  std::vector<cv::Mat1f> letters;
  letters.reserve(kInscriptions);
  for (int i = 0; i < kInscriptions; ++i) {
    letters.emplace_back(TextOf(written, i) - TextOf(bare, i));
    const int changed = cv::countNonZero(cv::abs(letters.back()) > 12.0);
    EXPECT_GT(changed, 0.04 * static_cast<double>(letters.back().total())) << i;
    for (int j = 0; j < i; ++j) {
      const double product = letters[i].dot(letters[j]);
      EXPECT_LT(product, 0.75 * cv::norm(letters[i]) * cv::norm(letters[j])) << i << ", " << j;
    }
  }
}

}  // namespace
}  // namespace drydock::scenes::cemetery
