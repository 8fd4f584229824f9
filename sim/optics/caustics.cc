#include "sim/optics/caustics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace drydock::sim {
namespace {

constexpr int kCells = rows::kTileCells;
constexpr std::size_t kTileSize = std::size_t{kCells} * kCells;
constexpr double kIndex = 1.333;        ///< Of water.
constexpr double kSunRadiusDeg = 0.27;  ///< In air.
constexpr int kPointsACell = 4;
/// What sharing out among four cells and interpolating between four do [cells^2].
constexpr double kVarianceOfCells = 1.0 / 3.0;
constexpr int kFarthestReach = 40;  ///< Of the blur [cells].

std::size_t At(int row, int column = 0) {
  return static_cast<std::size_t>(row) * kCells + static_cast<std::size_t>(column);
}

}  // namespace

Eigen::Matrix2d ShiftBySlope(const Eigen::Vector3d& sun_W) {
  const Eigen::Vector2d level = sun_W.head<2>();
  const Eigen::Vector2d w = level * std::min(1.0, 1.0 / (kIndex * std::max(level.norm(), 1e-9)));
  const double cos_t = std::sqrt(1.0 - w.squaredNorm());
  const double cos_i = std::sqrt(std::max(0.0, 1.0 - kIndex * kIndex * w.squaredNorm()));
  return (cos_t - cos_i / kIndex) *
         (Eigen::Matrix2d::Identity() / cos_t + w * w.transpose() / std::pow(cos_t, 3));
}

Caustics::Caustics(const CausticsConfig& config, const WaterConfig& water, std::uint64_t seed)
    : ripples_(config, seed),
      cell_(config.tile_m / kCells),
      by_slope_(ShiftBySlope(DirectionToSun(water))),
      slant_(1.0 / DirectionToSun(water).z()),
      shifts_(4 * kRowsOfPoints * std::size_t{kCells}),
      shares_(4 * kTileSize),
      sharp_(kTileSize),
      half_(kTileSize),
      words_(kTiles * kTileSize) {
  const double scattering = (ScatteringAlbedo(water) * BeamAttenuation(water))[1];
  const double bend = water.forward_scatter_deg * std::numbers::pi / 180.0;
  soft_scattering_ = water.forward_scatter * scattering;
  hard_scattering_ = scattering - soft_scattering_;
  bend_variance_ = bend * bend;
  for (const Ripples::Wave& wave : ripples_.waves()) {
    for (int i = 0; i < kCells; ++i) {
      const double angle = 2.0 * std::numbers::pi * (wave.nx * i % kCells) / kCells;
      sines_.push_back(static_cast<float>(std::sin(angle)));
      cosines_.push_back(static_cast<float>(std::cos(angle)));
    }
  }
  const Eigen::Vector3d sun = DirectionToSun(water);
  look_up_.surface_z = static_cast<float>(water.surface_z_m);
  look_up_.per_root_metre = static_cast<float>(1.0 / kRootSpacing);
  look_up_.last = kTiles - 1;
  for (int i = 0; i < 2; ++i) look_up_.toward_sun[i] = static_cast<float>(sun[i] / sun.z());
  look_up_.cells_per_metre = static_cast<float>(1.0 / cell_);
  std::fill_n(sharp_.begin(), kCells, 1.F);
  for (int row = 0; row < kCells; ++row) rows::Pack(sharp_.data(), words_.data() + At(row));
  SetTime(Time{});
}

float* Caustics::ShiftsX(int row, int side) { return shifts_.data() + At(4 * row + 2 * side); }
float* Caustics::ShiftsY(int row, int side) { return shifts_.data() + At(4 * row + 2 * side + 1); }

void Caustics::ShiftByWaves(int row) {
  float* x = ShiftsX(row, 0);
  float* y = ShiftsY(row, 0);
  std::fill_n(x, kCells, 0.F);
  std::fill_n(y, kCells, 0.F);
  const double turn = std::numbers::pi / kCells * row;
  std::size_t start = 0;
  for (const Ripples::Wave& wave : ripples_.waves()) {
    const double angle = phases_[start / kCells] + turn * wave.ny;
    const Eigen::Vector2d shift = by_slope_ * wave.k.normalized() * (-wave.steepness / cell_);
    rows::AddWave({sines_.data() + start, cosines_.data() + start,
                   static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)),
                   static_cast<float>(shift.x()), static_cast<float>(shift.y())},
                  x, y);
    start += kCells;
  }
}

void Caustics::SetTime(Time t) {
  phases_.clear();
  for (const Ripples::Wave& wave : ripples_.waves()) phases_.push_back(Ripples::PhaseAt(wave, t));
  for (int row = 0; row < kRowsOfPoints; row += 2) ShiftByWaves(row);
  for (int row = 1; row < kRowsOfPoints; row += 2) {
    const int below = (row + 1) % kRowsOfPoints;
    rows::MeanOfNeighbours(ShiftsX(row - 1, 0), ShiftsX(below, 0), 0, ShiftsX(row, 0));
    rows::MeanOfNeighbours(ShiftsY(row - 1, 0), ShiftsY(below, 0), 0, ShiftsY(row, 0));
  }
  for (int row = 0; row < kRowsOfPoints; ++row) {
    rows::MeanOfNeighbours(ShiftsX(row, 0), ShiftsX(row, 0), 1, ShiftsX(row, 1));
    rows::MeanOfNeighbours(ShiftsY(row, 0), ShiftsY(row, 0), 1, ShiftsY(row, 1));
  }
  is_computed_.assign(kTiles, false);
  is_computed_[0] = true;  // That of the surface is 1 for ever.
}

