// Exact geometry of the world for sonar, depth truth and clearance, by Embree.
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <vector>

#include "sim/world/world.h"

namespace drydock::sim {

struct RayHit {
  double range = 0.0;  ///< Along the unit direction [m].
  Eigen::Vector3d normal =
      Eigen::Vector3d::Zero();  ///< Of the face hit, unit, towards the ray's origin, in W.
  int geom = -1;                ///< MuJoCo's geom id.
};

/// Directions of many rays, one a column: unit vectors, in W.
using RayFan = Eigen::Matrix<float, 3, Eigen::Dynamic>;

/// What one ray of a fan met.
struct FanHit {
  float range = 0.0F;          ///< Along the ray [m].
  float cos_incidence = 0.0F;  ///< Of the angle between ray and normal; from 0 to 1.
  int geom = -1;               ///< MuJoCo's geom id; -1 where the ray met nothing.
};

/// The triangles of every mesh, box and plane of a world that stays where it is; nothing that
/// moves. Rays see both faces of a triangle. Thread-safe for reading.
class RayScene {
 public:
  /// InputError if a geom has a shape that is not supported.
  explicit RayScene(const World& world);
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  /// The first hit of the ray from `origin` [m, in W] along the unit vector `direction` within
  /// `max_range` [m].
  std::optional<RayHit> Cast(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                             double max_range) const;

  /// Whether anything lies on the ray within `max_range` [m]; cheaper than Cast.
  bool IsOccluded(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                  double max_range) const;

  /// Around everything but planes [m, in W]; empty if there is nothing else.
  const Eigen::AlignedBox3d& Bounds() const { return bounds_; }

  /// The same for many rays from one point that are close together, at a fraction of the time. One
  /// hit a ray, in the order of the rays.
  std::vector<FanHit> CastFan(const Eigen::Vector3d& origin, const RayFan& directions,
                              double max_range) const;

  /// Whether anything lies between points `from` and `to` [m, in W], column by column, farther than
  /// `margin` [m] from the latter. Fast where neighbours are close together.
  std::vector<char> AreHidden(const Eigen::Ref<const RayFan>& from,
                              const Eigen::Ref<const RayFan>& to, float margin) const;

  /// What is nearest to `point` [m, in W], if nearer than `max_distance` [m]. The hit's range is
  /// the distance and its normal points from the surface to the point.
  std::optional<RayHit> Nearest(const Eigen::Vector3d& point, double max_distance) const;

 private:
  struct Embree;
  std::unique_ptr<Embree> embree_;
  Eigen::AlignedBox3d bounds_;
};

}  // namespace drydock::sim
