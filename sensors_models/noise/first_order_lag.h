// A sensor that follows its input late.
#pragma once

namespace drydock {

/// tau dy/dt = x - y, solved exactly for an input x that goes in straight lines from one value to
/// the next, however long the steps: behind a ramp of slope v the output ends up tau v late.
class FirstOrderLag {
 public:
  /// In steady state at `input`. A time constant [s] of 0 follows at once.
  FirstOrderLag(double time_constant_s, double input)
      : time_constant_s_(time_constant_s), input_(input), output_(input) {}

  /// The input goes on to `input` in a straight line within `dt` seconds (0 is a jump). Returns the
  /// output then.
  double Advance(double input, double dt);
  double output() const { return output_; }

 private:
  double time_constant_s_;
  double input_;
  double output_;
};

}  // namespace drydock
