// From what the rays of a sonar's beam met to the echo that comes back over time.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "sensors_models/measurement/rig.h"
#include "sim/world/ray_scene.h"

namespace drydock::sim {

/// An echo before chance has touched it. Energies are squares of amplitudes: 1 is full scale.
struct EchoProfile {
  std::vector<double> energies;  ///< By bin.
  std::vector<double> ranges;  ///< Mean range of the echoes in each bin [m], by energy; its middle
                               ///< where it has none.
};

/// Energy that comes back if the whole beam meets a face at `range` [m]:
///
///     cos^(n - 1) 10^(-2 (a - g) range / 10)
///
/// n is the sheet's incidence_exponent (Lambert: 2): a unit of area throws back cos^n, and the beam
/// covers 1/cos of the area that it covers squarely. a and g are the absorption and what the gain
/// makes up for. Spreading is not in it: the energy from a face wider than the beam falls as
/// 1/range^2 (footprint grows as range^2, two-way loss as range^4), which the gain makes up for.
double EchoEnergy(const SonarSheet& sheet, double range, double cos_incidence);

/// Mean energy of the receiver's noise at `range` [m]: noise_floor^2 at max_range_m, and towards
/// the head less, as the gain is: times (range / max)^2 10^(2 g (range - max) / 10).
double ReceiverNoiseEnergy(const SonarSheet& sheet, double range);

/// The energy of each hit, times its ray's weight, at the hit's range plus `range_error` [m]. The
/// pulse makes it a triangle around that range, c/2 times the pulse's length wide at half height.
/// Nothing is heard in bins whose middle is nearer than min_range_m.
EchoProfile MakeEchoProfile(const SonarSheet& sheet, const std::vector<FanHit>& hits,
                            const Eigen::VectorXd& weights, double range_error);

}  // namespace drydock::sim
