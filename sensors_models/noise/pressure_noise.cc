#include "sensors_models/noise/pressure_noise.h"

#include "sensors_models/noise/digitise.h"

namespace drydock {

DepthSheet KeepEffects(DepthSheet sheet, const PressureEffects& effects) {
  if (!effects.white_noise) sheet.noise_m = 0.0;
  if (!effects.offset) sheet.offset_m = 0.0;
  if (!effects.lag) sheet.lag_s = 0.0;
  if (!effects.quantisation) sheet.resolution_m = 0.0;
  return sheet;
}

PressureNoise::PressureNoise(const DepthSheet& sheet, std::uint64_t seed)
    : noise_m_(sheet.noise_m),
      resolution_m_(sheet.resolution_m),
      white_(seed, "pressure0/white"),
      offset_(sheet.offset_m * RandomStream(seed, "pressure0/offset").Gaussian()) {}

double PressureNoise::Corrupt(double felt) {
  return Digitise(felt + offset_ + noise_m_ * white_.Gaussian(), 0.0, resolution_m_);
}

}  // namespace drydock
