#include "sim/world/path_clearance.h"

#include "sensors_models/base/check.h"

namespace drydock::sim {

void RequireClearPath(const Motion& motion, const World& world, const RayScene& rays,
                      double clearance_m, const std::function<std::string(Time)>& place_of) {
  constexpr Duration kStep{20'000'000};  // About a centimetre at a diver's speed.
  for (Time t; t <= motion.End(); t = t + kStep) {
    const Eigen::Vector3d p = motion.At(t).T_WI.p();
    const std::optional<RayHit> hit = rays.Nearest(p, clearance_m);
    if (!hit) continue;
    RequireInput(
        false,
        "{}: at {:.2f} s the path at ({:.2f}, {:.2f}, {:.2f}) m comes within {:.3f} m of '{}'; "
        "clearance_m asks for {:.3f} m",
        place_of(t), t.Seconds(), p.x(), p.y(), p.z(), hit->range, world.BodyOfGeom(hit->geom),
        clearance_m);
  }
}

}  // namespace drydock::sim
