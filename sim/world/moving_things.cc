#include "sim/world/moving_things.h"

#include <string>
#include <utility>

#include <fmt/format.h>

#include "sensors_models/base/check.h"

namespace drydock::sim {
namespace {

const std::vector<CreaturePart>& PartsOf(const Creatures& creatures, const std::string& name) {
  const auto found = creatures.find(name);
  Check(found != creatures.end(), "there is no creature {}", name);
  return found->second;
}

std::variant<Shoal, DiverArm> Make(const MovingThingConfig& thing, const Creatures& creatures,
                                   std::uint64_t seed, const std::string& name) {
  if (const auto* shoal = std::get_if<ShoalConfig>(&thing.what))
    return Shoal(*shoal, PartsOf(creatures, shoal->kind), seed, name);
  const auto& arm = std::get<DiverArmConfig>(thing.what);
  return DiverArm(thing, arm, PartsOf(creatures, arm.left ? "arm_left" : "arm_right"), seed, name);
}

}  // namespace

MovingThings::MovingThings(const std::vector<MovingThingConfig>& things, const Creatures& creatures,
                           std::uint64_t seed) {
  for (std::size_t i = 0; i < things.size(); ++i) {
    things_.push_back({things[i].from_s, things[i].to_s,
                       Make(things[i], creatures, seed, fmt::format("moving/{}", i))});
    std::visit(
        [this](const auto& what) {
          bodies_.insert(bodies_.end(), what.bodies().begin(), what.bodies().end());
        },
        things_.back().what);
  }
}

MovingPoses MovingThings::At(Time t, const Pose& T_WI) const {
  const double seconds = t.Seconds();
  MovingPoses poses;
  poses.reserve(bodies_.size());
  for (const Thing& thing : things_) {
    std::visit(
        [&](const auto& what) {
          if (seconds < thing.from || seconds > thing.to) {
            poses.insert(poses.end(), what.bodies().size(), std::nullopt);
            return;
          }
          for (const Pose& T_WB : what.At(seconds, T_WI)) poses.emplace_back(T_WB);
        },
        thing.what);
  }
  return poses;
}

}  // namespace drydock::sim
