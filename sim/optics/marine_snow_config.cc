#include "sim/optics/marine_snow_config.h"

namespace drydock::sim {

MarineSnowConfig ReadMarineSnow(YamlReader& yaml) {
  MarineSnowConfig snow;
  constexpr Bounds kSize{1e-4, 0.05};
  snow.density_m3 = yaml.Real("density_m3", {0.0, 5000.0}, snow.density_m3);
  snow.size_min_m = yaml.Real("size_min_m", kSize, snow.size_min_m);
  snow.size_max_m = yaml.Real("size_max_m", kSize, snow.size_max_m);
  if (snow.size_max_m < snow.size_min_m) yaml.Fail("size_max_m", "at least size_min_m");
  snow.range_m = yaml.Real("range_m", {0.1, 10.0}, snow.range_m);
  snow.albedo = yaml.Real("albedo", {0.0, 1.0}, snow.albedo);
  snow.current_m_s = yaml.Vector3("current_m_s", {-5.0, 5.0}, snow.current_m_s);
  snow.wobble_m = yaml.Real("wobble_m", {0.0, 0.1}, snow.wobble_m);
  snow.aperture_m = yaml.Real("aperture_m", {0.0, 0.05}, snow.aperture_m);
  snow.focus_m = yaml.Real("focus_m", {0.05, 1000.0}, snow.focus_m);
  return snow;
}

}  // namespace drydock::sim
