// Where the flakes of marine snow are.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "sensors_models/base/pose.h"
#include "sensors_models/base/random_stream.h"
#include "sensors_models/base/time.h"
#include "sim/optics/marine_snow_config.h"
#include "sim/render/pinhole.h"

namespace drydock::sim {

/// A fluffy lump, longer along one axis than across it.
struct SnowFlake {
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();  ///< [m]
  double size = 0.0;                              ///< Diameter of a disc as large as its side [m].
  double albedo = 0.0;                            ///< Against a white ball.
  Eigen::Vector3d axis_W = Eigen::Vector3d::UnitZ();  ///< Unit vector.
  double stretch = 1.0;                               ///< Length along the axis over that across.
  double opacity = 1.0;                               ///< What it hides of what is behind it.
  double lobe_cos = 0.0, lobe_sin = 0.0;              ///< As it is no ellipse: see SoftSpot.
};

/// Fills the world with flakes. A lattice of cells of 1 m drifts with the current, and what is in a
/// cell is a function of the seed and of the cell: it is the same for both eyes, now and later, and
/// nothing is remembered. The number in a cell is that of its volume, rounded up or down at random.
class SnowField {
 public:
  SnowField(const MarineSnowConfig& snow, std::uint64_t seed);

  /// The flakes that may show in the view from `T_WC` at `t`: all in front of the camera that lie
  /// in it and within range_m, and some off its edges.
  std::vector<SnowFlake> InView(const Pinhole& pinhole, const Pose& T_WC, Time t) const;

 private:
  struct Cell {
    std::int64_t x, y, z;
  };
  class View;

  std::vector<Cell> CellsIn(const View& view, const Eigen::Vector3d& drift) const;
  void AddFlakesOf(const Cell& cell, const View& view, double t_s, const Eigen::Vector3d& drift,
                   std::vector<SnowFlake>& flakes) const;

  MarineSnowConfig snow_;
  RandomStream random_;
};

}  // namespace drydock::sim
