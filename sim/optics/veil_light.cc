#include "sim/optics/veil_light.h"

#include <algorithm>
#include <cmath>

#include "sim/optics/optics_rows.h"

namespace drydock::sim {
VeilLight::VeilLight(const WaterConfig& water, const Pinhole& pinhole)
    : pinhole_(pinhole),
      attenuation_(BeamAttenuation(water)[1]),
      sun_share_(static_cast<float>(water.sun_share)) {
  const int columns = CellsIn(pinhole.width, kRaster) + 1;
  for (cv::Mat& lit : lit_) lit.create(CellsIn(pinhole.height, kRaster) + 1, columns, CV_32FC1);
  coarse_.resize(static_cast<std::size_t>(columns));
  for (auto& slice : slices_) slice.resize(static_cast<std::size_t>(columns - 1) * kRaster);
  seen_.resize(static_cast<std::size_t>(pinhole.width));
  shares_.resize(static_cast<std::size_t>(pinhole.width));
}

void VeilLight::LookAlongRow(int row, const Pose& T_WC, DaylightGrid& shadows) {
  const int columns = lit_[0].cols;
  const auto count = static_cast<std::size_t>(columns) * kSlices;
  std::array<std::vector<float>, 3> place;
  for (auto& axis : place) axis.resize(count);
  const double y = (row * kRaster - pinhole_.cy) / pinhole_.focal;
  std::size_t next = 0;
  for (int column = 0; column < columns; ++column) {
    const double x = (column * kRaster - pinhole_.cx) / pinhole_.focal;
    const Eigen::Vector3d ray_W = T_WC.q() * Eigen::Vector3d(x, y, 1.0).normalized();
    for (int i = 0; i < kSlices; ++i, ++next) {
      const double range = -std::log1p(-(i + 0.5) / kSlices) / attenuation_;
      const Eigen::Vector3d p_W = T_WC.p() + range * ray_W;
      for (std::size_t axis = 0; axis < 3; ++axis)
        place[axis][next] = static_cast<float>(p_W[static_cast<Eigen::Index>(axis)]);
    }
  }
  std::vector<float> sun(count), sky(count);
  shadows.At(static_cast<int>(count), place[0].data(), place[1].data(), place[2].data(), sun.data(),
             sky.data());
  next = 0;
  for (int column = 0; column < columns; ++column) {
    for (cv::Mat& lit : lit_) {
      lit.at<float>(row, column) = sun_share_ * sun[next] + (1.F - sun_share_) * sky[next];
      ++next;
    }
  }
}

void VeilLight::Look(const Pose& T_WC, DaylightGrid& shadows) {
  for (int row = 0; row < lit_[0].rows; ++row) LookAlongRow(row, T_WC, shadows);
}

const float* VeilLight::Row(int v, const float* range) {
  const int row = v / kRaster;
  const int cells = lit_[0].cols - 1;
  for (std::size_t i = 0; i < lit_.size(); ++i) {
    rows::Interpolate(cells + 1, lit_[i].ptr<float>(row), lit_[i].ptr<float>(row + 1),
                      static_cast<float>(v % kRaster) / kRaster, coarse_.data());
    rows::Stretch(cells, kRaster, coarse_.data(), slices_[i].data());
  }
  rows::SlicesSeen(pinhole_.width, kSlices, static_cast<float>(attenuation_), range, seen_.data());
  std::fill(shares_.begin(), shares_.end(), 0.F);
  for (std::size_t i = 0; i < slices_.size(); ++i) {
    rows::AddSlice(pinhole_.width, static_cast<int>(i), seen_.data(),
                   slices_[i == 0 ? 0 : i - 1].data(), slices_[i].data(), shares_.data());
  }
  rows::DivideBy(pinhole_.width, seen_.data(), shares_.data());
  return shares_.data();
}

}  // namespace drydock::sim
