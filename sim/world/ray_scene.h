// Exact geometry of the world for sonar, depth truth and clearance, by Embree.
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>

#include "sim/world/world.h"

namespace drydock::sim {

struct RayHit {
  double range = 0.0;  ///< Along the unit direction [m].
  Eigen::Vector3d normal =
      Eigen::Vector3d::Zero();  ///< Of the face hit, unit, towards the ray's origin, in W.
  int geom = -1;                ///< MuJoCo's geom id.
};

/// The triangles of every mesh, box and plane of a world, where they are at construction. Rays see
/// both faces of a triangle. Thread-safe for reading.
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

  /// What is nearest to `point` [m, in W], if nearer than `max_distance` [m]. The hit's range is
  /// the distance and its normal points from the surface to the point.
  std::optional<RayHit> Nearest(const Eigen::Vector3d& point, double max_distance) const;

 private:
  struct Embree;
  std::unique_ptr<Embree> embree_;
  Eigen::AlignedBox3d bounds_;
};

}  // namespace drydock::sim
