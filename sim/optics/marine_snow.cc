#include "sim/optics/marine_snow.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "sensors_models/base/check.h"
#include "sim/optics/monochrome.h"

namespace drydock::sim {
namespace {

constexpr double kFade = 0.2;       // Share of the range over which flakes fade away.
constexpr double kPixelEdge = 2.5;  // What pixel and lens make of a sharp edge [px].
constexpr double kFluff = 0.7;      // Width of a flake's own edge against its size.

}  // namespace

MarineSnow::MarineSnow(const MarineSnowConfig& snow, const WaterConfig& water,
                       const Pinhole& pinhole, std::uint64_t seed)
    : snow_(snow),
      pinhole_(pinhole),
      beam_attenuation_(BeamAttenuation(water).cast<float>()),
      field_(snow, seed) {}

SoftSpot MarineSnow::SpotOf(const SnowFlake& flake, const Eigen::Vector3d& p_C,
                            const Pose& T_CW) const {
  const double x = p_C.x() / p_C.z(), y = p_C.y() / p_C.z();
  const double range = p_C.norm(), scale = pinhole_.focal / p_C.z();
  SoftSpot spot;
  spot.u = pinhole_.cx + pinhole_.focal * x;
  spot.v = pinhole_.cy + pinhole_.focal * y;
  spot.depth = p_C.z();
  // The axis in the image; its length is the sine of the angle between axis and line of sight.
  const Eigen::Vector3d axis_C = T_CW.q() * flake.axis_W;
  const Eigen::Vector2d axis = axis_C.head<2>() - axis_C.z() * Eigen::Vector2d(x, y);
  const double sine = axis.norm();
  if (sine > 1e-9) {
    spot.along_u = axis.x() / sine;
    spot.along_v = axis.y() / sine;
  }
  const double side = std::min(1.0, sine * sine);
  const double stretch2 = flake.stretch * flake.stretch;
  spot.half_across = 0.5 * scale * flake.size / std::sqrt(flake.stretch);
  spot.half_along = spot.half_across * std::sqrt(1.0 + (stretch2 - 1.0) * side);
  const double confusion =
      pinhole_.focal * snow_.aperture_m * std::abs(1.0 / range - 1.0 / snow_.focus_m);
  spot.edge = std::hypot(kPixelEdge, confusion, kFluff * scale * flake.size);
  spot.lobe_cos = flake.lobe_cos;
  spot.lobe_sin = flake.lobe_sin;
  spot.cover = flake.opacity * std::clamp((1.0 - range / snow_.range_m) / kFade, 0.0, 1.0);
  return spot;
}

SpotLight MarineSnow::LightOf(const SnowFlake& flake, double range, ImageChannels channels,
                              const LightAt& light) const {
  const Eigen::Array3f share = (-beam_attenuation_ * static_cast<float>(range)).exp();
  const Eigen::Array3f source = static_cast<float>(flake.albedo) * share * light(flake.p_W);
  SpotLight spot;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto channel = static_cast<Eigen::Index>(i);
    if (channels == ImageChannels::kColor) {
      spot.source[i] = source[channel];
      spot.share[i] = share[channel];
    } else {
      spot.source[0] += kMonochromeWeights[i] * source[channel];
      spot.share[0] += kMonochromeWeights[i] * share[channel];
    }
  }
  return spot;
}

void MarineSnow::AddTo(const cv::Mat& depth, const Pose& T_WC, Time t, ImageChannels channels,
                       const LightAt& light, cv::Mat& radiance, const Silt* silt) const {
  Check(depth.cols == pinhole_.width && depth.rows == pinhole_.height &&
            radiance.size() == depth.size(),
        "snow needs the image of its own pinhole");
  if (snow_.density_m3 == 0.0) return;
  struct Seen {
    SnowFlake flake;
    Eigen::Vector3d p_C;
    double range;
  };
  const Pose T_CW = T_WC.Inverse();
  std::vector<Seen> seen;
  for (const SnowFlake& flake : field_.InView(pinhole_, T_WC, t)) {
    const Eigen::Vector3d p_C = T_CW * flake.p_W;
    const double range = p_C.norm();
    if (p_C.z() > kNearest && range < snow_.range_m) seen.push_back({flake, p_C, range});
  }
  std::stable_sort(seen.begin(), seen.end(),
                   [](const Seen& a, const Seen& b) { return a.range > b.range; });
  SpotPainter painter(depth, radiance);
  for (const Seen& each : seen) {
    SoftSpot spot = SpotOf(each.flake, each.p_C, T_CW);
    if (silt != nullptr) spot.cover *= std::exp(-silt->DepthBetween(T_WC.p(), each.flake.p_W, t));
    painter.Draw(spot, LightOf(each.flake, each.range, channels, light));
  }
}

}  // namespace drydock::sim
