#include "sim/optics/snow_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "sim/render/frustum.h"

namespace drydock::sim {
namespace {

constexpr double kCell = 1.0;  // Side of a lattice cell [m].
constexpr double kMostStretched = 2.5;
constexpr double kMostLobed = 0.16;
constexpr double kSlowestSway = 2.0 * std::numbers::pi / 8.0;  // [rad/s]
constexpr double kFastestSway = 2.0 * std::numbers::pi / 3.0;

/// The i-th of `count` equal parts of 64 random bits, in (0, 1).
double Part(std::uint64_t bits, int i, int count) {
  const int width = 64 / count;
  const std::uint64_t part = (bits >> (i * width)) & ((std::uint64_t{1} << width) - 1);
  return (static_cast<double>(part) + 0.5) / static_cast<double>(std::uint64_t{1} << width);
}

/// Distributed as size^-3 between the limits.
double SizeOf(double uniform, const MarineSnowConfig& snow) {
  const double ratio = snow.size_min_m / snow.size_max_m;
  return snow.size_min_m / std::sqrt(1.0 - uniform * (1.0 - ratio * ratio));
}

/// Evenly distributed over the sphere.
Eigen::Vector3d AxisOf(double height, double turn) {
  const double z = 2.0 * height - 1.0, angle = 2.0 * std::numbers::pi * turn;
  const double across = std::sqrt(1.0 - z * z);
  return {across * std::cos(angle), across * std::sin(angle), z};
}

/// How far off its place in its cell a flake may show [m].
double MarginOf(const MarineSnowConfig& snow, const Pinhole& pinhole) {
  const double sway = std::numbers::sqrt2 * snow.wobble_m;
  const double half_length = 0.7 * std::sqrt(kMostStretched) * snow.size_max_m;
  const double confusion = snow.aperture_m * std::max(1.0, snow.range_m / snow.focus_m);
  return sway + half_length + confusion + 2.0 * snow.range_m / pinhole.focal;
}

}  // namespace

/// What the camera sees, and a margin.
class SnowField::View {
 public:
  View(const MarineSnowConfig& snow, const Pinhole& pinhole, const Pose& T_WC)
      : T_WC_(T_WC),
        range_(snow.range_m),
        margin_(MarginOf(snow, pinhole)),
        frustum_(T_WC, pinhole, 0.0, snow.range_m),
        low_((-0.5 - pinhole.cx) / pinhole.focal, (-0.5 - pinhole.cy) / pinhole.focal),
        high_((pinhole.width - 0.5 - pinhole.cx) / pinhole.focal,
              (pinhole.height - 0.5 - pinhole.cy) / pinhole.focal) {
    R_CW_ = T_WC.R().transpose();
    slack_ = margin_ * std::hypot(1.0, std::max(high_.maxCoeff(), -low_.minCoeff()));
  }

  /// The corners of a box around it [m, in W].
  std::array<Eigen::Vector3d, 2> Bounds() const {
    Eigen::Vector3d low = T_WC_.p(), high = T_WC_.p();
    for (const double x : {low_.x(), high_.x()}) {
      for (const double y : {low_.y(), high_.y()}) {
        const Eigen::Vector3d corner = T_WC_ * Eigen::Vector3d(range_ * x, range_ * y, range_);
        low = low.cwiseMin(corner);
        high = high.cwiseMax(corner);
      }
    }
    return {low.array() - margin_, high.array() + margin_};
  }

  bool MaySeeCell(const Eigen::Vector3d& middle_W) const {
    const Eigen::Vector3d half = Eigen::Vector3d::Constant(0.5 * kCell + margin_);
    return frustum_.FarthestDepth(CornersOfBox(middle_W, Eigen::Matrix3d::Identity(), half))
        .has_value();
  }

  bool MaySee(const Eigen::Vector3d& p_W) const {
    const Eigen::Vector3d p_C = R_CW_ * (p_W - T_WC_.p());
    const double z = p_C.z();
    const Eigen::Array2d across = p_C.head<2>();
    return z > 0.0 && p_C.norm() < range_ + margin_ && (across > z * low_ - slack_).all() &&
           (across < z * high_ + slack_).all();
  }

