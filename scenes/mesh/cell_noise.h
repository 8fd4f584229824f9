// Cellular noise at points, for shapes: scallops, pockets, pebbled ground.
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace drydock::scenes {

/// One of the points that are strewn through space, one a lattice cell of size 1, off its middle by
/// up to 0.35 along each axis.
struct StrewnPoint {
  double distance = 0.0;   ///< from where was asked
  std::uint64_t bits = 0;  ///< random, of this point alone
};

/// The nearest of the 27 around `p`: continuous but for jumps that are rare and small.
StrewnPoint NearestStrewn(const Eigen::Vector3d& p, std::uint64_t key);

}  // namespace drydock::scenes
