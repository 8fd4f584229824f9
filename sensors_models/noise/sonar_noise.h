// What chance does to a sonar's pings.
#pragma once

#include <cstddef>
#include <cstdint>

#include "sensors_models/base/random_stream.h"
#include "sensors_models/measurement/rig.h"

namespace drydock {

/// Every number belongs to its ping and bin: whatever happens to one ping, all others stay as they
/// are. Effects whose value in the sheet is zero leave the truth untouched.
class SonarNoise {
 public:
  SonarNoise(const SonarSheet& sheet, std::uint64_t seed);

  /// Whether the ping gives nothing at all.
  bool IsLost(std::uint64_t ping) const;
  /// What is added to all ranges of the ping [m]: N(0, range_noise_m^2).
  double RangeError(std::uint64_t ping) const;
  /// Factor on the energy in a bin. Waves from a rough face add up with random phases, so the
  /// amplitude is Rayleigh and the energy exponential with mean 1 (Goodman, Speckle Phenomena in
  /// Optics, 2007, ch. 3); the mean of `speckle_looks` such numbers has variance 1 / looks.
  double Speckle(std::uint64_t ping, std::size_t bin) const;
  /// Energy of the receiver's noise in a bin, where its mean is 1: exponential, for the same
  /// reason.
  double ReceiverNoise(std::uint64_t ping, std::size_t bin) const;

 private:
  SonarSheet sheet_;
  RandomStream dropouts_;
  RandomStream range_;
  RandomStream speckle_;
  RandomStream receiver_;
};

}  // namespace drydock
