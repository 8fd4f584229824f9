// The cone of a sonar's beam, as rays.
#pragma once

#include <Eigen/Core>
#include <cstddef>

namespace drydock {

/// What the transducer sends, and again what it hears, at `angle` [rad] from its axis, as a share
/// of the intensity on the axis: 3 dB down at half of `beam_width` [rad]. The main lobe of a
/// circular piston as a Gaussian; no side lobes.
double OneWayBeamPattern(double angle, double beam_width);

/// Rays that stand for a conical beam around +x.
struct SonarBeamRays {
  Eigen::Matrix3Xd directions;  ///< Unit vectors, one a column.
  Eigen::VectorXd weights;      ///< Share of the beam's two-way energy; they add up to 1.
};

/// `count` rays on a sunflower (Vogel 1979), each a golden angle on from the one before, so that no
/// two line up. They are as dense as the beam sends (one-way pattern) and weigh as much as it hears
/// (the same pattern), out to a full width from the axis: beyond lie 0.4 % of the two-way energy.
/// One ray along the axis where the width is 0.
SonarBeamRays MakeSonarBeamRays(double beam_width, std::size_t count);

}  // namespace drydock
