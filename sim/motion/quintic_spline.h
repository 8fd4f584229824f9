// A smooth curve through given points.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace drydock::sim {

/// A curve in R^n that passes through point i at time times[i]: a B-spline of degree 5 with a knot
/// at each time, hence four times continuously differentiable, at rest (velocity and acceleration
/// zero) at both ends.
class QuinticSpline {
 public:
  /// One column of `points` a time; `times` strictly increasing, at least two.
  QuinticSpline(const std::vector<double>& times, const Eigen::MatrixXd& points);

  /// The curve (order 0) or its derivative of order 1 to 4 at `t`, clamped to the curve's span.
  Eigen::VectorXd Evaluate(double t, int order = 0) const;

  /// When it passes its i-th point.
  double TimeOf(std::size_t i) const { return knots_[kDegree + i]; }
  std::size_t size() const { return knots_.size() - 2 * kDegree; }
  double start() const { return knots_.front(); }
  double end() const { return knots_.back(); }

 private:
  static constexpr int kDegree = 5;

  std::vector<double> knots_;
  /// Control points of the curve and of its derivatives, one a column.
  std::vector<Eigen::MatrixXd> control_points_;
};

}  // namespace drydock::sim
