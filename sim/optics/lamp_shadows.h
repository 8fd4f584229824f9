// What a lamp cannot reach although the camera sees it: lamps sit beside cameras.
#pragma once

#include <array>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "sensors_models/base/pose.h"
#include "sim/render/pinhole.h"
#include "sim/world/ray_scene.h"

namespace drydock::sim {

/// A disc that shines, as one camera has it.
struct ShiningDisc {
  Eigen::Vector3d centre_C = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis_C = Eigen::Vector3d::UnitZ();  ///< Unit vector.
  double radius = 0.0;                                ///< [m]
};

/// The shares of a lamp's disc that surfaces see. One ray a point of a raster of pixels goes to one
/// of nine places of the disc, in turn, and a point has the mean of the nine around it that lie on
/// the same surface: shadows get soft edges as wide as the disc makes them, and at least as wide as
/// the raster. Pixels take what is between them.
class LampShadows {
 public:
  /// `rays` must outlive this.
  LampShadows(const RayScene& rays, const Pinhole& pinhole, std::vector<ShiningDisc> discs);

  /// Casts the rays of a view with these depths [CV_32FC1, m].
  void Look(const cv::Mat& depth, const Pose& T_WC);

  /// The shares of disc number `disc` that the pixels of row `v` see.
  const float* Row(std::size_t disc, int v, const float* depth);

 private:
  static constexpr int kRaster = 4;  ///< [px]

  void LookFrom(const ShiningDisc& disc, const Pose& T_WC);
  /// Row `j` of the raster; its points look at three places in turn.
  void LookAlongRow(const Eigen::Vector3f* places, const Pose& T_WC, int j);
  /// The mean of each point's neighbourhood, of those of its surface.
  void Soften(std::size_t disc);
  void SoftenRow(int j, float* lit) const;
  /// A raster's row at full width, of the points left (0) and right (1) of each pixel.
  using WideRow = std::array<std::vector<float>, 2>;
  void Widen(const cv::Mat& raster, int row, WideRow& wide) const;
  /// Widens what lies above and below the rows of pixels that begin at raster row `row`.
  void WidenAround(int row);

  const RayScene* rays_;
  Pinhole pinhole_;
  std::vector<ShiningDisc> discs_;
  cv::Mat depth_;             ///< At the raster's points.
  std::vector<cv::Mat> lit_;  ///< Of each disc.
  cv::Mat hard_;
  std::array<WideRow, 2> wide_depth_;             ///< Above and below the row in work,
  std::vector<std::array<WideRow, 2>> wide_lit_;  ///< and of each disc.
  int wide_row_ = -1;                             ///< The raster's row of these; -1: none yet.
  std::vector<std::vector<char>> all_lit_;  ///< Whether a row of a disc's raster has no shadow.
  std::vector<float> row_;
  std::vector<float> open_;  ///< Ones.
  RayFan from_, to_;         ///< Rays of the row in work,
  std::vector<int> column_;  ///< and their columns.
};

}  // namespace drydock::sim
