#include "sim/optics/daylight_grid.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace drydock::sim {
namespace {

constexpr double kFarthestShadow = 30.0;  ///< Of what casts one [m].
constexpr int kSunRays = 5;
constexpr double kSunRadius = 0.07;  ///< Of the sun's disc, blurred by waves, as a tangent.
constexpr int kSkyRays = 24;
/// Longer scenes get their outermost light beyond this.
constexpr double kLongest = 200.0;  // [m]

/// The middle and a ring.
std::vector<Eigen::Vector3d> RaysToSun(const Eigen::Vector3d& sun) {
  const Eigen::Vector3d side = sun.unitOrthogonal();
  const Eigen::Vector3d other = sun.cross(side);
  std::vector<Eigen::Vector3d> rays = {sun};
  for (int i = 1; i < kSunRays; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / (kSunRays - 1);
    rays.push_back(
        (sun + kSunRadius * (std::cos(angle) * side + std::sin(angle) * other)).normalized());
  }
  return rays;
}

/// Equal solid angles of the upper hemisphere, on a spiral that turns by the golden angle.
std::vector<Eigen::Vector3d> RaysToSky() {
  const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
  std::vector<Eigen::Vector3d> rays;
  for (int i = 0; i < kSkyRays; ++i) {
    const double up = (i + 0.5) / kSkyRays;
    const double level = std::sqrt(1.0 - up * up);
    rays.emplace_back(level * std::cos(golden * i), level * std::sin(golden * i), up);
  }
  return rays;
}

/// Light from a zenith angle as under an overcast sky (Moon and Spencer, 1942): (1 + 2 cos) / 3.
std::vector<double> SkyWeights(const std::vector<Eigen::Vector3d>& rays) {
  std::vector<double> weights;
  double sum = 0.0;
  for (const Eigen::Vector3d& ray : rays) sum += weights.emplace_back(1.0 + 2.0 * ray.z());
  for (double& weight : weights) weight /= sum;
  return weights;
}

std::uint32_t ToByte(double share) {
  return static_cast<std::uint32_t>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
}

}  // namespace

DaylightGrid::DaylightGrid(const RayScene& rays, const Eigen::Vector3d& sun_W)
    : rays_(rays),
      sun_rays_(RaysToSun(sun_W)),
      sky_rays_(RaysToSky()),
      sky_weights_(SkyWeights(sky_rays_)) {
  Eigen::AlignedBox3d box = rays.Bounds();
  if (box.isEmpty()) return;
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(0.5 * kLongest);
  box = box.intersection(Eigen::AlignedBox3d(box.center() - reach, box.center() + reach));
  // A little wider, so that what lies outside is as bright as what borders on it.
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(2.0 * kSpacing);
  const Eigen::Vector3d low = box.min() - margin;
  const Eigen::Vector3d size = box.max() + margin - low;
  std::size_t count = 1;
  for (int axis = 0; axis < 3; ++axis) {
    lattice_.origin[axis] = static_cast<float>(low[axis]);
    lattice_.bricks[axis] = static_cast<int>(std::ceil(size[axis] / (kBrick * kSpacing)));
    lattice_.highest[axis] = static_cast<float>(lattice_.bricks[axis] * kBrick) - 0.01F;
    count *= static_cast<std::size_t>(lattice_.bricks[axis]);
  }
  lattice_.per_metre = 1.F / kSpacing;
  first_.assign(count, kNotBaked);
}

std::uint32_t DaylightGrid::CastFrom(const Eigen::Vector3d& p_W) const {
  double sun = 0.0, sky = 0.0;
  for (const Eigen::Vector3d& ray : sun_rays_)
    sun += rays_.IsOccluded(p_W, ray, kFarthestShadow) ? 0.0 : 1.0 / kSunRays;
  for (std::size_t i = 0; i < sky_rays_.size(); ++i)
    sky += rays_.IsOccluded(p_W, sky_rays_[i], kFarthestShadow) ? 0.0 : sky_weights_[i];
  return ToByte(sun) | ToByte(sky) << 8;
}

void DaylightGrid::Bake(int brick) {
  const Eigen::Vector3i cell =
      kBrick * Eigen::Vector3i(brick % lattice_.bricks[0],
                               brick / lattice_.bricks[0] % lattice_.bricks[1],
                               brick / lattice_.bricks[0] / lattice_.bricks[1]);
  const Eigen::Vector3d origin = Eigen::Map<const Eigen::Vector3f>(lattice_.origin).cast<double>();
  const std::size_t first = points_.size();
  for (int z = 0; z < kPoints; ++z) {
    for (int y = 0; y < kPoints; ++y) {
      for (int x = 0; x < kPoints; ++x) {
        const Eigen::Vector3i point = cell + Eigen::Vector3i(x, y, z);
        points_.push_back(CastFrom(origin + double{kSpacing} * point.cast<double>()));
      }
    }
  }
  constexpr std::size_t kLayer = kPoints * kPoints;
  for (std::size_t i = first; i + kLayer < points_.size(); ++i)
    points_[i] |= points_[i + kLayer] << 16;
  first_[static_cast<std::size_t>(brick)] = static_cast<int>(first);
}

void DaylightGrid::At(int count, const float* x, const float* y, const float* z, float* sun,
                      float* sky) {
  if (first_.empty()) {
    std::fill_n(sun, count, 1.F);
    std::fill_n(sky, count, 1.F);
    return;
  }
  brick_.resize(static_cast<std::size_t>(count));
  rows::Bricks(lattice_, count, x, y, z, brick_.data());
  int last = -1;
  for (const int brick : brick_) {
    if (brick == last) continue;
    last = brick;
    if (first_[static_cast<std::size_t>(brick)] == kNotBaked) Bake(brick);
  }
  rows::Interpolate(lattice_, first_.data(), points_.data(), count, x, y, z, brick_.data(), sun,
                    sky);
}

Daylight DaylightGrid::At(const Eigen::Vector3f& p_W) {
  Daylight light;
  At(1, &p_W.x(), &p_W.y(), &p_W.z(), &light.sun, &light.sky);
  return light;
}

}  // namespace drydock::sim
