// How much of the daylight reaches each place: the shadows of the scene, soft and coarse.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "sim/optics/daylight_rows.h"
#include "sim/world/ray_scene.h"

namespace drydock::sim {

/// Shares of open water's light that arrive at a place, in [0, 1].
struct Daylight {
  float sun = 1.F;  ///< Of the directed light.
  float sky = 1.F;  ///< Of the diffuse light from above.
};

/// Sun and sky visibility on a cubic lattice, interpolated linearly. Rays are cast when a place is
/// first asked for, a brick of the lattice at a time, so that nothing is done for what is never
/// seen; what a place gets does not depend on the order of asking. Waves and water blur the sun, so
/// that the coarseness is no great lie: shadows have soft edges there.
///
/// A lattice point within or behind a wall is as dark as it is there. Surfaces therefore ask for a
/// place kSurfaceOffset in front of them.
class DaylightGrid {
 public:
  /// `rays` must outlive the grid. Places outside its bounds get the light of the nearest inside.
  DaylightGrid(const RayScene& rays, const Eigen::Vector3d& sun_W);

  static constexpr float kSpacing = 0.2F;         ///< Of the lattice [m].
  static constexpr float kSurfaceOffset = 0.25F;  ///< [m]

  /// At `p_W` [m, in W].
  Daylight At(const Eigen::Vector3f& p_W);

  /// At `count` places with coordinates x, y, z [m, in W]; `sun` and `sky` are
  /// arrays of that length, too.
  void At(int count, const float* x, const float* y, const float* z, float* sun, float* sky);

 private:
  static constexpr int kBrick = 8;  ///< Cells a side.
  static constexpr int kPoints = kBrick + 1;
  static constexpr int kNotBaked = -1;

  void Bake(int brick);
  std::uint32_t CastFrom(const Eigen::Vector3d& p_W) const;

  const RayScene& rays_;
  rows::Lattice lattice_ = {};
  std::vector<Eigen::Vector3d> sun_rays_;
  std::vector<Eigen::Vector3d> sky_rays_;
  std::vector<double> sky_weights_;  ///< Sum 1.
  std::vector<int> first_;           ///< Of each brick: where its points begin, or kNotBaked.
  /// Points of the baked bricks, kPoints^3 each, x fastest. A word has four bytes from low to high:
  /// sun and sky of the point, sun and sky of the one above it.
  std::vector<std::uint32_t> points_;
  std::vector<int> brick_;  ///< Of each place of the row in work.
};

}  // namespace drydock::sim
