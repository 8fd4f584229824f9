#include "sensors_models/noise/first_order_lag.h"

#include <cmath>

namespace drydock {

double FirstOrderLag::Advance(double input, double dt) {
  if (time_constant_s_ == 0.0) {
    output_ = input;
  } else if (dt > 0.0) {
    // The input less tau * slope solves the equation; what the output differs by dies away.
    const double late = time_constant_s_ * (input - input_) / dt;
    const double difference = output_ - (input_ - late);
    output_ = input - late + difference * std::exp(-dt / time_constant_s_);
  }
  input_ = input;
  return output_;
}

}  // namespace drydock
