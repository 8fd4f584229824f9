// Suite files.
#pragma once

#include <filesystem>

#include "scenarios/compare/suite.h"

namespace drydock::compare {

/// Reads a suite file strictly (docs/scenarios.md has its keys). InputError with file, line and key
/// for what does not fit together: names that stand twice, criteria on what is not compared. What
/// cases and estimators mean is checked by MakePlan.
Suite LoadSuite(const std::filesystem::path& path);

}  // namespace drydock::compare
