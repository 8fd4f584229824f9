#include "scenes/bus/bus_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace drydock::scenes::bus {
namespace {

constexpr int kRoofCells = 16;
constexpr double kRoofPower = 2.5;  // superellipse: between an arc and a box

bool Between(double x, double low, double high) { return low < x && x < high; }

std::vector<double> MakeRoofLines() {
  std::vector<double> lines;
  for (int k = 0; k <= kRoofCells; ++k) {
    const double c = -std::cos(std::numbers::pi * k / kRoofCells);
    lines.push_back(std::copysign(std::pow(std::abs(c), 2.0 / kRoofPower), c));
  }
  lines[kRoofCells / 2] = 0.0;
  return lines;
}

double ExactRoofFraction(double y) {
  return std::pow(std::max(0.0, 1.0 - std::pow(std::abs(y), kRoofPower)), 1.0 / kRoofPower);
}

double CornerInset(double y) {
  const double over = std::clamp((std::abs(y) - (kHalfWidth - kCorner)) / kCorner, 0.0, 1.0);
  return kCorner * (1.0 - std::sqrt(1.0 - over * over));
}

}  // namespace

bool IsSideOpening(Side side, double x, double z) {
  if (Between(z, kSill, kHead)) {
    const int windows = kWindows;
    for (int i = 0; i < windows; ++i) {
      const double low = kWindowFirst + i * kWindowPitch;
      if (Between(x, low, low + kWindowWidth)) return true;
    }
    if (side == Side::kLeft && Between(x, kDriverWindow[0], kDriverWindow[1])) return true;
  }
  return side == Side::kRight && Between(x, kEntryDoor[0], kEntryDoor[1]) &&
         Between(z, kSkirt - 1, kEntryDoorTop);
}

double SkirtBottom(double x) {
  const double d = x - kRearAxle;
  const double under = kArchRadius * kArchRadius - d * d;
  return under <= 0 ? kSkirt : std::max(kSkirt, kAxleHeight + std::sqrt(under));
}

const std::vector<double>& RoofLines() {
  static const std::vector<double> lines = MakeRoofLines();
  return lines;
}

double RoofFraction(double y) {
  // Straight between the roof's lines, so that the ends' walls meet the roof without gaps.
  const std::vector<double>& lines = RoofLines();
  const double inside = std::clamp(y, -1.0, 1.0);
  const auto next = std::clamp<std::ptrdiff_t>(
      std::upper_bound(lines.begin(), lines.end(), inside) - lines.begin(), 1, kRoofCells);
  const double low = lines[next - 1];
  const double high = lines[next];
  const double t = (inside - low) / (high - low);
  return (1 - t) * ExactRoofFraction(low) + t * ExactRoofFraction(high);
}

double EndFactor(double distance) {
  const double d = std::clamp(distance / 0.5, 0.0, 1.0);
  return kEndRise + (1.0 - kEndRise) * std::sqrt(1.0 - (1.0 - d) * (1.0 - d));
}

double RearX(double y) { return kRear + CornerInset(y); }

double FrontX(double y, double z) {
  return kFront + kFrontLean * std::clamp((kEave - z) / 0.8, 0.0, 1.0) - CornerInset(y);
}

Eigen::Vector2d SideUv(Side side, const Eigen::Vector3d& p) {
  const double u = (p.x() - kSideCanvas.left) / kSideCanvas.width;
  return {side == Side::kLeft ? 1.0 - u : u, (kSideCanvas.top - p.z()) / kSideCanvas.height};
}

Eigen::Vector2d RearUv(const Eigen::Vector3d& p) {
  return {(-p.y() - kEndCanvas.left) / kEndCanvas.width,
          (kEndCanvas.top - p.z()) / kEndCanvas.height};
}

Eigen::Vector2d FrontUv(const Eigen::Vector3d& p) {
  return {(p.y() - kEndCanvas.left) / kEndCanvas.width,
          (kEndCanvas.top - p.z()) / kEndCanvas.height};
}

Eigen::Vector2d InsideUv(Side side, const Eigen::Vector3d& p) {
  const double u = (p.x() - kInsideCanvas.left) / kInsideCanvas.width;
  return {side == Side::kLeft ? u : 1.0 - u, (kInsideCanvas.top - p.z()) / kInsideCanvas.height};
}

Eigen::Vector2d FloorUv(const Eigen::Vector3d& p) {
  return {(p.x() - kFloorCanvas.left) / kFloorCanvas.width,
          (-p.y() - kFloorCanvas.top) / kFloorCanvas.height};
}

Eigen::Isometry3d BusPose() {
  // A little roll to the left and nose-down, about the middle of the aisle.
  const Eigen::Vector3d pivot(6.0, 0.0, 0.3);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = (Eigen::AngleAxisd(0.006, Eigen::Vector3d::UnitY()) *
                   Eigen::AngleAxisd(-0.022, Eigen::Vector3d::UnitX()))
                      .toRotationMatrix();
  pose.translation() = Eigen::Vector3d(0, kBusY, 0) + pivot - pose.linear() * pivot;
  return pose;
}

}  // namespace drydock::scenes::bus
