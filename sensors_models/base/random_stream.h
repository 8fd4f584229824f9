// Random numbers that are the same on every machine and that one sensor cannot disturb for another.
#pragma once

#include <cstdint>
#include <string_view>

namespace drydock {

/// A named stream of random numbers. The seed and the name pick a key; the n-th number is a
/// function of key and n alone (counter-based, Philox 4x32-10 of Salmon et al., SC 2011), so
/// streams never interact and any number can be had without the ones before it.
///
/// Gaussian numbers come from Wichura's inverse of the normal distribution (AS 241) with a
/// logarithm of our own: only +, -, *, / and sqrt, so that every IEEE machine gives the same bits.
class RandomStream {
 public:
  /// For example RandomStream(seed, "imu0/gyro").
  RandomStream(std::uint64_t seed, std::string_view name);

  /// The next number: 64 random bits.
  std::uint64_t Bits() { return BitsAt(next_++); }
  /// Uniform in (0, 1), never 0 or 1.
  double Uniform() { return UniformAt(next_++); }
  /// Uniform in (low, high).
  double Uniform(double low, double high) { return low + (high - low) * Uniform(); }
  /// Normal with mean 0 and standard deviation 1.
  double Gaussian() { return GaussianAt(next_++); }

  /// The n-th number of the stream, whatever was drawn before.
  std::uint64_t BitsAt(std::uint64_t n) const;
  double UniformAt(std::uint64_t n) const;
  double GaussianAt(std::uint64_t n) const;

 private:
  std::uint64_t key_;
  std::uint64_t next_ = 0;
};

/// The x with P(X < x) = p for a standard normal X; 0 < p < 1. Relative error about 1e-16.
double InverseNormal(double p);

}  // namespace drydock
