#include "sim/optics/underwater_optics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/optics/jerlov.h"

namespace drydock::sim {
namespace {

float SrgbToLinear(int code) {
  const double s = code / 255.0;
  return static_cast<float>(s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4));
}

/// Share of the diffuse daylight that reaches a surface whose normal's upward part is `up`: all of
/// it from above, a quarter of it (scattered back by water and ground) from below.
float SkyShare(float up) { return 0.625F + 0.375F * up; }

/// The difference of depth across a pixel towards the nearer of its two neighbours, so that the
/// normal does not mix two surfaces at a silhouette.
float NearerDifference(float before, float here, float after) {
  const float back = here - before;
  const float ahead = after - here;
  return std::abs(back) < std::abs(ahead) ? back : ahead;
}

}  // namespace

UnderwaterOptics::UnderwaterOptics(const WaterConfig& water, const Pinhole& pinhole)
    : pinhole_(pinhole), surface_z_(water.surface_z_m), sun_share_(water.sun_share) {
  const double azimuth = water.sun_azimuth_deg * std::numbers::pi / 180.0;
  const double elevation = water.sun_elevation_deg * std::numbers::pi / 180.0;
  sun_W_ = Eigen::Vector3d(std::cos(elevation) * std::cos(azimuth),
                           std::cos(elevation) * std::sin(azimuth), std::sin(elevation))
               .cast<float>();
  const JerlovType& type = *FindJerlovType(water.jerlov_type);
  const bool clear = water.visibility_m == 0.0;
  for (int channel = 0; channel < 3; ++channel) {
    const auto i = static_cast<std::size_t>(channel);
    beam_attenuation_[i] = static_cast<float>(BeamAttenuation(water)[channel]);
    diffuse_attenuation_[i] = clear ? 0.F : static_cast<float>(type.DiffuseAttenuation()[channel]);
    veil_[i] =
        static_cast<float>(water.veil * type.scattering[channel] / type.BeamAttenuation()[channel]);
  }
  for (int code = 0; code < 256; ++code)
    linear_[static_cast<std::size_t>(code)] = SrgbToLinear(code);
}

void UnderwaterOptics::ComputeNormals(const cv::Mat& depth, const Eigen::Matrix3d& R_WC) {
  normals_.create(depth.size(), CV_32FC3);
  const Eigen::Matrix3f R = R_WC.cast<float>();
  const auto inverse_focal = static_cast<float>(1.0 / pinhole_.focal);
  const int width = depth.cols, height = depth.rows;
  for (int v = 0; v < height; ++v) {
    const auto* above = depth.ptr<float>(std::max(v - 1, 0));
    const auto* here = depth.ptr<float>(v);
    const auto* below = depth.ptr<float>(std::min(v + 1, height - 1));
    auto* out = normals_.ptr<cv::Vec3f>(v);
    const auto y = static_cast<float>((v - pinhole_.cy) / pinhole_.focal);
    for (int u = 0; u < width; ++u) {
      const auto x = static_cast<float>((u - pinhole_.cx) / pinhole_.focal);
      const float z = here[u];
      const float across =
          NearerDifference(here[std::max(u - 1, 0)], z, here[std::min(u + 1, width - 1)]);
      const float down = NearerDifference(above[u], z, below[u]);
      // The surface is P(u, v) = z (x, y, 1); its normal is dP/dv x dP/du, towards the camera.
      const float step = z * inverse_focal;
      const Eigen::Vector3f n_C(across, down, -(step + x * across + y * down));
      const float length = std::sqrt(n_C.squaredNorm());
      const Eigen::Vector3f n = length > 0.F && std::isfinite(length)
                                    ? Eigen::Vector3f(R * n_C / length)
                                    : Eigen::Vector3f(0.F, 0.F, 1.F);
      out[u] = {n.x(), n.y(), n.z()};
    }
  }
}

void UnderwaterOptics::Apply(const RawImage& raw, const Pose& T_WC, cv::Mat& radiance) {
  const Eigen::Matrix3d R_WC = T_WC.R();
  ComputeNormals(raw.depth, R_WC);
  radiance.create(raw.depth.size(), CV_32FC3);
  const Eigen::Matrix3f R = R_WC.cast<float>();
  const auto sun = static_cast<float>(sun_share_);
  for (int v = 0; v < raw.depth.rows; ++v) {
    const auto* albedo = raw.albedo.ptr<cv::Vec3b>(v);
    const auto* depth = raw.depth.ptr<float>(v);
    const auto* normals = normals_.ptr<cv::Vec3f>(v);
    auto* out = radiance.ptr<cv::Vec3f>(v);
    const auto y = static_cast<float>((v - pinhole_.cy) / pinhole_.focal);
    for (int u = 0; u < raw.depth.cols; ++u) {
      const auto x = static_cast<float>((u - pinhole_.cx) / pinhole_.focal);
      const float ray_length = std::sqrt(1.F + x * x + y * y);
      const float range = depth[u] * ray_length;
      const float rise = (R(2, 0) * x + R(2, 1) * y + R(2, 2)) / ray_length;
      const bool hit = std::isfinite(range);
      const float up = normals[u][2];
      const float facing_sun =
          normals[u][0] * sun_W_.x() + normals[u][1] * sun_W_.y() + normals[u][2] * sun_W_.z();
      const float light = sun * std::max(0.F, facing_sun) + (1.F - sun) * SkyShare(up);
      for (int channel = 0; channel < 3; ++channel) {
        const auto i = static_cast<std::size_t>(channel);
        const float c = beam_attenuation_[i];
        const float kd = diffuse_attenuation_[i];
        // Upwards the integral over the brightening water would diverge past the surface: bound it.
        const float beta = std::max(c - kd * rise, 0.3F * c);
        const float veil = beta > 0.F ? veil_[i] * c / beta : 0.F;
        float value = veil;
        if (hit) {
          // Daylight at the surface point relative to that at the camera.
          const float daylight = std::exp(kd * rise * range);
          const float lit = linear_[albedo[u][channel]] * daylight * light;
          value = lit * std::exp(-c * range) + veil * (1.F - std::exp(-beta * range));
        }
        out[u][channel] = value;
      }
    }
  }
}

}  // namespace drydock::sim
