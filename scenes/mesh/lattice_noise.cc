#include "scenes/mesh/lattice_noise.h"

#include <cmath>

namespace drydock::scenes {
namespace {

/// A lattice point's value in (-1, 1).
double LatticeValue(std::int64_t x, std::int64_t y, std::int64_t z, std::uint64_t key) {
  return static_cast<double>(HashLattice(x, y, z, key) >> 11) * 0x1p-52 - 1.0;
}

double Smooth(double t) { return t * t * t * (t * (6.0 * t - 15.0) + 10.0); }
double Mix(double a, double b, double t) { return a + (b - a) * t; }

}  // namespace

std::uint64_t HashLattice(std::int64_t x, std::int64_t y, std::int64_t z, std::uint64_t key) {
  std::uint64_t h = key;
  for (const std::int64_t c : {x, y, z}) {
    h = (h ^ static_cast<std::uint64_t>(c)) * 0x9e3779b97f4a7c15ULL;
    h = (h ^ (h >> 29)) * 0xbf58476d1ce4e5b9ULL;
  }
  return h ^ (h >> 32);
}

double Noise2(const Eigen::Vector2d& p, std::uint64_t key) {
  return Noise3({p.x(), p.y(), 0.0}, key);
}

double Noise3(const Eigen::Vector3d& p, std::uint64_t key) {
  const auto x = static_cast<std::int64_t>(std::floor(p.x()));
  const auto y = static_cast<std::int64_t>(std::floor(p.y()));
  const auto z = static_cast<std::int64_t>(std::floor(p.z()));
  const double tx = Smooth(p.x() - static_cast<double>(x));
  const double ty = Smooth(p.y() - static_cast<double>(y));
  const double tz = Smooth(p.z() - static_cast<double>(z));
  const auto row = [&](std::int64_t yy, std::int64_t zz) {
    return Mix(LatticeValue(x, yy, zz, key), LatticeValue(x + 1, yy, zz, key), tx);
  };
  return Mix(Mix(row(y, z), row(y + 1, z), ty), Mix(row(y, z + 1), row(y + 1, z + 1), ty), tz);
}

double Fbm2(const Eigen::Vector2d& p, int octaves, std::uint64_t key) {
  return Fbm3({p.x(), p.y(), 0.0}, octaves, key);
}

double Fbm3(const Eigen::Vector3d& p, int octaves, std::uint64_t key) {
  double sum = 0.0;
  double amplitude = 0.5;
  double frequency = 1.0;
  for (int i = 0; i < octaves; ++i) {
    sum += amplitude * Noise3(frequency * p, key + static_cast<std::uint64_t>(i));
    amplitude *= 0.5;
    frequency *= 2.03;
  }
  return sum;
}

}  // namespace drydock::scenes
