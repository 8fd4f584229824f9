// The bus' shape in numbers. Bus frame: x along the bus to the front as in the world, y from its
// centreline to its left, z up; the bus stands at kBusY in the world. All lengths in metres.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "scenes/mesh/slab.h"

namespace drydock::scenes::bus {

inline constexpr double kBusY = -3.2;  ///< the centreline, in the world

inline constexpr double kRear = 1.5;        ///< rear face
inline constexpr double kFront = 10.36;     ///< front face above the eaves
inline constexpr double kFrontLean = 0.14;  ///< the windscreen's foot is this much further on
inline constexpr double kCorner = 0.15;     ///< radius of the body's upright corners
inline constexpr double kSideRear = kRear + kCorner;
inline constexpr double kSideFront = kFront - kCorner;
inline constexpr double kHalfWidth = 1.2;
inline constexpr double kWall = 0.07;
inline constexpr double kSkirt = -1.1;  ///< lower rim of the body
inline constexpr double kFloor = -0.6;
inline constexpr double kRail = -0.45;  ///< the lowest rub rail
inline constexpr double kSill = 0.17;   ///< of the windows
inline constexpr double kHead = 0.83;   ///< of the windows
inline constexpr double kEave = 0.98;   ///< here the side turns into the roof
inline constexpr double kRoofRise = 0.47;
inline constexpr double kCeilingRise = 0.38;
inline constexpr double kEndRise = 0.70;  ///< the roof's rise at both ends, relative to the middle

inline constexpr double kWindowFirst = 1.95;  ///< rear edge of the first window
inline constexpr double kWindowPitch = 0.70;
inline constexpr double kWindowWidth = 0.58;
inline constexpr int kWindows = 11;
inline constexpr double kDriverWindow[2] = {9.62, 10.12};
inline constexpr double kEntryDoor[2] = {9.58, 10.18};
inline constexpr double kEntryDoorTop = 0.86;
inline constexpr double kBackDoorHalfWidth = 0.575;
inline constexpr double kBackDoorTop = 1.15;
inline constexpr double kScreenHalfWidth = 0.93;
inline constexpr double kScreenFoot = 0.2;
inline constexpr double kScreenTop = 1.21;

inline constexpr double kRearAxle = 3.9;
inline constexpr double kFrontAxle = 11.22;
inline constexpr double kAxleHeight = -1.1;
inline constexpr double kWheelRadius = 0.5;
inline constexpr double kArchRadius = 0.58;

enum class Side { kLeft, kRight };

/// Whether a side wall is open at (x, z): windows, the entry door.
bool IsSideOpening(Side side, double x, double z);
/// Lower rim of a side wall, with the rear wheel's arch.
double SkirtBottom(double x);

/// Lines across the roof, from the right eave (-1) to the left one (1), as fractions of the half
/// width.
const std::vector<double>& RoofLines();
/// Height of the roof (or the ceiling) over the eave as a fraction of its rise, at y / half width.
double RoofFraction(double y_fraction);
/// Factor of the rise at a distance from the nearer end.
double EndFactor(double distance);
/// The outer faces of the ends at y, z.
double RearX(double y);
double FrontX(double y, double z);

/// Texture canvases: where a texture's left upper corner is and how far it reaches [m].
struct Canvas2d {
  double left, top, width, height;
};
inline constexpr Canvas2d kSideCanvas{1.45, 1.05, 9.0, 2.2};    // x, z
inline constexpr Canvas2d kEndCanvas{-1.3, 1.4, 2.6, 2.6};      // y, z
inline constexpr Canvas2d kRoofCanvas{1.45, -1.45, 9.1, 2.9};   // x, arc from the right eave
inline constexpr Canvas2d kInsideCanvas{1.45, 1.02, 9.1, 1.7};  // x, z
inline constexpr Canvas2d kFloorCanvas{1.45, -1.2, 9.1, 2.4};   // x, y
inline constexpr Canvas2d kHoodCanvas{0.0, 0.0, 3.3, 3.1};      // unrolled: hood, then fenders
inline constexpr Canvas2d kDoorCanvas{0.0, 0.0, 2.4, 1.85};     // outside, then inside

/// Texture coordinates by the canvases above, right way round for whoever looks at the outside.
Eigen::Vector2d SideUv(Side side, const Eigen::Vector3d& p);
Eigen::Vector2d RearUv(const Eigen::Vector3d& p);
Eigen::Vector2d FrontUv(const Eigen::Vector3d& p);
Eigen::Vector2d InsideUv(Side side, const Eigen::Vector3d& p);
Eigen::Vector2d FloorUv(const Eigen::Vector3d& p);

/// Bus frame to world: on its place, settled slightly askew.
Eigen::Isometry3d BusPose();

}  // namespace drydock::scenes::bus
