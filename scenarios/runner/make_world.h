// The world that a scenario asks for.
#pragma once

#include "scenarios/runner/scenario.h"
#include "sim/world/world.h"

namespace drydock {

/// The scene with what moves through it, from files that are generated and kept unless they are
/// there already. InputError if there is no such scene.
sim::World MakeWorld(const Scenario& scenario);

}  // namespace drydock
