#include "sensors_models/noise/sonar_noise.h"

#include <cmath>

namespace drydock {
namespace {

/// Exponential with mean 1.
double ExponentialAt(const RandomStream& stream, std::uint64_t n) {
  return -std::log(stream.UniformAt(n));
}

}  // namespace

SonarNoise::SonarNoise(const SonarSheet& sheet, std::uint64_t seed)
    : sheet_(sheet),
      dropouts_(seed, "sonar0/dropouts"),
      range_(seed, "sonar0/white"),
      speckle_(seed, "sonar0/speckle"),
      receiver_(seed, "sonar0/receiver") {}

bool SonarNoise::IsLost(std::uint64_t ping) const {
  return dropouts_.UniformAt(ping) < sheet_.dropout_probability;
}

double SonarNoise::RangeError(std::uint64_t ping) const {
  return sheet_.range_noise_m * range_.GaussianAt(ping);
}

double SonarNoise::Speckle(std::uint64_t ping, std::size_t bin) const {
  const auto looks = static_cast<std::uint64_t>(sheet_.speckle_looks);
  if (looks == 0) return 1.0;
  const std::uint64_t first = (ping * static_cast<std::uint64_t>(sheet_.bins) + bin) * looks;
  double sum = 0.0;
  for (std::uint64_t look = 0; look < looks; ++look) sum += ExponentialAt(speckle_, first + look);
  return sum / static_cast<double>(looks);
}

double SonarNoise::ReceiverNoise(std::uint64_t ping, std::size_t bin) const {
  return ExponentialAt(receiver_, ping * static_cast<std::uint64_t>(sheet_.bins) + bin);
}

}  // namespace drydock