 private:
  Pose T_WC_;
  Eigen::Matrix3d R_CW_;
  double range_;
  double margin_;
  Frustum frustum_;
  Eigen::Array2d low_, high_;  ///< x / z and y / z of the image's edges.
  double slack_;               ///< margin_, as it counts along x or y.
};

SnowField::SnowField(const MarineSnowConfig& snow, std::uint64_t seed)
    : snow_(snow), random_(seed, "water/snow") {}

std::vector<SnowField::Cell> SnowField::CellsIn(const View& view,
                                                const Eigen::Vector3d& drift) const {
  const auto cell_at = [&](const Eigen::Vector3d& p_W, int axis) {
    return static_cast<std::int64_t>(std::floor((p_W[axis] - drift[axis]) / kCell));
  };
  const auto [low, high] = view.Bounds();
  std::vector<Cell> cells;
  for (std::int64_t z = cell_at(low, 2); z <= cell_at(high, 2); ++z) {
    for (std::int64_t y = cell_at(low, 1); y <= cell_at(high, 1); ++y) {
      for (std::int64_t x = cell_at(low, 0); x <= cell_at(high, 0); ++x) {
        const Eigen::Vector3d number(static_cast<double>(x), static_cast<double>(y),
                                     static_cast<double>(z));
        const Eigen::Vector3d middle_W = kCell * (number.array() + 0.5).matrix() + drift;
        if (view.MaySeeCell(middle_W)) cells.push_back({x, y, z});
      }
    }
  }
  return cells;
}

void SnowField::AddFlakesOf(const Cell& cell, const View& view, double t_s,
                            const Eigen::Vector3d& drift, std::vector<SnowFlake>& flakes) const {
  // 16 bits a coordinate: the pattern repeats after 65 km. The last 16 count the cell's draws.
  const auto low16 = [](std::int64_t i) { return static_cast<std::uint64_t>(i) & 0xFFFFU; };
  const std::uint64_t key = low16(cell.x) << 48 | low16(cell.y) << 32 | low16(cell.z) << 16;
  const double expected = snow_.density_m3 * kCell * kCell * kCell;
  const auto count = static_cast<std::uint64_t>(expected + random_.UniformAt(key));
  const Eigen::Vector3d corner(static_cast<double>(cell.x), static_cast<double>(cell.y),
                               static_cast<double>(cell.z));
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::uint64_t draw = key + 1 + 4 * i;
    const std::uint64_t place = random_.BitsAt(draw);
    const Eigen::Vector3d in_cell(Part(place, 0, 3), Part(place, 1, 3), Part(place, 2, 3));
    SnowFlake flake;
    flake.p_W = kCell * (corner + in_cell) + drift;
    if (!view.MaySee(flake.p_W)) continue;
    const std::uint64_t form = random_.BitsAt(draw + 1), sway = random_.BitsAt(draw + 2);
    const std::uint64_t look = random_.BitsAt(draw + 3);
    flake.size = SizeOf(Part(form, 0, 4), snow_);
    flake.albedo = snow_.albedo * (0.5 + Part(form, 1, 4));
    flake.axis_W = AxisOf(Part(form, 2, 4), Part(form, 3, 4));
    flake.stretch = 1.0 + (kMostStretched - 1.0) * Part(sway, 0, 4);
    flake.opacity = 0.4 + 0.6 * Part(look, 0, 4);
    const double lobes = kMostLobed * Part(look, 1, 4);
    const double turn = 2.0 * std::numbers::pi * Part(look, 2, 4);
    flake.lobe_cos = lobes * std::cos(turn);
    flake.lobe_sin = lobes * std::sin(turn);
    const double rate = kSlowestSway + (kFastestSway - kSlowestSway) * Part(sway, 1, 4);
    for (int axis = 0; axis < 2; ++axis) {
      const double phase = 2.0 * std::numbers::pi * Part(sway, 2 + axis, 4);
      flake.p_W[axis] += snow_.wobble_m * std::sin(rate * t_s + phase);
    }
    flakes.push_back(flake);
  }
}

std::vector<SnowFlake> SnowField::InView(const Pinhole& pinhole, const Pose& T_WC, Time t) const {
  const View view(snow_, pinhole, T_WC);
  const Eigen::Vector3d drift = t.Seconds() * snow_.current_m_s;
  std::vector<SnowFlake> flakes;
  for (const Cell& cell : CellsIn(view, drift)) AddFlakesOf(cell, view, t.Seconds(), drift, flakes);
  return flakes;
}

}  // namespace drydock::sim
