#include "sim/world/diver_arm.h"

#include <algorithm>
#include <numbers>

#include "sensors_models/base/check.h"
#include "sensors_models/base/random_stream.h"

namespace drydock::sim {
namespace {

using Eigen::Vector3d;
constexpr double kDegrees = std::numbers::pi / 180.0;
constexpr double kArmLength = 0.45;  // Elbow to finger tips [m].

/// The pose of a stretched arm in I. The right one comes from the lower right.
Pose ArmInBody(const DiverArmConfig& config) {
  const double side = config.left ? 1.0 : -1.0;
  const Eigen::Quaterniond q =
      FromYawPitchRoll(-side * 24.0 * kDegrees, -11.0 * kDegrees, -side * 30.0 * kDegrees);
  const Vector3d tips(config.reach_m, side * 0.08, -0.09);
  return {q, tips - q * Vector3d(kArmLength, 0.0, 0.0)};
}

/// From 0 to 1 with two continuous derivatives.
double Ease(double x) {
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * t * (t * (6.0 * t - 15.0) + 10.0);
}

}  // namespace

DiverArm::DiverArm(const MovingThingConfig& times, const DiverArmConfig& config,
                   const std::vector<CreaturePart>& parts, std::uint64_t seed,
                   const std::string& name)
    : from_(times.from_s), to_(times.to_s), T_IB_(ArmInBody(config)) {
  Check(parts.size() == 1, "an arm of {} parts", parts.size());
  constexpr std::array<double, 3> kFrequencies = {0.11, 0.23, 0.41};  // [Hz]
  constexpr std::array<double, 3> kShares = {0.8, 0.5, 0.33};         // Their squares add up to 1.
  RandomStream random(seed, name);
  for (std::size_t axis = 0; axis < sway_.size(); ++axis) {
    const double rms = axis < 3 ? 0.010 : 1.6 * kDegrees;
    for (std::size_t k = 0; k < kShares.size(); ++k) {
      sway_[axis][k] = {std::numbers::sqrt2 * rms * kShares[k],
                        2.0 * std::numbers::pi * kFrequencies[k] * random.Uniform(0.85, 1.15),
                        random.Uniform(0.0, 2.0 * std::numbers::pi)};
    }
  }
  bodies_.push_back({name, parts[0].mesh, parts[0].texture, 1.0, 1.0F});
}

double DiverArm::Stretched(double t) const {
  const double out = from_ > 0.0 ? Ease((t - from_) / kReachTime) : 1.0;
  return out * Ease((to_ - t) / kReachTime);
}

std::vector<Pose> DiverArm::At(double t, const Pose& T_WI) const {
  std::array<double, 6> sway = {};
  for (std::size_t axis = 0; axis < sway.size(); ++axis) {
    for (const Tone& tone : sway_[axis])
      sway[axis] += tone.amplitude * std::sin(tone.frequency * t + tone.phase);
  }
  const Pose turned(ExpSO3({sway[3], sway[4], sway[5]}), Vector3d(sway[0], sway[1], sway[2]));
  // Drawn back along itself and down, out of view.
  const double back = 1.0 - Stretched(t);
  const Pose T_IB(T_IB_.q(), T_IB_.p() + T_IB_.q() * Vector3d(-0.5 * back, 0.0, 0.0) -
                                 Vector3d(0.0, 0.0, 0.25 * back));
  return {T_WI * T_IB * turned};
}

}  // namespace drydock::sim
