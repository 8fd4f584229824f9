#include "estimator/svin2/sonar/sonar_patch.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace drydock::svin2 {
namespace {

struct Plane {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double roughness = 0.0;  // RMS distance from the plane [m].
  double spread = 0.0;     // RMS extent in the narrower direction within it [m].
};

Plane FitPlane(const std::vector<PatchCandidate>& members) {
  Plane plane;
  const auto count = static_cast<double>(members.size());
  for (const PatchCandidate& member : members) plane.mean += member.p_W / count;
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const PatchCandidate& member : members) {
    const Eigen::Vector3d d = member.p_W - plane.mean;
    scatter += d * d.transpose() / count;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter);
  plane.normal = solver.eigenvectors().col(0);
  plane.roughness = std::sqrt(std::max(0.0, solver.eigenvalues()[0]));
  plane.spread = std::sqrt(std::max(0.0, solver.eigenvalues()[1]));
  return plane;
}

}  // namespace

double PatchRadius(const PingRay& ping, const SonarPatchConfig& config) {
  return config.radius_m + config.radius_per_range * ping.range;
}

std::optional<SonarPatch> FindSonarPatch(const PingRay& ping,
                                         std::span<const PatchCandidate> candidates,
                                         const SonarPatchConfig& config) {
  const Eigen::Vector3d echo = ping.head_W + ping.range * ping.direction_W;
  const double radius = PatchRadius(ping, config);
  const auto distance = [&](const PatchCandidate& candidate) {
    return (candidate.p_W - echo).norm();
  };
  SonarPatch patch;
  for (const PatchCandidate& candidate : candidates)
    if (distance(candidate) <= radius) patch.members.push_back(candidate);
  if (static_cast<int>(patch.members.size()) < config.min_landmarks) return std::nullopt;
  std::stable_sort(patch.members.begin(), patch.members.end(),
                   [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
  if (static_cast<int>(patch.members.size()) > config.max_landmarks)
    patch.members.resize(static_cast<std::size_t>(config.max_landmarks));

  const Plane plane = FitPlane(patch.members);
  const double incidence_cos = std::abs(plane.normal.dot(ping.direction_W));
  if (plane.roughness > config.max_roughness_m || plane.spread < config.min_spread_m ||
      incidence_cos < config.min_incidence_cos)
    return std::nullopt;
  const double along_beam =
      plane.normal.dot(plane.mean - ping.head_W) / plane.normal.dot(ping.direction_W);
  patch.innovation = ping.range - along_beam;
  if (std::abs(patch.innovation) > config.max_innovation_m) return std::nullopt;
  patch.range_correction = (plane.mean - ping.head_W).norm() - along_beam;
  const double scatter = plane.roughness / std::sqrt(static_cast<double>(patch.members.size()));
  patch.sigma = std::hypot(scatter, config.surface_sigma_m) / incidence_cos;
  return patch;
}

}  // namespace drydock::svin2
