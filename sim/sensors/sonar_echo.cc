#include "sim/sensors/sonar_echo.h"

#include <algorithm>
#include <cmath>

#include "sensors_models/models/sonar_model.h"

namespace drydock::sim {
namespace {

constexpr double kSoundSpeed = 1480.0;  ///< Fresh water of 20 degrees [m/s]: only for the pulse.

double FromDecibels(double db) { return std::pow(10.0, db / 10.0); }

/// Share of a triangle over (-1, 1) that lies below x.
double TriangleBelow(double x) {
  if (x <= -1.0) return 0.0;
  if (x >= 1.0) return 1.0;
  return x < 0.0 ? 0.5 * (1.0 + x) * (1.0 + x) : 1.0 - 0.5 * (1.0 - x) * (1.0 - x);
}

/// Energies, and energies times ranges, by bin.
struct Moments {
  double bin_length;
  std::vector<double> energies;
  std::vector<double> moments;

  void Add(std::ptrdiff_t bin, double range, double energy) {
    if (bin < 0 || bin >= std::ssize(energies)) return;
    energies[static_cast<std::size_t>(bin)] += energy;
    moments[static_cast<std::size_t>(bin)] += energy * range;
  }

  /// An echo from `range` as a triangle between `range` - `half_length` and `range` +
  /// `half_length`.
  void AddPulse(double range, double half_length, double energy) {
    const auto bin_of = [&](double r) {
      return static_cast<std::ptrdiff_t>(std::floor(r / bin_length));
    };
    const std::ptrdiff_t first = bin_of(range - half_length);
    const std::ptrdiff_t last = bin_of(range + half_length);
    if (first == last) return Add(first, range, energy);
    double below = 0.0;
    for (std::ptrdiff_t bin = first; bin <= last; ++bin) {
      const double end = static_cast<double>(bin + 1) * bin_length;
      const double below_end = TriangleBelow((end - range) / half_length);
      Add(bin, range, energy * (below_end - below));
      below = below_end;
    }
  }
};

}  // namespace

double EchoEnergy(const SonarSheet& sheet, double range, double cos_incidence) {
  const double loss_db = 2.0 * range * (sheet.absorption_db_m - sheet.gain_absorption_db_m);
  return std::pow(cos_incidence, sheet.incidence_exponent - 1.0) * FromDecibels(-loss_db);
}

double ReceiverNoiseEnergy(const SonarSheet& sheet, double range) {
  const double amplitude = sheet.noise_floor * range / sheet.max_range_m;
  const double gain_db = 2.0 * sheet.gain_absorption_db_m * (range - sheet.max_range_m);
  return amplitude * amplitude * FromDecibels(gain_db);
}

EchoProfile MakeEchoProfile(const SonarSheet& sheet, const std::vector<FanHit>& hits,
                            const Eigen::VectorXd& weights, double range_error) {
  const auto bins = static_cast<std::size_t>(sheet.bins);
  const double pulse = 0.5 * kSoundSpeed * sheet.pulse_length_s;
  Moments sums{SonarBinLength(sheet), std::vector<double>(bins), std::vector<double>(bins)};
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (hits[i].geom < 0) continue;
    const double range = hits[i].range;
    const double energy = EchoEnergy(sheet, range, hits[i].cos_incidence);
    sums.AddPulse(range + range_error, pulse, weights(static_cast<Eigen::Index>(i)) * energy);
  }
  EchoProfile profile{std::move(sums.energies), std::vector<double>(bins)};
  for (std::size_t bin = 0; bin < bins; ++bin) {
    const double centre = SonarBinCentre(sheet, bin);
    double& energy = profile.energies[bin];
    if (centre < sheet.min_range_m) energy = 0.0;
    profile.ranges[bin] = energy > 0.0 ? sums.moments[bin] / energy : centre;
  }
  return profile;
}

}  // namespace drydock::sim
