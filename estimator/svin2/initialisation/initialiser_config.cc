#include "estimator/svin2/initialisation/initialiser_config.h"

namespace drydock::svin2 {

InitialiserConfig ReadInitialiserConfig(YamlReader& reader) {
  InitialiserConfig config;
  const auto real = [&reader](const char* key, double& value) {
    value = reader.Real(key, Bounds::Positive(), value);
  };
  const auto count = [&reader](const char* key, Bounds bounds, int& value) {
    value = static_cast<int>(reader.Integer(key, bounds, value));
  };
  count("min_landmarks", {6, 1000}, config.min_landmarks);
  real("frame_spacing_s", config.frame_spacing_s);
  real("max_gap_s", config.max_gap_s);
  count("min_frames", {3, 30}, config.min_frames);
  count("max_frames", {3, 30}, config.max_frames);
  real("stereo_scale_sigma", config.stereo_scale_sigma);
  real("wanted_scale_sigma", config.wanted_scale_sigma);
  real("gyro_bias_sigma_rad_s", config.gyro_bias_sigma);
  real("accel_bias_sigma_m_s2", config.accel_bias_sigma);
  real("max_chi2", config.max_chi2);
  real("max_gravity_error_m_s2", config.max_gravity_error);
  real("max_tilt_sigma_rad", config.max_tilt_sigma_rad);
  real("max_speed_sigma_m_s", config.max_speed_sigma);
  real("moving_m", config.moving_m);
  if (config.max_frames < config.min_frames) reader.Fail("max_frames", "at least min_frames");
  if (config.max_gap_s < config.frame_spacing_s) {
    reader.Fail("max_gap_s", "at least frame_spacing_s");
  }
  config.vision.min_landmarks = config.min_landmarks;
  return config;
}

}  // namespace drydock::svin2
