#include "sensors_models/models/sonar_peaks.h"

#include <algorithm>

namespace drydock {

std::optional<SonarPeaks> FindSonarPeaks(std::span<const double> profile, double floor) {
  const auto index = [&](auto bin) { return static_cast<std::size_t>(bin - profile.begin()); };
  const auto first =
      std::find_if(profile.begin(), profile.end(), [&](double bin) { return bin > floor; });
  if (first == profile.end()) return std::nullopt;
  return SonarPeaks{index(std::max_element(first, profile.end())), index(first)};
}

}  // namespace drydock
