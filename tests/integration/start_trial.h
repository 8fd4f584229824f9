// SVIn2 put into the water in the middle of a dive.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tests/integration/recorded_dive.h"

namespace drydock::testing {

/// How one start went.
struct StartTrial {
  double begun_s = 0.0;          ///< When the first measurement was handed over.
  std::optional<double> wait_s;  ///< From then to the first state; nothing: it never came.
  std::optional<double> scale_error_percent;  ///< As the scorecard's init_scale_error_percent.
  int false_starts = 0;
  std::string report;  ///< What the initialiser said.

  /// It says that the body rested.
  bool FromRest() const { return report.find("started from rest") != std::string::npos; }
};

/// Hands `svin2-noloop` all measurements of `dive` from `begin` on, until it has followed the first
/// five seconds of the body's motion, or `dive` ends.
StartTrial StartAt(const RecordedDive& dive, Time begin);

/// `count` trials at random instants of [from, to] [s].
std::vector<StartTrial> StartAtRandom(const RecordedDive& dive, const std::string& stream,
                                      int count, double from_s, double to_s);

/// One line.
std::string Line(const StartTrial& trial);

}  // namespace drydock::testing
