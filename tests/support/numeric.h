// Numeric derivatives, to hold analytic ones against.
#pragma once

#include <Eigen/Core>

namespace drydock::testing {

/// Central difference of `function` at `x` with a step of `h`: error about h^2 of the third
/// derivative.
template <typename Function>
auto NumericDerivative(Function function, double x, double h = 1e-4) {
  using Value = std::decay_t<decltype(function(x))>;
  return Value((function(x + h) - function(x - h)) / (2.0 * h));
}

}  // namespace drydock::testing
