#include "sim/render/port_warp.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace drydock::sim {
namespace {

constexpr auto kNearest = static_cast<float>(FlatPort::largest_inverse_depth());

/// Of each and its two neighbours, `spacing` elements apart.
std::vector<float> LargestOfThree(const std::vector<float>& values, int width, int height,
                                  int across, int down) {
  std::vector<float> largest(values.size());
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      float most = 0.F;
      for (int i = -1; i <= 1; ++i) {
        const int there = std::clamp(row + i * down, 0, height - 1) * width +
                          std::clamp(column + i * across, 0, width - 1);
        most = std::max(most, values[static_cast<std::size_t>(there)]);
      }
      const int here = row * width + column;
      largest[static_cast<std::size_t>(here)] = most;
    }
  }
  return largest;
}

}  // namespace

PortWarp::PortWarp(const FlatPort& port, const Pinhole& source, int width,
                   const std::vector<Eigen::Vector2d>& middles,
                   const std::vector<Eigen::Vector2d>& by_inverse_depth)
    : width_(static_cast<std::size_t>(width)),
      source_width_(source.width),
      source_height_(source.height),
      calibrated_(static_cast<float>(port.calibrated_inverse_depth())) {
  const int blocks = CellsIn(source.width, kBlock);
  for (std::size_t i = 0; i < middles.size(); ++i) {
    const double column = middles[i].x() * source.focal + source.cx;
    const double row = middles[i].y() * source.focal + source.cy;
    columns_.push_back(static_cast<float>(column));
    rows_.push_back(static_cast<float>(row));
    columns_by_inverse_.push_back(static_cast<float>(by_inverse_depth[i].x() * source.focal));
    rows_by_inverse_.push_back(static_cast<float>(by_inverse_depth[i].y() * source.focal));
    blocks_.push_back(static_cast<int>(row) / kBlock * blocks + static_cast<int>(column) / kBlock);
  }
}

PortWarp::Depths PortWarp::Survey(const cv::Mat& depth) const {
  const int width = CellsIn(depth.cols, kBlock), height = CellsIn(depth.rows, kBlock);
  Depths depths;
  depths.inverse.resize(depth.total());
  std::vector<float> highest(static_cast<std::size_t>(width) * kBlock);
  float* inverse = depths.inverse.data();
  for (int block = 0; block < height; ++block) {
    std::fill(highest.begin(), highest.end(), 0.F);
    for (int v = block * kBlock; v < std::min((block + 1) * kBlock, depth.rows); ++v) {
      const auto* row = depth.ptr<float>(v);
      for (int u = 0; u < depth.cols; ++u) inverse[u] = std::min(1.F / row[u], kNearest);
      for (int u = 0; u < depth.cols; ++u) {
        float& high = highest[static_cast<std::size_t>(u)];
        high = std::max(high, inverse[u]);
      }
      inverse += depth.cols;
    }
    for (auto first = highest.begin(); first != highest.end(); first += kBlock)
      depths.nearest.push_back(*std::max_element(first, first + kBlock));
  }
  depths.nearest =
      LargestOfThree(LargestOfThree(depths.nearest, width, height, 1, 0), width, height, 0, 1);
  return depths;
}

void PortWarp::FindPixels(std::size_t first, Row& row) const {
  const float* column0 = columns_.data() + first;
  const float* row0 = rows_.data() + first;
  const float* column_by_inverse = columns_by_inverse_.data() + first;
  const float* row_by_inverse = rows_by_inverse_.data() + first;
  const float* inverse_depth = row.inverse_depth.data();
  int* pixel = row.pixel.data();
  const float calibrated = calibrated_;
  const auto columns = static_cast<float>(source_width_);
  const auto last_row = static_cast<float>(source_height_ - 1);
  for (std::size_t u = 0; u < width_; ++u) {
    const float off = inverse_depth[u] - calibrated;
    const float column = column0[u] + off * column_by_inverse[u] + 0.5F;
    const float line = row0[u] + off * row_by_inverse[u] + 0.5F;
    // The picture has all that may be seen; the bounds are for what rounding does. Whole numbers
    // that small are exact.
    const auto whole =
        static_cast<float>(static_cast<int>(std::min(std::max(line, 0.F), last_row)));
    pixel[u] = static_cast<int>(whole * columns) +
               static_cast<int>(std::min(std::max(column, 0.F), columns - 1.F));
  }
}

void PortWarp::ShiftRow(int v, const Depths& depths, Row& row) const {
  // Surfaces that are moved apart by more than this are two [px].
  constexpr float kSilhouette = 0.5F;
  const std::size_t first = static_cast<std::size_t>(v) * width_;
  for (auto* values : {&row.across, &row.down, &row.before, &row.inverse_depth, &row.next})
    values->resize(width_);
  row.pixel.resize(width_);
  for (std::size_t u = 0; u < width_; ++u)
    row.next[u] = depths.nearest[static_cast<std::size_t>(blocks_[first + u])];
  for (int look = 0; look < 3; ++look) {
    std::swap(row.before, row.inverse_depth);
    std::swap(row.inverse_depth, row.next);
    FindPixels(first, row);
    for (std::size_t u = 0; u < width_; ++u)
      row.next[u] = depths.inverse[static_cast<std::size_t>(row.pixel[u])];
  }
  const float* column_by_inverse = columns_by_inverse_.data() + first;
  const float* row_by_inverse = rows_by_inverse_.data() + first;
  float* across = row.across.data();
  float* down = row.down.data();
  float* inverse_depth = row.inverse_depth.data();
  for (std::size_t u = 0; u < width_; ++u) {
    // What is seen must be what was looked for. If it is nearer, it hides that, and what is beside
    // it was seen the look before.
    const float by_inverse = std::abs(column_by_inverse[u]) + std::abs(row_by_inverse[u]);
    const bool is_hidden = (row.next[u] - inverse_depth[u]) * by_inverse > kSilhouette;
    inverse_depth[u] = is_hidden ? row.before[u] : inverse_depth[u];
    across[u] = (inverse_depth[u] - calibrated_) * column_by_inverse[u];
    down[u] = (inverse_depth[u] - calibrated_) * row_by_inverse[u];
  }
}

void PortWarp::SeeDepth(int v, const cv::Mat& depth, const Depths& depths, Row& row,
                        float* seen) const {
  ShiftRow(v, depths, row);
  FindPixels(static_cast<std::size_t>(v) * width_, row);
  const auto* depth_of = depth.ptr<float>();
  for (std::size_t u = 0; u < width_; ++u) seen[u] = depth_of[row.pixel[u]];
}

}  // namespace drydock::sim
