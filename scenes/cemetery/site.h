// The place: the lake bed's shape, and the way of a dive that stays free.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "scenes/model/model.h"

namespace drydock::scenes::cemetery {

// The way is a square with round corners: sides along x at kNorth and kSouth, along y at kWest and
// kEast, all [m] in W; the origin lies on the northern one.
inline constexpr double kWest = -1.5;
inline constexpr double kEast = 7.5;
inline constexpr double kNorth = 0.0;
inline constexpr double kSouth = -9.0;
inline constexpr double kCornerRadius = 1.7;

/// Horizontal distance to the way's centre line; negative inside the square [m].
double SignedDistanceToWay(const Eigen::Vector2d& p);
double DistanceToWay(const Eigen::Vector2d& p);

/// How high things may reach at p, so that a body at z = 0 on the way has room [m], in W.
double CeilingAt(const Eigen::Vector2d& p);

/// The silt's shape, in world coordinates.
class Ground {
 public:
  explicit Ground(std::uint64_t seed);
  /// [m], in W.
  double Height(const Eigen::Vector2d& p) const;
  /// Where p is in the silt's picture. It is turned against the way and bent, so that no two
  /// stretches of the way show the same.
  Eigen::Vector2d Uv(const Eigen::Vector2d& p) const;

 private:
  std::uint64_t key_;
};

inline constexpr double kSiltPeriod = 8.0;  ///< One repetition of the silt's picture [m].

void AddGround(SceneModel& model, const Ground& ground);

}  // namespace drydock::scenes::cemetery
