#include "sim/motion/quintic_spline.h"

#include <Eigen/LU>
#include <algorithm>

#include "sensors_models/base/check.h"

namespace drydock::sim {
namespace {

/// The knot span that holds t: knots[span] <= t < knots[span + 1], the last one closed at its end.
int FindSpan(const std::vector<double>& knots, int degree, double t) {
  const auto last = knots.end() - degree - 1;
  const auto after = std::upper_bound(knots.begin() + degree + 1, last, t);
  return static_cast<int>(after - knots.begin()) - 1;
}

/// Values of the degree + 1 basis functions that live on `span`, by the Cox-de Boor recursion.
Eigen::VectorXd BasisFunctions(const std::vector<double>& knots, int degree, int span, double t) {
  Eigen::VectorXd basis = Eigen::VectorXd::Zero(degree + 1);
  basis[0] = 1.0;
  for (int d = 1; d <= degree; ++d) {
    double carried = 0.0;
    for (int r = 0; r < d; ++r) {
      const double right = knots[span + r + 1] - t;
      const double left = t - knots[span + 1 - d + r];
      const double share = basis[r] / (right + left);
      basis[r] = carried + right * share;
      carried = left * share;
    }
    basis[d] = carried;
  }
  return basis;
}

/// Control points of the derivative of a B-spline; its knots are `knots` without `skip` at each
/// end.
Eigen::MatrixXd Differentiate(const std::vector<double>& knots, int degree, int skip,
                              const Eigen::MatrixXd& control_points) {
  Eigen::MatrixXd derivative(control_points.rows(), control_points.cols() - 1);
  for (int i = 0; i < derivative.cols(); ++i) {
    const double span = knots[skip + i + degree + 1] - knots[skip + i + 1];
    derivative.col(i) = degree / span * (control_points.col(i + 1) - control_points.col(i));
  }
  return derivative;
}

}  // namespace

QuinticSpline::QuinticSpline(const std::vector<double>& times, const Eigen::MatrixXd& points) {
  const int count = static_cast<int>(times.size());
  Check(count >= 2 && points.cols() == count, "a spline needs two points or more, one a time");
  Check(std::is_sorted(times.begin(), times.end(), std::less_equal<>()), "times must increase");

  knots_.assign(kDegree, times.front());
  knots_.insert(knots_.end(), times.begin(), times.end());
  knots_.insert(knots_.end(), kDegree, times.back());

  // At a clamped end, velocity and acceleration vanish exactly if the first three control points
  // are equal: two of them are known, the rest follow from the points.
  const int unknowns = count - 2;
  const int control_count = count + kDegree - 1;
  Eigen::MatrixXd control_points(points.rows(), control_count);
  control_points.leftCols(3).colwise() = points.col(0);
  control_points.rightCols(3).colwise() = points.col(count - 1);
  if (unknowns > 0) {
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(unknowns, unknowns);
    Eigen::MatrixXd wanted = points.middleCols(1, unknowns).transpose();
    for (int row = 0; row < unknowns; ++row) {
      const double t = times[row + 1];
      const int span = FindSpan(knots_, kDegree, t);
      const Eigen::VectorXd basis = BasisFunctions(knots_, kDegree, span, t);
      for (int k = 0; k <= kDegree; ++k) {
        const int control = span - kDegree + k;
        const bool known = control < 3 || control >= control_count - 3;
        if (known) {
          wanted.row(row) -= basis[k] * control_points.col(control).transpose();
        } else {
          system(row, control - 3) = basis[k];
        }
      }
    }
    control_points.middleCols(3, unknowns) = system.partialPivLu().solve(wanted).transpose();
  }

  control_points_.push_back(std::move(control_points));
  for (int order = 1; order < kDegree; ++order) {
    control_points_.push_back(
        Differentiate(knots_, kDegree - order + 1, order - 1, control_points_.back()));
  }
}

Eigen::VectorXd QuinticSpline::Evaluate(double t, int order) const {
  const double clamped = std::clamp(t, start(), end());
  const int degree = kDegree - order;
  const int span = FindSpan(knots_, kDegree, clamped);
  const Eigen::VectorXd basis = BasisFunctions(knots_, degree, span, clamped);
  // The derivative's control points start `order` knots later, and its basis is `order` shorter.
  return control_points_[order].middleCols(span - kDegree, degree + 1) * basis;
}

}  // namespace drydock::sim
