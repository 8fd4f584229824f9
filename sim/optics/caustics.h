// The net of light that waves throw on what lies in shallow, sunlit water.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "sensors_models/base/time.h"
#include "sim/optics/caustics_config.h"
#include "sim/optics/caustics_rows.h"
#include "sim/optics/ripples.h"
#include "sim/optics/water_config.h"

namespace drydock::sim {

/// How far sunlight comes down aside of where it would below a flat surface, a metre of depth and
/// of the surface's slope: displacement = h * ShiftBySlope * slope, to first order in the slope.
/// With the angles of incidence i and refraction t below a flat surface, c = cos t and w the
/// horizontal part of the unit vector towards the sun under water, Snell's law gives
///   (cos t - cos i / n) (I / c + w w^T / c^3),
/// for a sun in the zenith 1 - 1/n. `sun_W` is that unit vector; lower than 41.4 degrees, where no
/// sun is seen under water, it is taken to be there.
Eigen::Matrix2d ShiftBySlope(const Eigen::Vector3d& sun_W);

/// Factors, of mean 1 over any level, by which Ripples focus and scatter the sun's directed light.
/// Light falls evenly on the water's surface, of which a tile is cut into a lattice of four points
/// a cell. Each point's light is refracted as above and shared out among the four cells around the
/// place where it comes down at the tile's depth; so none is lost. A Gaussian blurs the tile by
/// - the sun's disc, 0.27 degrees in radius, seen through the surface, and
/// - the water's forward scatter, with tau = share * b * r bends along the way r, each of variance
///   theta^2 at a random place of it: variance theta^2 r^2 / 3 * tau,
/// as far as the cells themselves don't. What is scattered by more keeps nothing of the pattern:
/// its contrast falls by exp(-(1 - share) b r). (b: of green light.)
///
/// Tiles are computed for depths (0.4 m^1/2 * i)^2, when they are first asked for after SetTime;
/// between these the factor is interpolated, and below the deepest, at 41 m, it is as there.
///
/// Approximations: the surface is level but for its slopes; the blur is the same in all directions;
/// light that water scatters back or aside is not focused.
class Caustics {
 public:
  Caustics(const CausticsConfig& config, const WaterConfig& water, std::uint64_t seed);

  /// The waves of `t` from now on.
  void SetTime(Time t);

  /// Multiplies `sun`, the directed light at `count` places with coordinates x, y, z [m, in W], by
  /// the factor there; above the surface it is 1.
  void Modulate(int count, const float* x, const float* y, const float* z, float* sun);
  /// The same for the surfaces that a row of pixels sees, by every other one of them.
  void ModulateRow(const rows::RowView& view, const float* depth, float* sun);

 private:
  static constexpr int kTiles = 17;            ///< The first is of the surface itself.
  static constexpr double kRootSpacing = 0.4;  // [m^1/2]
  static constexpr int kRowsOfPoints = 2 * rows::kTileCells;

  /// Points lie in each cell's middle (`side` 0) and half a cell to the right of it (1), in rows
  /// half a cell apart.
  float* ShiftsX(int row, int side);
  float* ShiftsY(int row, int side);
  void ShiftByWaves(int row);
  void Require(int tile);
  void ComputeTile(int tile);
  void Splat(float depth);
  /// `variance` in square metres.
  void Blur(double variance, double contrast, std::uint32_t* tile);

  Ripples ripples_;
  std::vector<double> phases_;        ///< Of each wave at the time, at the origin.
  double cell_;                       ///< Its side [m].
  Eigen::Matrix2d by_slope_;          ///< ShiftBySlope
  double slant_;                      ///< Way of the light a metre of depth.
  double soft_scattering_;            ///< By small angles [1/m],
  double bend_variance_;              ///< each of this variance [rad^2],
  double hard_scattering_;            ///< and by larger ones [1/m].
  std::vector<float> sines_;          ///< For each wave of waves(), along a row of cells,
  std::vector<float> cosines_;        ///< of its angle from that at the row's start.
  std::vector<float> shifts_;         ///< Of each point, in cells a metre of depth.
  std::vector<float> shares_;         ///< Four of each cell, see rows::GatherShares.
  std::vector<float> sharp_;          ///< A tile before it is blurred,
  std::vector<float> half_;           ///< and when it is along columns.
  std::vector<std::uint32_t> words_;  ///< kTiles of kTileCells^2,
  std::vector<bool> is_computed_;     ///< of which are for the time.
  rows::CausticTiles look_up_ = {};
  // Of the places in work.
  std::array<std::vector<float>, 3> place_;
  std::vector<float> factor_;
  std::vector<float> numbers_;  ///< See rows::TileNumbers.
};

}  // namespace drydock::sim
