#include "sim/sensors/sonar.h"

#include <algorithm>
#include <cmath>

#include "sensors_models/models/sonar_model.h"

namespace drydock::sim {

Sonar::Sonar(const Motion& motion, const World& world, const RayScene& rays,
             const SonarSheet& sheet, bool noise, std::uint64_t seed)
    : motion_(motion),
      world_(world),
      rays_(rays),
      sheet_(sheet),
      noise_m_(noise ? sheet.range_noise_m : 0.0),
      stream_(seed, "sonar0/white") {}

Observation Sonar::Observe() {
  const Time t = NextTime();
  const auto ping_number = static_cast<std::uint64_t>(next_);
  SonarPing ping;
  ping.head_angle = SonarHeadAngle(sheet_, next_);
  ++next_;

  const Pose T_WS = motion_.At(t).T_WI * sheet_.T_IS;
  const Eigen::Vector3d beam_W = T_WS.q() * SonarBeam(ping.head_angle);
  SonarTruth truth;
  const auto hit = rays_.Cast(T_WS.p(), beam_W, sheet_.max_range_m);
  if (hit && hit->range >= sheet_.min_range_m) {
    truth = {hit->range, world_.BodyOfGeom(hit->geom)};
    // Numbered by ping, so that a lost echo does not shift the noise of later ones.
    const double noisy = hit->range + noise_m_ * stream_.GaussianAt(ping_number);
    ping.range = std::clamp(noisy, sheet_.min_range_m, sheet_.max_range_m);
    ping.intensity = std::abs(hit->normal.dot(beam_W));
  }
  return {{t, t, ping}, truth};
}

}  // namespace drydock::sim
