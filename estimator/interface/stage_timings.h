// What the stages of an estimator cost. Reported, never used: no result depends on a clock.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace drydock {

/// Wall-clock time of one stage over a dive.
struct StageTimings {
  std::string name;       ///< "detection", "optimisation"…
  std::size_t count = 0;  ///< How many stereo frames it worked on.
  double total_s = 0.0;
  double median_ms = 0.0;  ///< Per frame.
  double p99_ms = 0.0;     ///< 99 % of the frames cost at most this.
};

/// One entry a stage, in the order in which the stages first ran.
using EstimatorTimings = std::vector<StageTimings>;

/// Collects what each stage costs:
///
///     { const StageClock::Lap lap(clock_, "detection"); Detect(frame); }
class StageClock {
 public:
  /// Adds the time of its own life to a stage, as the cost of one stereo frame.
  class Lap {
   public:
    /// `clock` must outlive the lap.
    Lap(StageClock& clock, std::string stage)
        : clock_(clock), stage_(std::move(stage)), start_(Clock::now()) {}
    ~Lap() { clock_.Add(stage_, std::chrono::duration<double>(Clock::now() - start_).count()); }
    Lap(const Lap&) = delete;
    Lap& operator=(const Lap&) = delete;

   private:
    using Clock = std::chrono::steady_clock;
    StageClock& clock_;
    std::string stage_;
    Clock::time_point start_;
  };

  /// One stereo frame cost `seconds` in `stage`.
  void Add(const std::string& stage, double seconds);
  EstimatorTimings Summary() const;

 private:
  /// A stage's name and its cost per frame [s].
  std::vector<std::pair<std::string, std::vector<double>>> stages_;
};

}  // namespace drydock
