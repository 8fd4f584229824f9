#include "sim/sensors/sonar.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "sensors_models/models/sonar_model.h"
#include "sensors_models/models/sonar_peaks.h"
#include "sim/sensors/sonar_echo.h"

namespace drydock::sim {
namespace {

/// A multiple of the widest packets that Embree casts. With these, the bins of an oblique wall are
/// within some 2 % of the integral over the cone.
constexpr std::size_t kBeamRays = 192;
constexpr double kLevels = 255.0;  ///< Of an amplitude of 8 bits.

/// Full scale is where the receiver saturates.
double Level(double amplitude) { return std::round(kLevels * std::min(amplitude, 1.0)); }

std::vector<std::uint8_t> ToBytes(const std::vector<double>& amplitudes) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(amplitudes.size());
  for (const double a : amplitudes) bytes.push_back(static_cast<std::uint8_t>(Level(a)));
  return bytes;
}

}  // namespace

Sonar::Sonar(const Motion& motion, const World& world, const RayScene& rays,
             const SonarSheet& sheet, bool noise, const SonarEffects& effects, std::uint64_t seed)
    : motion_(motion),
      world_(world),
      rays_(rays),
      sheet_(KeepEffects(sheet, effects)),
      noise_(noise),
      effects_(effects),
      beam_(MakeSonarBeamRays(sheet_.beam_width_rad, kBeamRays)),
      chance_(sheet_, seed) {}

Observation Sonar::Observe() {
  const Time t = NextTime();
  const auto number = static_cast<std::uint64_t>(next_);
  const double head_angle = SonarHeadAngle(sheet_, next_);
  ++next_;

  const Pose T_WS = motion_.At(t).T_WI * sheet_.T_IS;
  const Eigen::Vector3d beam_W = T_WS.q() * SonarBeam(head_angle);
  auto axis = rays_.Cast(T_WS.p(), beam_W, sheet_.max_range_m);
  if (axis && axis->range < sheet_.min_range_m) axis.reset();
  SonarTruth truth;
  if (axis) truth = {axis->range, world_.BodyOfGeom(axis->geom)};

  SonarPing ping;
  if (!noise_) {
    ping = MeasureAxis(axis, beam_W, 0.0);
  } else if (chance_.IsLost(number)) {
    ping = LostPing();
  } else if (sheet_.bins == 0) {
    ping = MeasureAxis(axis, beam_W, chance_.RangeError(number));
  } else {
    ping = MeasureEcho(T_WS, head_angle, number);
  }
  ping.head_angle = head_angle;
  return {{t, t, std::move(ping)}, truth};
}

SonarPing Sonar::LostPing() const {
  SonarPing ping;
  if (effects_.profiles) ping.profile.resize(static_cast<std::size_t>(sheet_.bins));
  return ping;
}

SonarPing Sonar::MeasureAxis(const std::optional<RayHit>& axis, const Eigen::Vector3d& beam_W,
                             double range_error) const {
  SonarPing ping;
  if (!axis) return ping;
  ping.range = std::clamp(axis->range + range_error, sheet_.min_range_m, sheet_.max_range_m);
  ping.first_range = ping.range;
  ping.intensity = std::abs(axis->normal.dot(beam_W));
  return ping;
}

SonarPing Sonar::MeasureEcho(const Pose& T_WS, double head_angle, std::uint64_t number) const {
  const Eigen::AngleAxisd head(head_angle, Eigen::Vector3d::UnitZ());
  const Eigen::Matrix3d turn = T_WS.R() * head.toRotationMatrix();
  const RayFan directions_W = (turn * beam_.directions).cast<float>();
  const EchoProfile echo =
      MakeEchoProfile(sheet_, rays_.CastFan(T_WS.p(), directions_W, sheet_.max_range_m),
                      beam_.weights, chance_.RangeError(number));
  const std::vector<double> amplitudes = Amplitudes(echo.energies, number);
  SonarPing ping;
  if (effects_.profiles) ping.profile = ToBytes(amplitudes);
  const auto peaks = FindSonarPeaks(amplitudes, sheet_.intensity_floor);
  if (!peaks) return ping;
  const auto range = [&](std::size_t bin) {
    return effects_.quantisation ? SonarBinCentre(sheet_, bin) : echo.ranges[bin];
  };
  ping.range = range(peaks->strongest);
  ping.intensity = std::min(amplitudes[peaks->strongest], 1.0);
  ping.first_range = range(peaks->first);
  return ping;
}

std::vector<double> Sonar::Amplitudes(const std::vector<double>& energies,
                                      std::uint64_t number) const {
  std::vector<double> amplitudes(energies.size());
  for (std::size_t bin = 0; bin < energies.size(); ++bin) {
    const double middle = SonarBinCentre(sheet_, bin);
    if (middle < sheet_.min_range_m) continue;
    double energy = energies[bin];
    if (energy > 0.0) energy *= chance_.Speckle(number, bin);
    if (sheet_.noise_floor > 0.0) {
      energy += ReceiverNoiseEnergy(sheet_, middle) * chance_.ReceiverNoise(number, bin);
    }
    const double amplitude = std::sqrt(energy);
    amplitudes[bin] = effects_.quantisation ? Level(amplitude) / kLevels : amplitude;
  }
  return amplitudes;
}

}  // namespace drydock::sim
