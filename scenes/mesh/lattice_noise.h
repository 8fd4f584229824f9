// Smooth noise at points, for shapes: deterministic, the same on every platform.
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace drydock::scenes {

/// Spreads the bits of a lattice point and a key over a 64-bit word.
std::uint64_t HashLattice(std::int64_t x, std::int64_t y, std::int64_t z, std::uint64_t key);

/// Smooth noise in [-1, 1] with lattice spacing 1.
double Noise2(const Eigen::Vector2d& p, std::uint64_t key);
double Noise3(const Eigen::Vector3d& p, std::uint64_t key);

/// Octaves of halving size and amplitude, the largest with spacing 1; about [-1, 1].
double Fbm2(const Eigen::Vector2d& p, int octaves, std::uint64_t key);
double Fbm3(const Eigen::Vector3d& p, int octaves, std::uint64_t key);

}  // namespace drydock::scenes
