// Finds known points among new corners by their descriptors.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "estimator/svin2/frontend/descriptor.h"

namespace drydock::svin2 {

struct DescribedPoint {
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  std::optional<Descriptor> descriptor;  ///< Without one it matches nothing.
};

/// The nearest descriptor within a radius, if the second nearest there is clearly further.
class DescriptorMatcher {
 public:
  struct Config {
    int max_distance = 80;    ///< Bits of 512 that may differ.
    double max_ratio = 0.8;   ///< Of the distances of the best and the second best.
    double radius_px = 25.0;  ///< About where a point is expected.
  };

  /// Throws InputError for values that cannot be used.
  explicit DescriptorMatcher(const Config& config);

  /// For each of `expected` the index of its corner. No corner is given twice.
  std::vector<std::optional<std::size_t>> Match(const std::vector<DescribedPoint>& expected,
                                                const std::vector<DescribedPoint>& corners) const;

 private:
  Config config_;
};

}  // namespace drydock::svin2
