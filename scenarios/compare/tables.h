// A comparison for people and for programs.
#pragma once

#include <string>

#include "scenarios/compare/summary.h"

namespace drydock::compare {

/// A table a case in Markdown, with columns aligned so that it reads well as plain text, too: an
/// estimator a row, "median (min … max)" over the seeds, and how many seeds have the metric where
/// not all do. Metrics that no estimator has are left out. Then the criteria.
std::string ToMarkdown(const Comparison& comparison);

/// All metrics with their statistics and values, the estimators' options, criteria and verdict. The
/// same bytes for the same results.
std::string ToJson(const Comparison& comparison);

/// What the estimators cost: CPU time per stereo frame and stages, seed by seed.
std::string CostsToJson(const Comparison& comparison);

/// "svin2-vio 41 ms, …": the median over all dives of the CPU time per stereo frame.
std::string DescribeCosts(const Comparison& comparison);

}  // namespace drydock::compare
