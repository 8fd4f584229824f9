#include "sim/optics/underwater_optics.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <opencv2/core.hpp>

#include "sensors_models/base/check.h"
#include "sim/optics/daylight_rows.h"
#include "sim/optics/monochrome.h"

namespace drydock::sim {
namespace {

float SrgbToLinear(int code) {
  const double s = code / 255.0;
  return static_cast<float>(s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4));
}

void StoreVector(const Eigen::Vector3d& from, float* to) {
  for (int i = 0; i < 3; ++i) to[i] = static_cast<float>(from[i]);
}

}  // namespace

UnderwaterOptics::UnderwaterOptics(const WaterConfig& water, const Pinhole& pinhole,
                                   DaylightGrid* shadows, std::optional<LampLight> lamps,
                                   Caustics* caustics)
    : water_(water),
      pinhole_(pinhole),
      shadows_(shadows),
      veil_light_(water, pinhole),
      scatter_(water, pinhole.focal),
      lamps_(std::move(lamps)),
      caustics_(caustics),
      range_(pinhole.height, pinhole.width, CV_32FC1) {
  const Eigen::Array3d c = BeamAttenuation(water), kd = DiffuseAttenuation(water);
  const Eigen::Array3d veil = water.veil * ScatteringAlbedo(water);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto channel = static_cast<Eigen::Index>(i);
    channels_[i].beam_attenuation = static_cast<float>(c[channel]);
    channels_[i].diffuse_attenuation = static_cast<float>(kd[channel]);
    channels_[i].veil = static_cast<float>(veil[channel]);
  }
  for (int code = 0; code < 256; ++code)
    linear_[static_cast<std::size_t>(code)] = SrgbToLinear(code);
  const auto width = static_cast<std::size_t>(pinhole.width);
  columns_.resize(width);
  for (std::size_t u = 0; u < width; ++u) {
    columns_[u] = static_cast<float>((static_cast<double>(u) - pinhole.cx) / pinhole.focal);
  }
  for (std::vector<float>* row : {&sunward_, &upward_, &sun_, &sky_, &light_, &slope_, &open_})
    row->assign(width, 1.F);
  for (std::vector<float>* row : {&half_sun_, &half_sky_}) row->resize(width / 2 + 1);
  for (auto& row : half_place_) row.resize(width / 2 + 1);
  for (auto& row : albedo_) row.resize(width);
  for (auto& row : place_) row.resize(width);
}

void UnderwaterOptics::DecodeAlbedo(const cv::Mat& albedo, int row) {
  const auto* pixels = albedo.ptr<cv::Vec3b>(row);
  for (std::size_t u = 0; u < columns_.size(); ++u) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
      albedo_[channel][u] = linear_[pixels[u][static_cast<int>(channel)]];
    }
  }
}

rows::RowView UnderwaterOptics::ViewFrom(const Pose& T_WC) const {
  const Eigen::Matrix3d R_WC = T_WC.R();
  rows::RowView view{};
  view.columns = columns_.data();
  view.width = pinhole_.width;
  view.inverse_focal = static_cast<float>(1.0 / pinhole_.focal);
  StoreVector(R_WC.row(2), view.up_C);
  StoreVector(R_WC.transpose() * DirectionToSun(water_), view.sun_C);
  for (int i = 0; i < 3; ++i) StoreVector(R_WC.row(i), view.R_WC[i]);
  StoreVector(T_WC.p(), view.p_WC);
  return view;
}

void UnderwaterOptics::ShadeRow(const float* depth, int width) {
  // Shadows are soft: every other pixel will do.
  const int half = (width + 1) / 2;
  for (std::size_t axis = 0; axis < 3; ++axis)
    rows::TakeEveryOther(half, place_[axis].data(), half_place_[axis].data());
  shadows_->At(half, half_place_[0].data(), half_place_[1].data(), half_place_[2].data(),
               half_sun_.data(), half_sky_.data());
  rows::SpreadToPixels(width, depth, half_sun_.data(), sun_.data());
  rows::SpreadToPixels(width, depth, half_sky_.data(), sky_.data());
}

