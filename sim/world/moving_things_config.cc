#include "sim/world/moving_things_config.h"

namespace drydock::sim {
namespace {

ShoalConfig ReadShoal(YamlReader& yaml) {
  ShoalConfig shoal;
  shoal.kind = yaml.Choice("kind", FishKinds(), shoal.kind);
  shoal.count = static_cast<int>(yaml.Integer("count", {1, 100}, shoal.count));
  shoal.centre_m = yaml.Vector3("centre_m", {-1000.0, 1000.0});
  shoal.size_m = yaml.Real("size_m", {0.05, 2.0}, shoal.size_m);
  shoal.radius_m = yaml.Real("radius_m", {0.1, 100.0}, shoal.radius_m);
  if (shoal.radius_m < 2.0 * shoal.size_m)
    yaml.Fail("radius_m", "at least twice size_m, for fish cannot turn more tightly");
  shoal.speed_m_s = yaml.Real("speed_m_s", {0.01, 5.0}, shoal.speed_m_s);
  return shoal;
}

DiverArmConfig ReadDiverArm(YamlReader& yaml) {
  DiverArmConfig arm;
  arm.left = yaml.Choice("side", {"left", "right"}, "right") == "left";
  arm.reach_m = yaml.Real("reach_m", {0.2, 0.8}, arm.reach_m);
  return arm;
}

}  // namespace

std::vector<std::string> FishKinds() { return {"bream", "bass", "perch"}; }

MovingThingConfig ReadMovingThing(YamlReader& yaml) {
  const std::vector<std::string> known = {"fish", "diver_arm"};
  if (!yaml.Has("what")) yaml.Fail("what", "fish or diver_arm");
  MovingThingConfig thing;
  if (yaml.Choice("what", known, "") == "fish") {
    thing.what = ReadShoal(yaml);
  } else {
    thing.what = ReadDiverArm(yaml);
  }
  thing.from_s = yaml.Real("from_s", {0.0, 1e5}, thing.from_s);
  if (yaml.Has("to_s")) thing.to_s = yaml.Real("to_s", {0.0, 1e5});
  yaml.Skip("to_s");  // Also where it is missing: messages list it among the known keys.
  if (thing.to_s <= thing.from_s) yaml.Fail("to_s", "later than from_s");
  return thing;
}

}  // namespace drydock::sim
