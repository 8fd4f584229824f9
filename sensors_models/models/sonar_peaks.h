// Which of a ping's echoes is its range.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace drydock {

/// Bins of an echo profile.
struct SonarPeaks {
  std::size_t strongest = 0;  ///< The nearest one where several are equally strong.
  std::size_t first = 0;      ///< The nearest one that is above the floor.
};

/// The echoes above `floor` in a profile of amplitudes, the nearest bin first; nothing where no bin
/// is above it.
std::optional<SonarPeaks> FindSonarPeaks(std::span<const double> profile, double floor);

}  // namespace drydock