void Caustics::Splat(float depth) {
  std::fill(shares_.begin(), shares_.end(), 0.F);
  rows::Landing landing = {};
  for (int row = 0; row < kRowsOfPoints; ++row) {
    for (int side = 0; side < 2; ++side) {
      rows::Land(0.5F * static_cast<float>(side), 0.5F * static_cast<float>(row), depth,
                 ShiftsX(row, side), ShiftsY(row, side), landing);
      rows::ShareOut(landing, shares_.data());
    }
  }
}

void Caustics::Blur(double variance, double contrast, std::uint32_t* tile) {
  const double in_cells = std::max(0.0, variance / (cell_ * cell_) - kVarianceOfCells);
  const int reach =
      static_cast<int>(std::min(std::ceil(3.0 * std::sqrt(in_cells)), double{kFarthestReach}));
  std::array<float, kFarthestReach + 1> weights = {1.F};
  double sum = 1.0;
  for (int i = 1; i <= reach; ++i) {
    const double weight = std::exp(-0.5 * i * i / in_cells);
    weights[static_cast<std::size_t>(i)] = static_cast<float>(weight);
    sum += 2.0 * weight;
  }
  for (float& weight : weights) weight = static_cast<float>(weight / sum);
  std::array<const float*, 2 * kFarthestReach + 1> around = {};
  const float** middle = around.data() + kFarthestReach;
  for (int row = 0; row < kCells; ++row) {
    for (int i = -reach; i <= reach; ++i)
      middle[i] = sharp_.data() + At((row + i + kCells) % kCells);
    rows::BlurDown(reach, weights.data(), middle, half_.data() + At(row));
  }
  for (float& weight : weights) weight *= static_cast<float>(contrast);
  for (int row = 0; row < kCells; ++row) {
    rows::BlurAcross(reach, weights.data(), static_cast<float>(1.0 - contrast),
                     half_.data() + At(row), sharp_.data());
    rows::Pack(sharp_.data(), tile + At(row));
  }
}

void Caustics::Require(int tile) {
  if (!is_computed_[static_cast<std::size_t>(tile)]) ComputeTile(tile);
}

void Caustics::ComputeTile(int tile) {
  const double depth = std::pow(kRootSpacing * tile, 2);
  Splat(static_cast<float>(depth));
  for (int row = 0; row < kCells; ++row) {
    const float* above = shares_.data() + 4 * At((row + kCells - 1) % kCells);
    rows::GatherShares(shares_.data() + 4 * At(row), above, 1.F / kPointsACell,
                       sharp_.data() + At(row));
  }
  const double way = slant_ * depth;
  const double sun_radius = std::tan(kSunRadiusDeg / kIndex * std::numbers::pi / 180.0);
  const double bends = soft_scattering_ * way;
  // Of a disc along each axis; what is round across the light is longer by the slant in one
  // direction on a level plane.
  const double variance =
      slant_ * way * way * (sun_radius * sun_radius / 4.0 + bend_variance_ * bends / 3.0);
  Blur(variance, std::exp(-hard_scattering_ * way),
       words_.data() + static_cast<std::size_t>(tile) * kTileSize);
  is_computed_[static_cast<std::size_t>(tile)] = true;
}

void Caustics::Modulate(int count, const float* x, const float* y, const float* z, float* sun) {
  look_up_.words = words_.data();
  numbers_.resize(static_cast<std::size_t>(count));
  rows::TileNumbers(look_up_, count, z, numbers_.data());
  int last = 0;
  for (const float number : numbers_) {
    // What lies in the surface or above it needs that tile only.
    const int deeper = number > 0.F ? std::min(static_cast<int>(number), kTiles - 2) + 1 : 0;
    if (deeper == last) continue;
    last = deeper;
    Require(std::max(deeper - 1, 0));
    Require(deeper);
  }
  rows::Modulate(look_up_, count, x, y, z, numbers_.data(), sun);
}

void Caustics::ModulateRow(const rows::RowView& view, const float* depth, float* sun) {
  const int half = (view.width + 1) / 2;
  for (auto& row : place_) row.resize(static_cast<std::size_t>(half));
  factor_.assign(static_cast<std::size_t>(half), 1.F);
  const auto [x, y, z] = std::array{place_[0].data(), place_[1].data(), place_[2].data()};
  rows::PlacesSeen(view, half, depth, x, y, z);
  Modulate(half, x, y, z, factor_.data());
  rows::MultiplyByEveryOther(view.width, depth, factor_.data(), sun);
}

}  // namespace drydock::sim
