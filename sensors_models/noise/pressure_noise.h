// What a real pressure sensor adds to the depth that its membrane feels:
//
//   measured = quantise(felt + offset + white)
//
// offset: one Gaussian number, drawn once a seed (air pressure, zero error). white: Gaussian, one
// number a sample. What is felt lags behind the truth (FirstOrderLag) and is the caller's to say,
// for it depends on all depths before. Each effect has a random stream of its own.
#pragma once

#include <cstdint>

#include "sensors_models/base/random_stream.h"
#include "sensors_models/measurement/rig.h"

namespace drydock {

/// Which of its sheet's effects a pressure sensor shows.
struct PressureEffects {
  bool white_noise = true;
  bool offset = true;
  bool lag = true;
  bool quantisation = true;
};

/// `sheet` with those effects at zero that are not in `effects`.
DepthSheet KeepEffects(DepthSheet sheet, const PressureEffects& effects);

/// All but the lag; an all-zero sheet leaves depths untouched.
class PressureNoise {
 public:
  PressureNoise(const DepthSheet& sheet, std::uint64_t seed);

  /// What is read of `felt` [m, positive downwards].
  double Corrupt(double felt);
  /// Of this dive [m]; positive reads too deep.
  double offset() const { return offset_; }

 private:
  double noise_m_;
  double resolution_m_;
  RandomStream white_;
  double offset_;
};

}  // namespace drydock
