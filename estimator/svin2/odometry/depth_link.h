// Pressure readings on their way into the window.
#pragma once

#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "estimator/interface/estimator.h"
#include "estimator/svin2/initialisation/depth_scale.h"
#include "estimator/svin2/odometry/depth_gate.h"
#include "estimator/svin2/odometry/imu_buffer.h"
#include "estimator/svin2/window/sliding_window.h"
#include "sensors_models/measurement/rig.h"

namespace drydock::svin2 {

/// Keeps readings until the window has come up to them. A reading counts for when it was true: its
/// time less the sensor's lag, in which a body that climbs at 0.2 m/s rises by 4 mm.
class DepthLink {
 public:
  DepthLink(const DepthSheet& sheet, const DepthGate::Config& gate)
      : sheet_(sheet), gate_(gate), agreement_m_(gate.tolerance_m) {}

  /// False, and the reading is not kept, if it is not finite or not later than the one before.
  bool Add(Time t, const DepthSample& reading);

  /// Ties the readings up to the window's latest frame to it, but for those from long before a
  /// late start. What was not believed is said. The
  /// first reading finds the surface; if that was a spike, those after it outvote it.
  std::vector<EstimatorEvent> Feed(SlidingWindow& window, const ImuBuffer& imu);

  /// As they came, for the initialiser, which has its own use for the lag.
  std::span<const TimedDepth> SinceLastFrame() const { return since_frame_; }
  void NextFrame() { since_frame_.clear(); }

 private:
  /// Counts a reading that the gate refused and that has the surface at `surface` [m, in W]. True
  /// if more readings in a row now agree with each other than were ever believed: the surface was
  /// found by a spike.
  bool Outvotes(double surface);

  DepthSheet sheet_;
  DepthGate gate_;
  double agreement_m_;            // Of the heights at which two readings have the surface.
  int believed_ = 0;              // Since the surface was found.
  int against_ = 0;               // Refused one after another since then, agreeing.
  double surface_against_ = 0.0;  // By the last of those [m, in W].
  std::optional<Time> last_;
  std::deque<TimedDepth> waiting_;  // With the times at which they were true.
  std::vector<TimedDepth> since_frame_;
};

/// Standard deviation of one reading of the height that the window's states give [m]: noise and
/// rounding.
double DepthSigma(const DepthSheet& sheet);

}  // namespace drydock::svin2
