#include "scenes/cemetery/graves.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "scenes/cemetery/inscriptions.h"
#include "scenes/mesh/lattice_noise.h"
#include "scenes/mesh/shapes.h"
#include "sensors_models/base/random_stream.h"

namespace drydock::scenes::cemetery {
namespace {
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;
constexpr double kDegrees = kPi / 180.0;

/// A row along x: graves at each of `xs`, all looking the same way.
struct Row {
  double y;
  double yaw;
  std::vector<double> xs;
};

/// Inside the square the graves are at columns of their own, so that its sides along y are free.
std::vector<Row> Rows() {
  const std::vector<double> inside = {-0.3, 1.35, 3.0, 4.65, 6.3};
  const std::vector<double> across = {-4.6, -2.9, -1.2, 0.5, 2.2, 3.9, 5.6, 7.3, 9.0, 10.7};
  return {{4.1, 0.0, across},   {1.85, 0.0, across}, {-1.1, kPi, inside},   {-3.35, kPi, inside},
          {-5.65, 0.0, inside}, {-7.9, 0.0, inside}, {-10.85, kPi, across}, {-13.1, kPi, across}};
}

/// Graves west and east of the square look to its sides.
void AddSidePlots(std::vector<Grave>& graves) {
  for (const double y : {-0.9, -2.7, -4.5, -6.3, -8.1}) {
    for (const double x : {-5.1, -3.25}) {
      graves.push_back({.foot = {x, y}, .yaw = 0.5 * kPi});
    }
    for (const double x : {9.25, 11.1}) {
      graves.push_back({.foot = {x, y}, .yaw = -0.5 * kPi});
    }
  }
}

Shape PickShape(RandomStream& random) {
  const double u = random.Uniform();
  if (u < 0.34) return Shape::kRoundTop;
  if (u < 0.57) return Shape::kGabled;
  if (u < 0.75) return Shape::kCross;
  return u < 0.88 ? Shape::kPillow : Shape::kObelisk;
}

void SetPosture(Grave& grave, RandomStream& random) {
  const bool tall = grave.shape == Shape::kObelisk;
  const bool may_fall = grave.shape != Shape::kPillow;
  const double fate = random.Uniform();
  const double strong = !tall && fate < 0.32 ? 9.0 : 2.5;
  grave.tip = std::clamp(random.Gaussian(), -1.8, 1.8) * strong * kDegrees;
  grave.lean = std::clamp(random.Gaussian(), -1.8, 1.8) * 0.7 * strong * kDegrees;
  grave.sunk = random.Uniform(0.02, 0.14);
  const bool on_its_face = random.Uniform() < 0.25;
  if (may_fall && fate > 0.89) {
    grave.fallen = true;
    grave.tip = (on_its_face ? 1.0 : -1.0) * random.Uniform(78.0, 97.0) * kDegrees;
    grave.sunk = random.Uniform(-0.02, 0.03);
  }
}

void SetBed(Grave& grave, RandomStream& random) {
  const double u = random.Uniform();
  grave.urn = random.Uniform() < 0.2 && !grave.fallen;
  if (u < 0.45) grave.bed = Bed::kMound;
  if (u > 0.80) grave.bed = Bed::kKerb;
}

/// The rectangles that railings go around: least x and y, greatest x and y.
struct Plot {
  Vector2d low;
  Vector2d high;
  bool Contains(const Vector2d& p) const {
    return (p.array() > low.array()).all() && (p.array() < high.array()).all();
  }
};
std::vector<Plot> RailedPlots() {
  return {{{0.45, -1.9}, {3.85, -0.66}}, {{3.95, -8.36}, {5.55, -7.2}}};
}

void GiveInscriptions(std::vector<Grave>& graves, RandomStream& random) {
  std::vector<std::pair<double, int>> deck;
  deck.reserve(kInscriptions);
  for (int i = 0; i < kInscriptions; ++i) deck.emplace_back(random.Uniform(), i);
  std::sort(deck.begin(), deck.end());
  std::vector<Grave*> order;
  order.reserve(graves.size());
  for (Grave& grave : graves) order.push_back(&grave);
  std::stable_sort(order.begin(), order.end(), [](const Grave* a, const Grave* b) {
    return DistanceToWay(a->foot) < DistanceToWay(b->foot);
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    order[i]->inscription = deck[i % deck.size()].second;
  }
}

void PlaceObject(SceneModel& model, const std::string& name, const Object& object,
                 const Eigen::Isometry3d& pose) {
  for (const auto& [material, mesh] : object) {
    Mesh placed = mesh;
    placed.Transform(pose);
    model.Add(name, material, std::move(placed));
  }
}

/// On the ground at `p`, turned.
Eigen::Isometry3d OnGround(const Ground& ground, const Vector2d& p, double above, double yaw) {
  return Eigen::Translation3d(p.x(), p.y(), ground.Height(p) + above) *
         Eigen::AngleAxisd(yaw, Vector3d::UnitZ());
}

Vector2d Ahead(const Grave& grave, double forward, double right) {
  // The inscription looks to -y of the stone's own axes, its right is +x.
  const Eigen::Rotation2Dd turn(grave.yaw);
  return grave.foot + turn * Vector2d(right, -forward);
}

/// Silt heaped up over a grave, highest in its middle.
Mesh Mound(const Ground& ground, const Grave& grave, RandomStream& random) {
  const double length = random.Uniform(1.0, 1.45);
  const double width = random.Uniform(0.55, 0.80);
  const double height = random.Uniform(0.09, 0.18);
  const std::uint64_t key = random.Bits();
  return GridSheet(6, 10, [&](double s, double t) -> SurfacePoint {
    const double across = 2.0 * s - 1.0;
    const double along = 2.0 * t - 1.0;
    const double dome = (1.0 - across * across) * (1.0 - along * along * along * along);
    const Vector2d p = Ahead(grave, 0.16 + (1.0 - t) * length, 0.5 * across * width);
    const double bumps = 1.0 + 0.5 * Fbm2(p / 0.35, 2, key);
    const double z = ground.Height(p) - 0.03 + (height + 0.03) * dome * bumps;
    return {{p.x(), p.y(), z}, ground.Uv(p)};
  });
}

Eigen::Isometry3d StonePose(const Ground& ground, const Grave& grave) {
  return OnGround(ground, grave.foot, -grave.sunk, grave.yaw) *
         Eigen::AngleAxisd(grave.tip, Vector3d::UnitX()) *
         Eigen::AngleAxisd(grave.lean, Vector3d::UnitY());
}

void AddGrave(SceneModel& model, const Ground& ground, const Grave& grave, int number,
              RandomStream& random) {
  PlaceObject(model, fmt::format("gravestone_{:02}", number),
              MakeStone(grave.shape, grave.inscription, random), StonePose(ground, grave));
  if (grave.bed == Bed::kMound) {
    model.Add(fmt::format("mound_{:02}", number), "silt", Mound(ground, grave, random));
  }
  if (grave.bed == Bed::kKerb) {
    const double width = random.Uniform(0.66, 0.85);
    PlaceObject(model, fmt::format("kerb_{:02}", number),
                MakeKerb(width, random.Uniform(1.0, 1.4), random),
                OnGround(ground, Ahead(grave, 0.7, 0.0), -0.01, grave.yaw) *
                    Eigen::Translation3d(0.0, 0.55, 0.0));
  }
  if (grave.urn) {
    const double side = random.Uniform() < 0.5 ? -0.32 : 0.32;
    const Vector2d p = Ahead(grave, random.Uniform(0.2, 0.4), side);
    const double tip = 0.12 * random.Gaussian();
    PlaceObject(model, fmt::format("urn_{:02}", number), MakeUrn(random),
                OnGround(ground, p, -0.02, 0.0) * Eigen::AngleAxisd(tip, Vector3d::UnitX()));
  }
}

/// One side of a railing, from `from` to `to`, following the ground.
void AddRailing(SceneModel& model, const std::string& name, const Ground& ground,
                const Vector2d& from, const Vector2d& to, RandomStream& random) {
  const Vector2d along = to - from;
  const double slope = std::atan2(ground.Height(to) - ground.Height(from), along.norm());
  const double lean = 0.06 * random.Gaussian();
  PlaceObject(model, name, MakeRailing(along.norm(), 0.36, random),
              OnGround(ground, from, -0.02, std::atan2(along.y(), along.x())) *
                  Eigen::AngleAxisd(-slope, Vector3d::UnitY()) *
                  Eigen::AngleAxisd(lean, Vector3d::UnitX()));
}

}  // namespace

std::vector<Grave> LayOutGraves(std::uint64_t seed) {
  std::vector<Grave> graves;
  for (const Row& row : Rows()) {
    for (const double x : row.xs) graves.push_back({.foot = {x, row.y}, .yaw = row.yaw});
  }
  AddSidePlots(graves);
  RandomStream random(seed, "cemetery/graves");
  std::vector<Grave> kept;
  for (Grave& grave : graves) {
    const bool missing = random.Uniform() < 0.1;
    const double dx = std::clamp(random.Gaussian(), -2.0, 2.0);
    grave.foot.x() += 0.05 * dx;
    grave.foot.y() += 0.05 * std::clamp(random.Gaussian(), -2.0, 2.0);
    grave.yaw += 3.5 * kDegrees * random.Gaussian();
    grave.shape = PickShape(random);
    SetPosture(grave, random);
    SetBed(grave, random);
    // Rows have gaps, but not along the way, where there is little else to see.
    if (missing && DistanceToWay(grave.foot) > 2.0) continue;
    const std::vector<Plot> plots = RailedPlots();
    const bool railed = std::any_of(plots.begin(), plots.end(),
                                    [&](const Plot& plot) { return plot.Contains(grave.foot); });
    if (railed) grave.bed = Bed::kNone;
    kept.push_back(grave);
  }
  GiveInscriptions(kept, random);
  return kept;
}

void AddGraves(SceneModel& model, const Ground& ground, const std::vector<Grave>& graves,
               std::uint64_t seed) {
  RandomStream random(seed, "cemetery/stones");
  int number = 0;
  for (const Grave& grave : graves) AddGrave(model, ground, grave, number++, random);
}

void AddRailings(SceneModel& model, const Ground& ground, std::uint64_t seed) {
  RandomStream random(seed, "cemetery/railings");
  int number = 0;
  for (const Plot& plot : RailedPlots()) {
    const Vector2d corners[] = {
        plot.low, {plot.high.x(), plot.low.y()}, plot.high, {plot.low.x(), plot.high.y()}};
    for (std::size_t i = 0; i < 4; ++i) {
      AddRailing(model, fmt::format("railing_{}", number++), ground, corners[i],
                 corners[(i + 1) % 4], random);
    }
  }
}

}  // namespace drydock::scenes::cemetery
