// Where the wall-clock time goes.
#pragma once

#include <chrono>
#include <functional>
#include <utility>

namespace drydock {

/// Gives the seconds since some instant.
using WallClock = std::function<double()>;

inline double SteadySeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Adds the wall-clock time of its own life to a sum [s]. Timings are reported and, but for
/// --realtime, never used.
class Stopwatch {
 public:
  explicit Stopwatch(double& seconds, WallClock clock = SteadySeconds)
      : seconds_(seconds), clock_(std::move(clock)), start_(clock_()) {}
  ~Stopwatch() { seconds_ += clock_() - start_; }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  double& seconds_;
  WallClock clock_;
  double start_;
};

}  // namespace drydock
