// A smooth curve in space that closes, followed at an even pace.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace drydock::sim {

/// p(u) = centre + sum over k of cosine_k cos(k u) + sine_k sin(k u), k = 1, 2..., by its arc
/// length.
class ClosedCurve {
 public:
  struct Harmonic {
    Eigen::Vector3d cosine = Eigen::Vector3d::Zero();  ///< [m]
    Eigen::Vector3d sine = Eigen::Vector3d::Zero();    ///< [m]
  };

  /// `harmonics` begin with k = 1. The curve must never stand still.
  ClosedCurve(const Eigen::Vector3d& centre, std::vector<Harmonic> harmonics);

  double length() const { return lengths_.back(); }  ///< [m]
  /// `s` metres along the curve, which goes round and round. Steps in s are steps along the curve
  /// to a few parts in 1e5.
  Eigen::Vector3d At(double s) const;
  /// Unit vector along the curve there.
  Eigen::Vector3d Ahead(double s) const;
  /// From `point` to the farthest point of the curve [m], by its samples.
  double FarthestFrom(const Eigen::Vector3d& point) const;

 private:
  double ParameterAt(double s) const;
  Eigen::Vector3d Point(double u) const;
  Eigen::Vector3d Slope(double u) const;

  Eigen::Vector3d centre_;
  std::vector<Harmonic> harmonics_;
  std::vector<double> lengths_;  ///< From u = 0 to equally spaced ones, the last a whole turn.
};

}  // namespace drydock::sim
