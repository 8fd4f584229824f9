// What the tests of the sonar's echo share.
#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "sim/sensors/sonar.h"
#include "tests/sim/sensors/still_motion.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_scene.h"

namespace drydock::sim {

/// As the SVIn2 rig's, but it looks along +x of W and its head does not turn, without chance,
/// absorption or pulse: each test adds what it is about.
inline SonarSheet PlainEchoSheet() {
  SonarSheet sheet;
  sheet.rate_hz = 100.0;
  sheet.min_range_m = 0.125;
  sheet.max_range_m = 6.0;
  sheet.beam_width_rad = 1.4 * std::numbers::pi / 180.0;
  sheet.bins = 255;
  sheet.intensity_floor = 0.04;
  return sheet;
}

inline constexpr double kBinLength = 6.0 / 255.0;  ///< [m]

/// Standard deviation of the two-way pattern's Gaussian across the axis [rad]: 2^(-8 (angle/w)^2)
/// is exp(-angle^2/(2 s^2)) of s = w / (4 sqrt(ln 2)).
inline double BeamSigma() {
  return PlainEchoSheet().beam_width_rad / (4.0 * std::sqrt(std::numbers::ln2));
}

/// Share of a standard normal below x.
inline double NormalBelow(double x) { return 0.5 * std::erfc(-x / std::numbers::sqrt2); }

/// Amplitudes are exact, ranges means; profiles on.
inline SonarEffects Unrounded() {
  SonarEffects effects;
  effects.quantisation = false;
  effects.profiles = true;
  return effects;
}

/// A scene and a sonar at the origin in it that looks along +x, or turned to the left by `yaw`.
class SonarBench {
 public:
  explicit SonarBench(const std::string& worldbody, const std::string& assets = "")
      : world_(testing::WriteScene(folder_.path(), worldbody, assets)), rays_(world_) {}

  std::vector<SonarPing> Pings(int count, const SonarSheet& sheet, const SonarEffects& effects = {},
                               double yaw = 0.0, std::uint64_t seed = 1) const {
    const StillMotion motion(Pose(
        Eigen::Quaterniond(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ())), {0.0, 0.0, 0.0}));
    Sonar sonar(motion, world_, rays_, sheet, true, effects, seed);
    std::vector<SonarPing> pings;
    pings.reserve(static_cast<std::size_t>(count));
    for (int k = 0; k < count; ++k) {
      pings.push_back(std::get<SonarPing>(sonar.Observe().measurement.reading));
    }
    return pings;
  }

  SonarPing Ping(const SonarSheet& sheet, const SonarEffects& effects = {},
                 double yaw = 0.0) const {
    return Pings(1, sheet, effects, yaw).front();
  }

 private:
  testing::TemporaryFolder folder_;
  World world_;
  RayScene rays_;
};

/// A wall whose face is the plane x = `distance`.
inline std::string WallAt(double distance) {
  return testing::BoxElement("wall", {distance + 1.0, 0.0, 0.0}, {1.0, 20.0, 20.0});
}

/// Energy of each bin from a profile of bytes: good to 1/255 of amplitude.
inline std::vector<double> Energies(const SonarPing& ping) {
  std::vector<double> energies;
  energies.reserve(ping.profile.size());
  for (const std::uint8_t level : ping.profile) energies.push_back(level * level / (255.0 * 255.0));
  return energies;
}

inline double Sum(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double v : values) sum += v;
  return sum;
}

}  // namespace drydock::sim
