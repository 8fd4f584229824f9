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

int PointsAlong(int pixels, int raster) { return (pixels - 1 + raster - 1) / raster + 1; }

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
}

void LampShadows::Look(const cv::Mat& depth, const Pose& T_WC) {
  for (int j = 0; j < depth_.rows; ++j) {
    const auto* row = depth.ptr<float>(std::min(j * kRaster, pinhole_.height - 1));
    for (int i = 0; i < depth_.cols; ++i)
      depth_.at<float>(j, i) = row[std::min(i * kRaster, pinhole_.width - 1)];
  }
  wide_row_ = -1;
  for (std::size_t i = 0; i < discs_.size(); ++i) {
    LookFrom(discs_[i], T_WC, hard_);
    Soften(hard_, lit_[i]);
  }
}

void LampShadows::LookFrom(const ShiningDisc& disc, const Pose& T_WC, cv::Mat& lit) {
  std::array<Eigen::Vector3f, 9> places;
  for (int i = 0; i < 9; ++i)
    places[static_cast<std::size_t>(i)] = (T_WC * PlaceOn(disc, i)).cast<float>();
  const Eigen::Matrix3f R_WC = T_WC.R().cast<float>();
  const Eigen::Vector3f p_WC = T_WC.p().cast<float>();
  const auto per_focal = static_cast<float>(1.0 / pinhole_.focal);
  lit.setTo(1.0);
  std::vector<Eigen::Vector2i> points;
  RayFan from(3, lit.total()), to(3, lit.total());
  for (int j = 0; j < lit.rows; ++j) {
    const float y = (static_cast<float>(std::min(j * kRaster, pinhole_.height - 1)) -
                     static_cast<float>(pinhole_.cy)) *
                    per_focal;
    for (int i = 0; i < lit.cols; ++i) {
      const float z = depth_.at<float>(j, i);
      if (!std::isfinite(z)) continue;
      const float x = (static_cast<float>(std::min(i * kRaster, pinhole_.width - 1)) -
                       static_cast<float>(pinhole_.cx)) *
                      per_focal;
      const auto ray = static_cast<Eigen::Index>(points.size());
      from.col(ray) = places[static_cast<std::size_t>(3 * (j % 3) + i % 3)];
      to.col(ray) = R_WC * (z * Eigen::Vector3f(x, y, 1.F)) + p_WC;
      points.emplace_back(i, j);
    }
  }
  const auto count = static_cast<Eigen::Index>(points.size());
  const std::vector<char> hidden =
      rays_->AreHidden(from.leftCols(count), to.leftCols(count), kMargin);
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (hidden[k] != 0) lit.at<float>(points[k].y(), points[k].x()) = 0.F;
  }
}

void LampShadows::Soften(const cv::Mat& hard, cv::Mat& lit) const {
  for (int j = 0; j < hard.rows; ++j) {
    for (int i = 0; i < hard.cols; ++i) {
      const float here = depth_.at<float>(j, i);
      float sum = hard.at<float>(j, i), weight = 1.F;
      for (int y = std::max(j - 1, 0); y <= std::min(j + 1, hard.rows - 1); ++y) {
        for (int x = std::max(i - 1, 0); x <= std::min(i + 1, hard.cols - 1); ++x) {
          if (x == i && y == j) continue;
          // Not a number beyond the far plane, where it makes no difference.
          if (!(std::abs(depth_.at<float>(y, x) - here) < 0.08F * here)) continue;
          sum += hard.at<float>(y, x);
          weight += 1.F;
        }
      }
      lit.at<float>(j, i) = sum / weight;
    }
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
  WidenAround(v / kRaster);
  const auto corners = [&](std::size_t below) {
    const WideRow &lit = wide_lit_[disc][below], &of_depth = wide_depth_[below];
    return rows::RasterCorners{{lit[0].data(), lit[1].data()},
                               {of_depth[0].data(), of_depth[1].data()}};
  };
  rows::SpreadFromRaster(pinhole_.width, kRaster, static_cast<float>(v % kRaster) / kRaster, depth,
                         corners(0), corners(1), row_.data());
  return row_.data();
}

}  // namespace drydock::sim
