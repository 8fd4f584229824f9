// Which pressure readings are believed.
#pragma once

#include <optional>

#include "sensors_models/base/time.h"

namespace drydock::svin2 {

/// Refuses a reading that is further from what the estimator expects than its height can have
/// drifted since the last reading that was believed.
class DepthGate {
 public:
  struct Config {
    double tolerance_m = 0.3;     ///< Right after a reading that was believed.
    double growth_m_per_s = 0.1;  ///< Of the tolerance since then.
  };

  explicit DepthGate(const Config& config) : config_(config) {}

  /// Whether to believe a reading at `t` that lies `error` from what is expected [m].
  bool Believes(Time t, double error);

 private:
  Config config_;
  std::optional<Time> last_believed_;
};

}  // namespace drydock::svin2
