// What lies around the bus, where it does not bar the way.
#pragma once

#include <cstdint>

#include "scenes/bus/site.h"
#include "scenes/model/model.h"

namespace drydock::scenes::bus {

void AddClutter(SceneModel& model, const LakeBed& bed, const Corridor& corridor,
                std::uint64_t seed);

}  // namespace drydock::scenes::bus
