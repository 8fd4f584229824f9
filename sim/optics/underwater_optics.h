// Light under water: from what surfaces reflect to what reaches the camera.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "sensors_models/base/pose.h"
#include "sim/optics/caustics.h"
#include "sim/optics/daylight_grid.h"
#include "sim/optics/forward_scatter.h"
#include "sim/optics/lamp_light.h"
#include "sim/optics/optics_rows.h"
#include "sim/optics/veil_light.h"
#include "sim/optics/water_config.h"
#include "sim/render/renderer.h"

namespace drydock::sim {

enum class ImageChannels {
  kMonochrome,  ///< CV_32FC1: what a sensor without colour filters makes of red, green and blue.
  kColor,       ///< CV_32FC3: red, green, blue.
};

/// Lights a raw image per pixel, in linear light, by daylight that fades with depth, and sends it
/// through the water.
///
/// For each channel, with r the range along the ray, s the ray's upward slope, n the surface's
/// normal, rho its reflectance, E the daylight at the camera's depth, and the shares S (sun) and A
/// (sky) that shadows leave of it:
///   J = rho exp(Kd s r) (sun_share max(0, n . sun) S + (1 - sun_share) (5 + 3 n_z) / 8 A)
///   I = E (J exp(-c r) + B (1 - exp(-beta r)) L)
/// The first term is blurred by ForwardScatter. Daylight scattered once towards the camera along
/// the ray gives the veil its own coefficient, beta = c - Kd s (it is brighter upwards), and its
/// radiance in deep water, B = veil (b/c) c / beta. beta is kept above 0.3 c: the surface is never
/// far. L is the share of that water which is not in shadow (VeilLight). Radiance 1 is what a white
/// card sends out that lies flat under the full sun of the surface. LampLight adds to both terms;
/// Caustics multiply the sun's.
class UnderwaterOptics {
 public:
  /// `shadows` and `caustics`, if not null, must outlive the optics and may be shared by the optics
  /// of several cameras that work one after the other.
  UnderwaterOptics(const WaterConfig& water, const Pinhole& pinhole, DaylightGrid* shadows,
                   std::optional<LampLight> lamps = std::nullopt, Caustics* caustics = nullptr);

  /// `raw` is of this optics' pinhole, taken at `T_WC`. `radiance` is reused if it fits.
  void Apply(const RawImage& raw, const Pose& T_WC, ImageChannels channels, cv::Mat& radiance);

  /// The light on what floats at `p_W` [m, in W] before the camera at `T_WC`: LightAt's value there
  /// with this share of the daylight.
  Eigen::Array3f LightOnBall(const Eigen::Vector3d& p_W, const Pose& T_WC,
                             double daylight_left) const;

 private:
  void DecodeAlbedo(const cv::Mat& albedo, int row);
  rows::RowView ViewFrom(const Pose& T_WC) const;
  /// What shadows leave at the places in work, which belong to a row of these depths.
  void ShadeRow(const float* depth, int width);
  /// Gets the images of `planes` channels ready for sums.
  void Clear(cv::Size size, std::size_t planes);
  /// Adds daylight, as channels_ has it, to row `v`.
  void AddDaylight(const RawImage& raw, const rows::RowView& view, int v, bool shafts, bool color);
  /// Light on the surfaces of row `v`.
  void LightRow(const RawImage& raw, const rows::RowView& view, int v);

  WaterConfig water_;
  Pinhole pinhole_;
  DaylightGrid* shadows_;
  VeilLight veil_light_;
  ForwardScatter scatter_;
  std::optional<LampLight> lamps_;
  Caustics* caustics_;
  std::array<rows::ChannelWater, 3> channels_ = {};
  std::array<float, 256> linear_ = {};  ///< sRGB code to linear light.

  // Rows in work, kept from call to call.
  std::vector<float> columns_;                ///< (u - cx) / focal
  std::array<std::vector<float>, 3> albedo_;  ///< Linear.
  std::array<std::vector<float>, 3> place_;
  std::array<std::vector<float>, 3> half_place_;  ///< Every other of these,
  std::vector<float> half_sun_, half_sky_;        ///< and its light.
  std::vector<float> sunward_, upward_, sun_, sky_, light_, slope_;
  std::vector<float> open_;  ///< Ones: nothing is in shadow.
  // Images in work: one plane for each channel that is delivered.
  cv::Mat range_;
  std::vector<cv::Mat> direct_;
  std::vector<cv::Mat> seen_;
};

}  // namespace drydock::sim
