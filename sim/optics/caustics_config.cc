#include "sim/optics/caustics_config.h"

namespace drydock::sim {

CausticsConfig ReadCaustics(YamlReader& yaml) {
  CausticsConfig config;
  config.slope_rms = yaml.Real("slope_rms", {0.0, 0.3}, config.slope_rms);
  config.wavelength_m = yaml.Real("wavelength_m", {0.05, 10.0}, config.wavelength_m);
  config.wind_azimuth_deg = yaml.Real("wind_azimuth_deg", {-360.0, 360.0}, config.wind_azimuth_deg);
  config.tile_m = yaml.Real("tile_m", {0.5, 50.0}, config.tile_m);
  if (config.tile_m < 4.0 * config.wavelength_m || config.tile_m > 20.0 * config.wavelength_m)
    yaml.Fail("tile_m", "4 to 20 times wavelength_m");
  return config;
}

}  // namespace drydock::sim
