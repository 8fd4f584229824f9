#include "sim/optics/underwater_optics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sensors_models/base/check.h"
#include "sim/optics/jerlov.h"
#include "sim/optics/optics_rows.h"

namespace drydock::sim {
namespace {

/// What a silicon sensor without colour filters makes of red, green and blue light, roughly.
constexpr UnderwaterOptics::Channels kMonochrome = {0.30F, 0.45F, 0.25F};

float SrgbToLinear(int code) {
  const double s = code / 255.0;
  return static_cast<float>(s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4));
}

Eigen::Vector3d DirectionToSun(const WaterConfig& water) {
  const double azimuth = water.sun_azimuth_deg * std::numbers::pi / 180.0;
  const double elevation = water.sun_elevation_deg * std::numbers::pi / 180.0;
  return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
          std::sin(elevation)};
}

UnderwaterOptics::Channels ToChannels(const Eigen::Array3d& values) {
  return {static_cast<float>(values[0]), static_cast<float>(values[1]),
          static_cast<float>(values[2])};
}

void StoreVector(const Eigen::Vector3d& from, float* to) {
  for (int i = 0; i < 3; ++i) to[i] = static_cast<float>(from[i]);
}

}  // namespace

UnderwaterOptics::UnderwaterOptics(const WaterConfig& water, const Pinhole& pinhole)
    : pinhole_(pinhole),
      sun_share_(static_cast<float>(water.sun_share)),
      sun_W_(DirectionToSun(water)),
      beam_attenuation_(ToChannels(BeamAttenuation(water))),
      diffuse_attenuation_(ToChannels(DiffuseAttenuation(water))),
      veil_(ToChannels(water.veil * ScatteringAlbedo(water))) {
  for (int code = 0; code < 256; ++code)
    linear_[static_cast<std::size_t>(code)] = SrgbToLinear(code);
  const auto width = static_cast<std::size_t>(pinhole.width);
  columns_.resize(width);
  for (std::size_t u = 0; u < width; ++u) {
    columns_[u] = static_cast<float>((static_cast<double>(u) - pinhole.cx) / pinhole.focal);
  }
  for (std::vector<float>* row : {&light_, &range_, &slope_}) row->resize(width);
  for (auto& row : albedo_) row.resize(width);
  for (auto& row : radiance_) row.resize(width);
}

void UnderwaterOptics::DecodeAlbedo(const cv::Mat& albedo, int row) {
  const auto* pixels = albedo.ptr<cv::Vec3b>(row);
  for (std::size_t u = 0; u < columns_.size(); ++u) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
      albedo_[channel][u] = linear_[pixels[u][static_cast<int>(channel)]];
    }
  }
}

void UnderwaterOptics::Apply(const RawImage& raw, const Pose& T_WC, ImageChannels channels,
                             cv::Mat& radiance) {
  Check(raw.depth.cols == pinhole_.width && raw.depth.rows == pinhole_.height,
        "the optics need the image of their own pinhole");
  const bool color = channels == ImageChannels::kColor;
  radiance.create(raw.depth.size(), color ? CV_32FC3 : CV_32FC1);
  const int width = raw.depth.cols, last_row = raw.depth.rows - 1;
  const Eigen::Matrix3d R_CW = T_WC.R().transpose();

  rows::RowView view{};
  view.columns = columns_.data();
  view.width = width;
  view.inverse_focal = static_cast<float>(1.0 / pinhole_.focal);
  StoreVector(R_CW.col(2), view.up_C);
  StoreVector(R_CW * sun_W_, view.sun_C);
  for (int v = 0; v <= last_row; ++v) {
    view.y = static_cast<float>((v - pinhole_.cy) / pinhole_.focal);
    const auto* depth = raw.depth.ptr<float>(v);
    DecodeAlbedo(raw.albedo, v);
    rows::RangesAndSlopes(view, depth, range_.data(), slope_.data());
    rows::Illumination(view, raw.depth.ptr<float>(std::max(v - 1, 0)), depth,
                       raw.depth.ptr<float>(std::min(v + 1, last_row)), sun_share_, light_.data());
    for (std::size_t i = 0; i < 3; ++i) {
      rows::SeeThroughWater(width, albedo_[i].data(), light_.data(), range_.data(), slope_.data(),
                            beam_attenuation_[i], diffuse_attenuation_[i], veil_[i],
                            radiance_[i].data());
    }
    auto* out = radiance.ptr<float>(v);
    for (std::size_t u = 0; u < columns_.size(); ++u) {
      if (color) {
        for (std::size_t i = 0; i < 3; ++i) out[3 * u + i] = radiance_[i][u];
      } else {
        out[u] = kMonochrome[0] * radiance_[0][u] + kMonochrome[1] * radiance_[1][u] +
                 kMonochrome[2] * radiance_[2][u];
      }
    }
  }
}

}  // namespace drydock::sim
