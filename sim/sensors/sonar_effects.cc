#include "sim/sensors/sonar_effects.h"

namespace drydock::sim {

SonarEffects ReadSonarEffects(YamlReader& yaml) {
  SonarEffects effects;
  effects.footprint = yaml.Boolean("footprint", effects.footprint);
  effects.absorption = yaml.Boolean("absorption", effects.absorption);
  effects.speckle = yaml.Boolean("speckle", effects.speckle);
  effects.noise_floor = yaml.Boolean("noise_floor", effects.noise_floor);
  effects.dropouts = yaml.Boolean("dropouts", effects.dropouts);
  effects.white_noise = yaml.Boolean("white_noise", effects.white_noise);
  effects.quantisation = yaml.Boolean("quantisation", effects.quantisation);
  effects.profiles = yaml.Boolean("profiles", effects.profiles);
  return effects;
}

SonarSheet KeepEffects(const SonarSheet& sheet, const SonarEffects& effects) {
  SonarSheet out = sheet;
  if (!effects.footprint) out.beam_width_rad = 0.0;
  if (!effects.absorption) out.absorption_db_m = out.gain_absorption_db_m = 0.0;
  if (!effects.speckle) out.speckle_looks = 0;
  if (!effects.noise_floor) out.noise_floor = 0.0;
  if (!effects.dropouts) out.dropout_probability = 0.0;
  if (!effects.white_noise) out.range_noise_m = 0.0;
  return out;
}

}  // namespace drydock::sim