void UnderwaterOptics::LightRow(const RawImage& raw, const rows::RowView& view, int v) {
  const int last_row = raw.depth.rows - 1;
  rows::Surfaces(
      view, raw.depth.ptr<float>(std::max(v - 1, 0)), raw.depth.ptr<float>(v),
      raw.depth.ptr<float>(std::min(v + 1, last_row)), DaylightGrid::kSurfaceOffset,
      {sunward_.data(), upward_.data(), {place_[0].data(), place_[1].data(), place_[2].data()}});
  if (shadows_ != nullptr) {
    ShadeRow(raw.depth.ptr<float>(v), view.width);
  } else if (caustics_ != nullptr) {
    std::fill(sun_.begin(), sun_.end(), 1.F);
  }
  if (caustics_ != nullptr) caustics_->ModulateRow(view, raw.depth.ptr<float>(v), sun_.data());
  rows::Illuminate(view.width, sunward_.data(), upward_.data(), sun_.data(), sky_.data(),
                   static_cast<float>(water_.sun_share), light_.data());
}

void UnderwaterOptics::Clear(cv::Size size, std::size_t planes) {
  direct_.resize(planes);
  seen_.resize(planes);
  for (auto* images : {&direct_, &seen_}) {
    for (cv::Mat& image : *images) {
      image.create(size, CV_32FC1);
      image.setTo(0.0);
    }
  }
}

void UnderwaterOptics::AddDaylight(const RawImage& raw, const rows::RowView& view, int v,
                                   bool shafts, bool color) {
  const float* range = range_.ptr<float>(v);
  LightRow(raw, view, v);
  const float* lit = shafts ? veil_light_.Row(v, range) : open_.data();
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t plane = color ? i : 0;
    rows::AddSeenThroughWater(view.width, channels_[i], albedo_[i].data(), light_.data(), range,
                              slope_.data(), lit, direct_[plane].ptr<float>(v),
                              seen_[plane].ptr<float>(v));
  }
}

void UnderwaterOptics::Apply(const RawImage& raw, const Pose& T_WC, ImageChannels channels,
                             cv::Mat& radiance) {
  Check(raw.depth.cols == pinhole_.width && raw.depth.rows == pinhole_.height,
        "the optics need the image of their own pinhole");
  const bool color = channels == ImageChannels::kColor;
  const std::size_t planes = color ? 3 : 1;
  Clear(raw.depth.size(), planes);
  const Eigen::Array3d here = DaylightAt(water_, T_WC.p().z());
  Eigen::Array3f weights;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto channel = static_cast<Eigen::Index>(i);
    weights[channel] = color ? 1.F : kMonochromeWeights[i];
    channels_[i].daylight = static_cast<float>(here[channel]);
    channels_[i].weight = weights[channel];
  }
  const bool by_day = water_.daylight > 0.0;
  // Perfectly clear water has no veil to be in shadow.
  const bool shafts = by_day && shadows_ != nullptr && water_.visibility_m > 0.0;
  if (shafts) veil_light_.Look(T_WC, *shadows_);
  if (lamps_) lamps_->Look(raw.depth, T_WC);

  rows::RowView view = ViewFrom(T_WC);
  for (int v = 0; v < raw.depth.rows; ++v) {
    view.y = static_cast<float>((v - pinhole_.cy) / pinhole_.focal);
    DecodeAlbedo(raw.albedo, v);
    auto* range = range_.ptr<float>(v);
    rows::RangesAndSlopes(view, raw.depth.ptr<float>(v), range, slope_.data());
    if (by_day) AddDaylight(raw, view, v, shafts, color);
    if (!lamps_) continue;
    std::array<float*, 3> direct = {}, veil = {};
    for (std::size_t i = 0; i < 3; ++i) {
      direct[i] = direct_[color ? i : 0].ptr<float>(v);
      veil[i] = seen_[color ? i : 0].ptr<float>(v);
    }
    lamps_->AddRow(view, {v, raw.depth, range, albedo_}, weights, direct, veil);
  }
  for (std::size_t i = 0; i < planes; ++i) scatter_.AddTo(direct_[i], range_, seen_[i]);
  cv::merge(seen_, radiance);
}

Eigen::Array3f UnderwaterOptics::LightOnBall(const Eigen::Vector3d& p_W, const Pose& T_WC,
                                             double daylight_left) const {
  // Means over the disc of a matt ball against a flat card, see LightAt.
  constexpr double kSun = 0.25, kSky = 0.625, kLampBesideCamera = 2.0 / 3.0;
  Eigen::Array3d light = Eigen::Array3d::Zero();
  if (water_.daylight > 0.0) {
    const Daylight left = shadows_ != nullptr ? shadows_->At(p_W.cast<float>()) : Daylight{};
    light += daylight_left * DaylightAt(water_, p_W.z()) *
             (water_.sun_share * kSun * left.sun + (1.0 - water_.sun_share) * kSky * left.sky);
  }
  if (lamps_) light += kLampBesideCamera * lamps_->IlluminanceAt(T_WC.Inverse() * p_W);
  return light.cast<float>();
}

}  // namespace drydock::sim
