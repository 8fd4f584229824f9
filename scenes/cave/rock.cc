#include "scenes/cave/rock.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenes/mesh/cell_noise.h"
#include "scenes/mesh/lattice_noise.h"
#include "scenes/mesh/smooth_step.h"
#include "sensors_models/base/random_stream.h"

namespace drydock::scenes::cave {
namespace {
using Eigen::Vector2d;
using Eigen::Vector3d;

// Detail is asked for only where it can matter: no part of it digs deeper, none stands out further.
constexpr double kDeepest = 1.6;  // [m]
constexpr double kProudest = 0.55;

/// The larger one, rounded where the two are within `width` of each other; never less than either.
double SmoothMax(double a, double b, double width) {
  const double h = std::max(width - std::abs(a - b), 0.0) / width;
  return std::max(a, b) + 0.25 * width * h * h;
}

double SmoothMin(double a, double b, double width) { return -SmoothMax(-a, -b, width); }

/// To first order, positive inside.
double InsideEllipsoid(const Vector3d& p, const Vector3d& radii) {
  const Vector3d scaled = p.cwiseQuotient(radii);
  const double s = scaled.norm();
  const double slope = scaled.cwiseQuotient(radii).norm();
  return slope > 1e-9 ? (1.0 - s) * s / slope : radii.minCoeff();
}

double InsidePassage(const Vector3d& p, const Passage& passage) {
  const Vector3d along = passage.to - passage.from;
  const double t = std::clamp((p - passage.from).dot(along) / along.squaredNorm(), 0.0, 1.0);
  const Vector3d off = p - passage.from - t * along;
  const double w = passage.half_width;
  return InsideEllipsoid(off, {w, w, passage.half_height});
}

/// Rock that widens towards floor and ceiling; negative inside.
double OutsidePillar(const Vector3d& p, const Pillar& pillar) {
  const double rise = (p.z() - pillar.waist_z) / 1.6;
  const double radius = pillar.radius * std::min(1.0 + 0.3 * rise * rise, 2.2);
  return 0.9 * ((p.head<2>() - pillar.center).norm() - radius);
}

}  // namespace

RockField::RockField(const CavePlan& plan, std::uint64_t seed)
    : plan_(plan), route_(plan.route), key_(RandomStream(seed, "cave/rock").BitsAt(0)) {}

double RockField::Open(const Vector3d& p) const {
  const Vector3d n = p / 3.6;
  const Vector3d q = p + Vector3d(0.9 * Fbm3(n, 2, key_), 0.9 * Fbm3(n, 2, key_ + 10),
                                  0.6 * Fbm3(n, 2, key_ + 20));
  double open = -1e3;
  for (const Room& room : plan_.rooms)
    open = SmoothMax(open, InsideEllipsoid(q - room.center, room.radii), 0.5);
  for (const Passage& passage : plan_.passages)
    open = SmoothMax(open, InsidePassage(q, passage), 0.5);
  for (const Pillar& pillar : plan_.pillars) open = SmoothMin(open, OutsidePillar(q, pillar), 0.6);
  return open;
}

double RockField::Beds(const Vector3d& p) const {
  // Beds dip a little and are not flat. What they stand out by changes along them.
  const double z = p.z() + 0.05 * p.x() - 0.03 * p.y() + 0.30 * Fbm3(p / 4.0, 2, key_ + 30);
  constexpr double kThickness = 0.42;
  // Every third or so is thin.
  const double scaled = z / kThickness + 0.35 * Noise2({1.3 * z, 0.5}, key_ + 33);
  const double layer = std::floor(scaled);
  const auto hardness = [&](double i) {
    return Noise3({7.3 * i, p.x() / 3.0, p.y() / 3.0}, key_ + 36);
  };
  const double edge = SmoothStep(0.0, 0.22, scaled - layer);
  return hardness(layer - 1) + (hardness(layer) - hardness(layer - 1)) * edge;
}

double RockField::Joints(const Vector3d& p) const {
  // Two sets of upright cracks, widened by water where it flowed.
  double open = 0.0;
  for (int set = 0; set < 2; ++set) {
    const double angle = 0.5 + 1.75 * set;
    const double across = std::cos(angle) * p.x() + std::sin(angle) * p.y() +
                          0.8 * Fbm3(p / 3.0, 2, key_ + 40 + static_cast<std::uint64_t>(set));
    constexpr double kSpacing = 2.9;
    const double index = std::round(across / kSpacing);
    const double off = std::abs(across - kSpacing * index);
    const double flow = Noise3({9.1 * index + 100 * set, p.x() / 2.6, p.z() / 2.2}, key_ + 44);
    open = std::max(open, (1.0 - off / 0.20) * SmoothStep(-0.1, 0.5, flow));
  }
  return std::max(open, 0.0);
}

double RockField::Detail(const Vector3d& p) const {
  const double kind = Noise3(p / 3.1, key_ + 50);
  const double other = Noise3(p / 2.7, key_ + 51);
  double dug = 0.36 * (0.45 + 0.55 * SmoothStep(-0.4, 0.3, kind)) * Beds(p);
  // Niches of an arm's length, and pockets of one to three hands, both in swarms.
  const auto bowl = [&](double spacing, double low, double high, std::uint64_t key) {
    const StrewnPoint middle = NearestStrewn(p / spacing, key);
    const double share = static_cast<double>(middle.bits & 0xff) / 255.0;
    return std::max(1.0 - std::pow(middle.distance / (low + (high - low) * share), 2), 0.0);
  };
  dug += 0.60 * SmoothStep(-0.3, 0.3, kind) * bowl(2.3, 0.20, 0.55, key_ + 55);
  dug += 0.36 * SmoothStep(-0.25, 0.35, other) * bowl(0.85, 0.30, 0.65, key_ + 52);
  // Scallops that share their rims.
  const StrewnPoint scallop = NearestStrewn(p / 0.46, key_ + 53);
  dug += 0.13 * SmoothStep(-0.3, 0.4, -kind) * (0.5 - 1.4 * scallop.distance * scallop.distance);
  dug += 0.42 * Joints(p);
  dug += 0.36 * Fbm3(p / 1.2, 4, key_ + 54);
  return std::clamp(dug, -kProudest, kDeepest);
}

double RockField::At(const Vector3d& p) const {
  double water = Open(p);
  if (water > -kDeepest && water < kProudest) water += Detail(p);
  // Whatever noise does, the corridor stays free. Its wall is rough too.
  constexpr double kSpare = 0.12;  // [m], for what triangles cut off
  constexpr double kRough = 0.25;
  if (water > kCorridorRadius + kSpare + kRough) return water;
  if (route_.IsFarther(p, kCorridorRadius + kSpare + kRough + kDeepest)) return water;
  const double rough = kRough * (0.5 + 0.5 * Fbm3(p / 0.7, 2, key_ + 60));
  return SmoothMax(water, kCorridorRadius + kSpare + rough - route_.Distance(p), 0.2);
}

double RockField::FirstRock(Vector3d p, double step, double reach) const {
  const double end = p.z() + std::copysign(reach, step);
  while (At(p) > 0.0) {
    if (std::abs(p.z() - end) <= std::abs(step)) return end;
    p.z() += step;
  }
  return p.z();
}

double RockField::CeilingOver(const Vector3d& p, double reach) const {
  return FirstRock(p, 0.04, reach);
}

double RockField::BottomUnder(const Vector3d& p, double reach) const {
  return FirstRock(p, -0.04, reach);
}

SandFloor::SandFloor(const RockField& rock, std::uint64_t seed)
    : rock_(rock), key_(RandomStream(seed, "cave/sand").BitsAt(0)) {}

double SandFloor::Height(double x, double y) const {
  const Vector2d p(x, y);
  const double level = rock_.plan().floor_z;
  double z = level + 0.28 * Fbm2(p / 4.5, 2, key_) + 0.07 * Fbm2(p / 1.2, 2, key_ + 7);
  // Drifts against walls and pillars.
  const double open = rock_.Open({x, y, level + 0.3});
  z += 0.45 * std::exp(-std::max(open, 0.0) / 0.7) * (0.6 + 0.8 * Fbm2(p / 2.3, 2, key_ + 14));
  // Ripples, only in places, and not quite parallel.
  const double across = 0.8 * x + 0.6 * y + 0.5 * Fbm2(p / 2.0, 2, key_ + 21);
  const double where = SmoothStep(-0.25, 0.25, Fbm2(p / 3.0, 2, key_ + 28));
  z += 0.028 * where * std::sin(2 * std::numbers::pi * across / 0.55);
  // Never into the corridor.
  constexpr double kFree = kCorridorRadius + 0.05;
  const Route::Below over = rock_.route().Over(x, y);
  if (over.distance >= kFree) return z;
  return std::min(z, over.z - std::sqrt(kFree * kFree - over.distance * over.distance));
}

}  // namespace drydock::scenes::cave
