// Sonar pings on their way into the window.
#pragma once

#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "estimator/interface/estimator.h"
#include "estimator/svin2/odometry/describe_keyframe.h"
#include "estimator/svin2/odometry/imu_buffer.h"
#include "estimator/svin2/odometry/timed_point.h"
#include "estimator/svin2/sonar/landmark_memory.h"
#include "estimator/svin2/sonar/rig_scale_check.h"
#include "estimator/svin2/sonar/sonar_patch.h"
#include "estimator/svin2/window/sliding_window.h"
#include "sensors_models/measurement/rig.h"

namespace drydock::svin2 {

struct SonarConfig {
  SonarPatchConfig patch;
  double memory_s = 15.0;    ///< For which landmarks are remembered that left the window.
  double max_range_m = 4.5;  ///< Echoes from further away are not believed.
};

/// Keeps pings until the window has come up to them, and ties to each frame the surest one: those
/// of one sweep hit the same face, and say the same.
class SonarLink {
 public:
  SonarLink(const SonarSheet& sheet, const SonarConfig& config)
      : sheet_(sheet), config_(config), memory_(Duration::FromSeconds(config.memory_s)) {}

  /// False, and the ping is not kept, if it is not finite or not later than the one before.
  bool Add(Time t, const SonarPing& ping);

  /// Ties to the window's latest frame one of the pings since the frame before, whose state was
  /// `before`. While `is_tracking`, pings also judge the rig's scale: drift in the dark is no
  /// matter of the rig. What that found is said.
  std::vector<EstimatorEvent> Feed(SlidingWindow& window, const ImuBuffer& imu,
                                   const NavState& before, bool is_tracking);

  /// Landmarks [m, in W] that left the window at `now` and that the sonar has still to pass.
  void Remember(Time now, std::span<const Eigen::Vector3d> departed) { memory_.Add(now, departed); }
  /// Another map begins: its frames know nothing of the landmarks of this one.
  void StartMap();

  /// Of the latest frame, if all landmarks of its patch are still being estimated.
  const std::vector<TiedPing>& tied() const { return tied_; }
  /// Where the sonar met something.
  const std::vector<TimedPoint>& echoes() const { return echoes_; }

 private:
  struct PendingPing {
    Time t;
    SonarPing ping;
  };
  /// A ping and the patch that it met.
  struct Met {
    Time t;
    SonarRangeObservation observation;
    SonarPatch patch;
  };

  std::optional<Met> SurestPing(const SlidingWindow& window, const ImuBuffer& imu,
                                const NavState& before);
  std::optional<SonarPatch> PatchOf(const PingRay& ping, const SlidingWindow& window) const;
  void Tie(const Met& ping, SlidingWindow& window);

  SonarSheet sheet_;
  SonarConfig config_;
  LandmarkMemory memory_;
  RigScaleCheck rig_scale_{RigScaleCheck::Config{}};
  std::optional<Time> last_;
  std::deque<PendingPing> waiting_;
  std::vector<TiedPing> tied_;
  std::vector<TimedPoint> echoes_;
};

}  // namespace drydock::svin2
