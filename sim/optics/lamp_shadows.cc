#include "sim/optics/lamp_shadows.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "sim/optics/lamp_rows.h"

namespace drydock::sim {
namespace {

/// Surfaces hide nothing within this of themselves [m].
constexpr float kMargin = 0.02F;

/// The middle of a disc and eight places around it that stand for equal parts of it.
Eigen::Vector3d PlaceOn(const ShiningDisc& disc, int place) {
  if (place == 0) return disc.centre_C;
  const Eigen::Vector3d side = disc.axis_C.unitOrthogonal();
  const Eigen::Vector3d other = disc.axis_C.cross(side);
  const double angle = 2.0 * std::numbers::pi * place / 8.0;
  return disc.centre_C + 0.75 * disc.radius * (std::cos(angle) * side + std::sin(angle) * other);
}

int PointsAlong(int pixels, int raster) { return CellsIn(pixels - 1, raster) + 1; }

}  // namespace

LampShadows::LampShadows(const RayScene& rays, const Pinhole& pinhole,
                         std::vector<ShiningDisc> discs)
    : rays_(&rays),
      pinhole_(pinhole),
      discs_(std::move(discs)),
      lit_(discs_.size()),
      row_(static_cast<std::size_t>(pinhole.width)) {
  const int rows = PointsAlong(pinhole.height, kRaster);
  const int columns = PointsAlong(pinhole.width, kRaster);
  for (cv::Mat* raster : {&depth_, &hard_}) raster->create(rows, columns, CV_32FC1);
  for (cv::Mat& lit : lit_) lit.create(rows, columns, CV_32FC1);
  for (WideRow& row : wide_depth_) {
    for (auto& wide : row) wide.resize(static_cast<std::size_t>(columns) * kRaster);
  }
  wide_lit_.assign(discs_.size(), wide_depth_);
  all_lit_.assign(discs_.size(), std::vector<char>(static_cast<std::size_t>(rows), 1));
  from_.resize(3, columns);
  to_.resize(3, columns);
  column_.resize(static_cast<std::size_t>(columns));
  open_.assign(row_.size(), 1.F);
}

void LampShadows::Look(const cv::Mat& depth, const Pose& T_WC) {
  for (int j = 0; j < depth_.rows; ++j) {
    const auto* row = depth.ptr<float>(std::min(j * kRaster, pinhole_.height - 1));
    for (int i = 0; i < depth_.cols; ++i)
      depth_.at<float>(j, i) = row[std::min(i * kRaster, pinhole_.width - 1)];
  }
  wide_row_ = -1;
  for (std::size_t i = 0; i < discs_.size(); ++i) {
    LookFrom(discs_[i], T_WC);
    Soften(i);
  }
}

void LampShadows::LookFrom(const ShiningDisc& disc, const Pose& T_WC) {
  std::array<Eigen::Vector3f, 9> places;
  for (int i = 0; i < 9; ++i)
    places[static_cast<std::size_t>(i)] = (T_WC * PlaceOn(disc, i)).cast<float>();
  for (int j = 0; j < hard_.rows; ++j) LookAlongRow(places.data() + 3 * (j % 3), T_WC, j);
}

void LampShadows::LookAlongRow(const Eigen::Vector3f* places, const Pose& T_WC, int j) {
  const Eigen::Matrix3f R_WC = T_WC.R().cast<float>();
  const Eigen::Vector3f p_WC = T_WC.p().cast<float>();
  const auto per_focal = static_cast<float>(1.0 / pinhole_.focal);
  const auto to_plane = [per_focal](int pixel, double centre) {
    return (static_cast<float>(pixel) - static_cast<float>(centre)) * per_focal;
  };
  const float y = to_plane(std::min(j * kRaster, pinhole_.height - 1), pinhole_.cy);
  auto* hard = hard_.ptr<float>(j);
  Eigen::Index count = 0;
  for (int i = 0; i < hard_.cols; ++i) {
    hard[i] = 1.F;
    const float z = depth_.at<float>(j, i);
    if (!std::isfinite(z)) continue;
    const float x = to_plane(std::min(i * kRaster, pinhole_.width - 1), pinhole_.cx);
    from_.col(count) = places[i % 3];
    to_.col(count) = R_WC * (z * Eigen::Vector3f(x, y, 1.F)) + p_WC;
    column_[static_cast<std::size_t>(count++)] = i;
  }
  if (count == 0) return;
  const std::vector<char> hidden =
      rays_->AreHidden(from_.leftCols(count), to_.leftCols(count), kMargin);
  for (std::size_t k = 0; k < hidden.size(); ++k) {
    if (hidden[k] != 0) hard[column_[k]] = 0.F;
  }
}

void LampShadows::Soften(std::size_t disc) {
  cv::Mat& lit = lit_[disc];
  for (int j = 0; j < hard_.rows; ++j) {
    const int first = std::max(j - 1, 0), last = std::min(j + 1, hard_.rows - 1);
    bool all_lit = true;
    for (int y = first; y <= last; ++y) {
      const auto* row = hard_.ptr<float>(y);
      all_lit = all_lit && std::all_of(row, row + hard_.cols, [](float f) { return f == 1.F; });
    }
    all_lit_[disc][static_cast<std::size_t>(j)] = all_lit ? 1 : 0;
    if (all_lit) {
      lit.row(j).setTo(1.0);
    } else {
      SoftenRow(j, lit.ptr<float>(j));
    }
  }
}

void LampShadows::SoftenRow(int j, float* lit) const {
  for (int i = 0; i < hard_.cols; ++i) {
    const float here = depth_.at<float>(j, i);
    float sum = hard_.at<float>(j, i), weight = 1.F;
    for (int y = std::max(j - 1, 0); y <= std::min(j + 1, hard_.rows - 1); ++y) {
      for (int x = std::max(i - 1, 0); x <= std::min(i + 1, hard_.cols - 1); ++x) {
        if (x == i && y == j) continue;
        // Not a number beyond the far plane, where it makes no difference.
        if (!(std::abs(depth_.at<float>(y, x) - here) < 0.08F * here)) continue;
        sum += hard_.at<float>(y, x);
        weight += 1.F;
      }
    }
    lit[i] = sum / weight;
  }
}

void LampShadows::Widen(const cv::Mat& raster, int row, WideRow& wide) const {
  const auto* values = raster.ptr<float>(std::min(row, raster.rows - 1));
  for (int i = 0; i < raster.cols; ++i) {
    const auto first = static_cast<std::ptrdiff_t>(i) * kRaster;
    std::fill_n(wide[0].begin() + first, kRaster, values[i]);
    std::fill_n(wide[1].begin() + first, kRaster, values[std::min(i + 1, raster.cols - 1)]);
  }
}

void LampShadows::WidenAround(int row) {
  if (row == wide_row_) return;
  wide_row_ = row;
  for (std::size_t below = 0; below < 2; ++below) {
    const int there = row + static_cast<int>(below);
    Widen(depth_, there, wide_depth_[below]);
    for (std::size_t i = 0; i < discs_.size(); ++i) Widen(lit_[i], there, wide_lit_[i][below]);
  }
}

const float* LampShadows::Row(std::size_t disc, int v, const float* depth) {
  const int row = v / kRaster;
  const std::vector<char>& all_lit = all_lit_[disc];
  const auto below = std::min(static_cast<std::size_t>(row) + 1, all_lit.size() - 1);
  if (all_lit[static_cast<std::size_t>(row)] != 0 && all_lit[below] != 0) return open_.data();
  WidenAround(row);
  const auto corners = [&](std::size_t which) {
    const WideRow &lit = wide_lit_[disc][which], &of_depth = wide_depth_[which];
    return rows::RasterCorners{{lit[0].data(), lit[1].data()},
                               {of_depth[0].data(), of_depth[1].data()}};
  };
  rows::SpreadFromRaster(pinhole_.width, kRaster, static_cast<float>(v % kRaster) / kRaster, depth,
                         corners(0), corners(1), row_.data());
  return row_.data();
}

}  // namespace drydock::sim
