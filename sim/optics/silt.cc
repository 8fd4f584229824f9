#include "sim/optics/silt.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "sensors_models/base/check.h"
#include "sensors_models/base/random_stream.h"

namespace drydock::sim {
namespace {

/// Sigma of a puff against that of its cloud.
constexpr double kPuffSize = 0.4;

/// How fast diffuse daylight fades against a beam, see Silt::DaylightLeft.
constexpr double kDiffuseShare = 0.15;

/// Normally distributed, with mean zero and a mean square of 1 a coordinate.
std::vector<Eigen::Vector3d> ScatterPlaces(int count, RandomStream& random) {
  Eigen::Matrix3Xd places(3, count);
  for (Eigen::Index i = 0; i < places.size(); ++i) places(i) = random.Gaussian();
  const Eigen::Vector3d mean = places.rowwise().mean();
  places.colwise() -= mean;
  places *= std::sqrt(3.0 * count) / places.norm();
  std::vector<Eigen::Vector3d> result;
  for (Eigen::Index i = 0; i < count; ++i) result.emplace_back(places.col(i));
  return result;
}

}  // namespace

Silt::Silt(const std::vector<SiltCloud>& clouds, const WaterConfig& water, const Pinhole& pinhole,
           std::uint64_t seed)
    : pinhole_(pinhole),
      surface_z_(water.surface_z_m),
      painter_(pinhole, BeamAttenuation(water).cast<float>()) {
  for (const SiltCloud& cloud : clouds) {
    RandomStream random(seed, "water/silt" + std::to_string(clouds_.size()));
    clouds_.push_back({cloud, {}});
    if (cloud.puffs > 1) clouds_.back().places = ScatterPlaces(cloud.puffs, random);
  }
}

std::vector<SiltBlob> Silt::PuffsOf(const Cloud& cloud, const SiltBlob& whole) {
  if (cloud.places.empty()) return {whole};
  // Variances add: that of a puff and that of the places make that of the cloud.
  const double spread = std::sqrt(1.0 - kPuffSize * kPuffSize) * whole.sigma;
  const double part = 1.0 / static_cast<double>(cloud.places.size());
  std::vector<SiltBlob> puffs;
  puffs.reserve(cloud.places.size());
  for (const Eigen::Vector3d& place : cloud.places) {
    puffs.push_back({whole.centre_W + spread * place, kPuffSize * whole.sigma,
                     whole.attenuation * part / std::pow(kPuffSize, 3)});
  }
  return puffs;
}

void Silt::AddTo(const cv::Mat& depth, const Pose& T_WC, Time t, ImageChannels channels,
                 const LightAt& light, cv::Mat& radiance) const {
  Check(depth.cols == pinhole_.width && depth.rows == pinhole_.height &&
            radiance.size() == depth.size(),
        "silt needs the image of its own pinhole");
  std::vector<std::pair<double, DrawnSilt>> by_distance;
  for (const Cloud& cloud : clouds_) {
    if (const auto whole = BlobAt(cloud.config, t.Seconds())) {
      by_distance.push_back(
          {(whole->centre_W - T_WC.p()).norm(),
           {*whole, PuffsOf(cloud, *whole), cloud.config.albedo.array().cast<float>()}});
    }
  }
  std::stable_sort(by_distance.begin(), by_distance.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  for (const auto& [distance, silt] : by_distance)
    painter_.Draw(silt, {depth, T_WC, channels, light}, radiance);
}

double Silt::DepthBetween(const Eigen::Vector3d& from_W, const Eigen::Vector3d& to_W,
                          Time t) const {
  double sum = 0.0;
  for (const Cloud& cloud : clouds_) {
    const auto whole = BlobAt(cloud.config, t.Seconds());
    if (!whole) continue;
    for (const SiltBlob& puff : PuffsOf(cloud, *whole)) sum += OpticalDepth(puff, from_W, to_W);
  }
  return sum;
}

double Silt::DaylightLeft(const Eigen::Vector3d& p_W, Time t) const {
  const Eigen::Vector3d surface_W(p_W.x(), p_W.y(), std::max(surface_z_, p_W.z()));
  double depth = 0.0;
  for (const Cloud& cloud : clouds_) {
    if (const auto whole = BlobAt(cloud.config, t.Seconds()))
      depth += OpticalDepth(*whole, p_W, surface_W);
  }
  return std::exp(-kDiffuseShare * depth);
}

}  // namespace drydock::sim
