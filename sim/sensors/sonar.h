// The simulated rotating profiling sonar.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sensors_models/measurement/rig.h"
#include "sensors_models/models/sonar_beam.h"
#include "sensors_models/noise/sonar_noise.h"
#include "sim/motion/motion.h"
#include "sim/sensors/sensor.h"
#include "sim/sensors/sonar_effects.h"
#include "sim/world/ray_scene.h"

namespace drydock::sim {

/// A cone of rays a ping. Their echoes add up in range bins (sonar_echo.h), chance has its say
/// (sonar_noise.h), and the ping's range is the bin with the strongest echo.
///
/// Simpler sonars: where the sheet has no bins, the exact range along the beam's axis plus white
/// noise; without `noise`, exactly that range. The intensity is then the cosine of the angle of
/// incidence, and there is no profile.
class Sonar final : public Sensor {
 public:
  /// Everything passed by reference must outlive the sensor.
  Sonar(const Motion& motion, const World& world, const RayScene& rays, const SonarSheet& sheet,
        bool noise, const SonarEffects& effects, std::uint64_t seed);

  Time NextTime() const override { return SampleTime(Time{}, next_, sheet_.rate_hz); }
  Observation Observe() override;

 private:
  /// What came back, without the head's angle; `axis` is what the beam's axis meets.
  SonarPing MeasureAxis(const std::optional<RayHit>& axis, const Eigen::Vector3d& beam_W,
                        double range_error) const;
  SonarPing MeasureEcho(const Pose& T_WS, double head_angle, std::uint64_t number) const;
  SonarPing LostPing() const;
  /// What the receiver makes of the energies in the bins of the numbered ping.
  std::vector<double> Amplitudes(const std::vector<double>& energies, std::uint64_t number) const;

  const Motion& motion_;
  const World& world_;
  const RayScene& rays_;
  SonarSheet sheet_;
  bool noise_;
  SonarEffects effects_;
  SonarBeamRays beam_;
  SonarNoise chance_;
  std::int64_t next_ = 0;
};

}  // namespace drydock::sim
