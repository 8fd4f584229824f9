// The bus' parts, each group added to a model in the bus frame, and the lake bed around it.
#pragma once

#include <cstdint>

#include "scenes/model/model.h"

namespace drydock::scenes::bus {

/// Sides, roof, rear and front walls, ceiling, window bars, rub rails.
void AddBody(SceneModel& model, std::uint64_t seed);
/// Hood, fenders, grille, headlights, front bumper.
void AddNose(SceneModel& model);
/// Back door, lamps, mirrors, stop arm, signs, hatches, rear bumper.
void AddFittings(SceneModel& model);
/// Wheels, axles, frame.
void AddChassis(SceneModel& model);
/// Floor, steps, ribs, dashboard, steering wheel.
void AddInterior(SceneModel& model, std::uint64_t seed);
void AddSeats(SceneModel& model, std::uint64_t seed);

}  // namespace drydock::scenes::bus
