// A dive that would run into the scene is refused before it starts.
#pragma once

#include <functional>
#include <string>

#include "sim/motion/motion.h"
#include "sim/world/ray_scene.h"

namespace drydock::sim {

/// InputError naming time, place, body and distance if the body's origin comes nearer than
/// `clearance_m` to anything on its way. Checked each centimetre or so of the path. The message
/// begins with what `place_of` says of that time: where the user wrote that part of the path.
void RequireClearPath(
    const Motion& motion, const World& world, const RayScene& rays, double clearance_m,
    const std::function<std::string(Time)>& place_of = [](Time) { return "motion"; });

}  // namespace drydock::sim
