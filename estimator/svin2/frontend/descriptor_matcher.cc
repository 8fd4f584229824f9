#include "estimator/svin2/frontend/descriptor_matcher.h"

#include "sensors_models/base/check.h"

namespace drydock::svin2 {

DescriptorMatcher::DescriptorMatcher(const Config& config) : config_(config) {
  RequireInput(config.max_distance >= 0 && config.max_distance <= 512,
               "max_distance is {}; it must lie in [0, 512]", config.max_distance);
  RequireInput(config.max_ratio > 0.0 && config.max_ratio <= 1.0,
               "max_ratio is {}; it must lie in (0, 1]", config.max_ratio);
  RequireInput(config.radius_px > 0.0, "radius_px is {}; it must be positive", config.radius_px);
}

std::vector<std::optional<std::size_t>> DescriptorMatcher::Match(
    const std::vector<DescribedPoint>& expected, const std::vector<DescribedPoint>& corners) const {
  constexpr int kFar = 513;
  std::vector<std::optional<std::size_t>> matches(expected.size());
  struct Claim {
    std::size_t by = 0;
    int distance = kFar;
  };
  std::vector<Claim> claims(corners.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (!expected[i].descriptor.has_value()) continue;
    int best = kFar, second = kFar;
    std::size_t best_corner = 0;
    for (std::size_t j = 0; j < corners.size(); ++j) {
      if (!corners[j].descriptor.has_value() ||
          (corners[j].pixel - expected[i].pixel).norm() > config_.radius_px) {
        continue;
      }
      const int distance = HammingDistance(*expected[i].descriptor, *corners[j].descriptor);
      if (distance < best) {
        second = best;
        best = distance;
        best_corner = j;
      } else {
        second = std::min(second, distance);
      }
    }
    if (best > config_.max_distance || best > config_.max_ratio * second) continue;
    Claim& claim = claims[best_corner];
    if (best >= claim.distance) continue;
    if (claim.distance < kFar) matches[claim.by].reset();
    claim = {i, best};
    matches[i] = best_corner;
  }
  return matches;
}

}  // namespace drydock::svin2
