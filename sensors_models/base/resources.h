// Where the files that come with Drydock are: scenarios, rigs, the visual vocabulary.
#pragma once

#include <filesystem>

namespace drydock {

/// The folder that holds `scenarios/`, `sensors_models/measurement/rigs/` and
/// `estimator/svin2/vocabulary/brisk.vocabulary`: $DRYDOCK_DATA if set, else share/drydock of the
/// tree that the running program is installed in, else the source tree this was built from, else
/// share/drydock where this was configured to be installed; the first that is there.
std::filesystem::path DataDirectory();

/// Where generated files are kept between runs: $DRYDOCK_CACHE if set, else
/// $XDG_CACHE_HOME/drydock, else ~/.cache/drydock, else a folder in the system's temporary one.
std::filesystem::path CacheDirectory();

}  // namespace drydock
