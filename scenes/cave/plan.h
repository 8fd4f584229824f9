// What of a cave is the same for every seed: its rooms, and the way that stays free.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

namespace drydock::scenes::cave {

/// A room, a lobe of one, or a dome in its ceiling: an ellipsoid [m, in W].
struct Room {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Vector3d radii = Eigen::Vector3d::Ones();
};

/// A stretch of passage with an elliptical section [m, in W].
struct Passage {
  Eigen::Vector3d from = Eigen::Vector3d::Zero();
  Eigen::Vector3d to = Eigen::Vector3d::Zero();
  double half_width = 1.5;
  double half_height = 1.25;
};

/// Rock that was left standing from floor to ceiling, thinnest at height `waist_z` [m, in W].
struct Pillar {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  double radius = 0.8;
  double waist_z = 0.5;
};

/// A heap of blocks that fell from the ceiling: half an ellipsoid of these radii [m, in W].
struct Heap {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  Eigen::Vector3d radii = Eigen::Vector3d::Ones();
  double yaw_rad = 0.0;
  int blocks = 12;
};

/// A ceiling to hang dripstone from: clusters within a circle [m, in W].
struct DripstoneSpot {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  double radius = 1.0;
  int count = 6;
  double longest = 1.0;
};

struct CavePlan {
  std::string name;
  std::vector<Room> rooms;
  std::vector<Passage> passages;
  std::vector<Pillar> pillars;
  std::vector<Heap> heaps;
  std::vector<DripstoneSpot> dripstone;
  int scattered_blocks = 30;   ///< single ones along the walls
  int scattered_stones = 150;  ///< up to 0.5 m
  double floor_z = -1.6;       ///< of the sand, about [m, in W]
  /// The way of the dive, a line with points some decimetres apart [m, in W].
  std::vector<Eigen::Vector3d> route;
};

/// Everything is at least this far from the route, whatever the seed [m].
inline constexpr double kCorridorRadius = 1.0;

/// A ballroom of 20 x 14 m around a pillar in a heap of blocks.
CavePlan Cavern1Plan();
/// Two rooms of 11 x 9 m, each with a pillar, and a passage of 10 m between them.
CavePlan Cavern2Plan();

/// A box around all rooms and passages, with `margin` of rock [m].
Eigen::AlignedBox3d BoundsOf(const CavePlan& plan, double margin);

}  // namespace drydock::scenes::cave
