// Progress of long work.
#pragma once

#include <functional>

#include "sensors_models/base/time.h"

namespace drydock::cli {

/// A function that shows how far a dive has come: a line that renews itself on a terminal, silence
/// elsewhere.
std::function<void(Time now, Time end)> ProgressOnTerminal();

}  // namespace drydock::cli
