// The place: the lake bed's shape, and where a dive passes.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "scenes/model/model.h"

namespace drydock::scenes::bus {

/// The lake bed's shape, in world coordinates.
class LakeBed {
 public:
  explicit LakeBed(std::uint64_t seed);
  /// [m], in W.
  double Height(double x, double y) const;

 private:
  std::uint64_t key_;
};

inline constexpr double kTile = 6.144;  ///< one tile of the bed, one repetition of its texture [m]
inline constexpr int kTiles = 7;        ///< along each side
inline constexpr int kBedVariants = 3;  ///< textures that fit each other: bed_0, bed_1...

void AddLakeBed(SceneModel& model, const LakeBed& bed, std::uint64_t seed);

/// The way along the bus, around it and through it that stays free.
class Corridor {
 public:
  Corridor();
  /// Horizontal distance from (x, y) to the way outside the bus [m].
  double HorizontalDistance(double x, double y) const;
  const std::vector<Eigen::Vector3d>& points() const { return points_; }

 private:
  std::vector<Eigen::Vector3d> points_;
};

/// Horizontal distance from (x, y) to the bus' outline, negative inside [m].
double DistanceToBus(double x, double y);

}  // namespace drydock::scenes::bus
