// A rig as text.
#pragma once

#include <string>

#include "sensors_models/measurement/rig.h"

namespace drydock::dataset {

/// YAML from which ReadRig gives the same rig, to the last bit.
std::string FormatRig(const Rig& rig);

}  // namespace drydock::dataset
