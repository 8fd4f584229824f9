#include "scenes/mesh/cell_noise.h"

#include <cmath>
#include <limits>

#include "scenes/mesh/lattice_noise.h"

namespace drydock::scenes {
namespace {

/// A coordinate of a point in its cell, from 21 of its bits.
double Offset(std::uint64_t bits) {
  return 0.15 + 0.7 * static_cast<double>(bits & 0x1fffff) * 0x1p-21;
}

}  // namespace

StrewnPoint NearestStrewn(const Eigen::Vector3d& p, std::uint64_t key) {
  const auto x = static_cast<std::int64_t>(std::floor(p.x()));
  const auto y = static_cast<std::int64_t>(std::floor(p.y()));
  const auto z = static_cast<std::int64_t>(std::floor(p.z()));
  StrewnPoint nearest;
  double least = std::numeric_limits<double>::max();
  for (std::int64_t k = z - 1; k <= z + 1; ++k) {
    for (std::int64_t j = y - 1; j <= y + 1; ++j) {
      for (std::int64_t i = x - 1; i <= x + 1; ++i) {
        const std::uint64_t bits = HashLattice(i, j, k, key);
        const double dx = static_cast<double>(i) + Offset(bits) - p.x();
        const double dy = static_cast<double>(j) + Offset(bits >> 21) - p.y();
        const double dz = static_cast<double>(k) + Offset(bits >> 42) - p.z();
        const double squared = dx * dx + dy * dy + dz * dz;
        if (squared >= least) continue;
        least = squared;
        nearest.bits = bits;
      }
    }
  }
  nearest.distance = std::sqrt(least);
  nearest.bits = HashLattice(0, 0, 1, nearest.bits);
  return nearest;
}

}  // namespace drydock::scenes
