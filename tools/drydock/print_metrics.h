// Figures for people.
#pragma once

#include "scenarios/scoring/metrics.h"

namespace drydock::cli {

/// Prints the metrics that exist, one a line with its unit.
void PrintMetrics(const score::Metrics& metrics);

}  // namespace drydock::cli
