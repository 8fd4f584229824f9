// Where in a pinhole's picture each pixel of a camera behind a flat port looks.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "sim/render/flat_port.h"
#include "sim/render/pinhole.h"

namespace drydock::sim {

/// The point that a pixel sees lies at its place in the picture by the sheet alone, moved in
/// proportion to inverse depth (see FlatPort). What depth it has hangs on where the pixel looks: it
/// is looked up again and again, at first as if the nearest thing around were seen, so that what
/// is near hides what is far. At silhouettes that a port moves apart a strip comes to light which
/// the picture does not have: it gets what is beside it of the farther surface.
class PortWarp {
 public:
  /// Of a camera whose pixels look along `middles` by its sheet, in the plane z = 1, row by row,
  /// and of which `by_inverse_depth` is what FlatPort says. The picture has the view `source`.
  PortWarp(const FlatPort& port, const Pinhole& source, int width,
           const std::vector<Eigen::Vector2d>& middles,
           const std::vector<Eigen::Vector2d>& by_inverse_depth);

  /// What the picture's depth image shows, as inverse depths [1/m].
  struct Depths {
    std::vector<float> inverse;  ///< Of the picture's pixels, row by row.
    std::vector<float> nearest;  ///< Of what is nearest in and around each block.
  };
  /// `depth` is CV_32FC1, in one piece [m].
  Depths Survey(const cv::Mat& depth) const;

  /// How far from its place by the sheet each pixel of a row looks in the picture [px]; reused from
  /// row to row.
  struct Row {
    std::vector<float> across;
    std::vector<float> down;
    std::vector<float> before;         ///< Inverse depth by which it looked the time before,
    std::vector<float> inverse_depth;  ///< by which it looks,
    std::vector<float> next;           ///< and that of what it sees there.
    std::vector<int> pixel;            ///< Of the picture, which that is.
  };
  void ShiftRow(int v, const Depths& depths, Row& row) const;
  /// The depth [m] that each of them sees there.
  void SeeDepth(int v, const cv::Mat& depth, const Depths& depths, Row& row, float* seen) const;

 private:
  static constexpr int kBlock = 16;  ///< [px]

  /// Where the camera's pixels, from number `first` on, look by row.inverse_depth.
  void FindPixels(std::size_t first, Row& row) const;

  std::size_t width_;  ///< Of the camera's image.
  int source_width_;   ///< Of the picture.
  int source_height_;
  float calibrated_;  ///< Inverse depth [1/m].
  // Of the camera's pixels, row by row: places in the picture by the sheet alone [px], and how they
  // move with inverse depth [px m].
  std::vector<float> columns_;
  std::vector<float> rows_;
  std::vector<float> columns_by_inverse_;
  std::vector<float> rows_by_inverse_;
  std::vector<int> blocks_;  ///< In which these places lie.
};

}  // namespace drydock::sim
