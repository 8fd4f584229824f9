#include "sim/optics/silt_config.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace drydock::sim {
namespace {

/// From 0 at `begin` to 1 after `length`, without a kink; a step where that is 0.
double Ramp(double t, double begin, double length) {
  if (length <= 0.0) return t >= begin ? 1.0 : 0.0;
  const double x = std::clamp((t - begin) / length, 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

}  // namespace

SiltCloud ReadSiltCloud(YamlReader& yaml) {
  SiltCloud cloud;
  constexpr Bounds kTime{0.0, 1e6};
  cloud.position_m = yaml.Vector3("position_m", {-1000.0, 1000.0});
  cloud.radius_m = yaml.Real("radius_m", {0.05, 100.0}, cloud.radius_m);
  cloud.attenuation_1_m = yaml.Real("attenuation_1_m", {0.0, 100.0}, cloud.attenuation_1_m);
  cloud.puffs = static_cast<int>(yaml.Integer("puffs", {1, 100}, cloud.puffs));
  cloud.from_s = yaml.Real("from_s", kTime, cloud.from_s);
  cloud.to_s = yaml.Real("to_s", kTime, cloud.to_s);
  if (cloud.to_s <= cloud.from_s) yaml.Fail("to_s", "later than from_s");
  cloud.rise_s = yaml.Real("rise_s", kTime, cloud.rise_s);
  cloud.settle_s = yaml.Real("settle_s", kTime, cloud.settle_s);
  cloud.current_m_s = yaml.Vector3("current_m_s", {-5.0, 5.0}, cloud.current_m_s);
  cloud.growth_m_s = yaml.Real("growth_m_s", {0.0, 1.0}, cloud.growth_m_s);
  cloud.albedo = yaml.Vector3("albedo", {0.0, 1.0}, cloud.albedo);
  return cloud;
}

std::optional<SiltBlob> BlobAt(const SiltCloud& cloud, double t_s) {
  const double here =
      Ramp(t_s, cloud.from_s, cloud.rise_s) * (1.0 - Ramp(t_s, cloud.to_s, cloud.settle_s));
  const double peak = here * cloud.attenuation_1_m;
  if (peak <= 0.0) return std::nullopt;
  const double age = t_s - cloud.from_s;
  const double sigma = cloud.radius_m + age * cloud.growth_m_s;
  return SiltBlob{cloud.position_m + age * cloud.current_m_s, sigma,
                  peak * std::pow(cloud.radius_m / sigma, 3)};
}

double OpticalDepth(const SiltBlob& blob, const Eigen::Vector3d& from_W,
                    const Eigen::Vector3d& to_W) {
  const double length = (to_W - from_W).norm();
  if (length == 0.0) return 0.0;
  const Eigen::Vector3d ray = (to_W - from_W) / length;
  const Eigen::Vector3d centre = blob.centre_W - from_W;
  const double closest = centre.dot(ray);  // Where the ray is nearest to the middle.
  const double scale = 1.0 / (std::numbers::sqrt2 * blob.sigma);
  const double across = (centre - closest * ray).norm() * scale;
  return blob.attenuation * std::exp(-across * across) / (scale * std::numbers::inv_sqrtpi) * 0.5 *
         (std::erf((length - closest) * scale) + std::erf(closest * scale));
}

}  // namespace drydock::sim
