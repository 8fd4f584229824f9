// How a body swims, as far as it has been seen to.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "estimator/interface/estimator.h"

namespace drydock::svin2 {

/// Remembers the velocity in the body's frame while vision works, for when the estimator is lost:
/// divers and robots swim on as they did. What is integrated from an IMU grows without bounds, this
/// does not. For the first quarter of a minute the IMU knows better.
class SwimmingHabit {
 public:
  struct Config {
    double memory_s = 5.0;  ///< Time constant of the mean velocity.
    /// How far the velocity is from that mean [m/s, RMS of each component]; 0: nothing is believed.
    double sigma = 0.3;
    double correlation_s = 1.0;  ///< For which such a deviation lasts.
  };

  explicit SwimmingHabit(const Config& config) : config_(config) {}

  /// The state of a frame that saw enough.
  void Learn(const NavState& state);
  /// What to expect of the velocity in the body's frame [m/s]: rest, if nothing was ever learnt.
  const Eigen::Vector3d& v_I() const { return v_I_; }
  /// Standard deviation to give each of many expectations, one every `interval` [m/s]. Their
  /// errors are alike for as long as a deviation lasts, so each may say its share only:
  /// sigma sqrt(2 correlation / interval). Nothing where nothing is to be believed.
  std::optional<double> SigmaEach(Duration interval) const;

 private:
  Config config_;
  Eigen::Vector3d v_I_ = Eigen::Vector3d::Zero();
  std::optional<Time> last_;
};

}  // namespace drydock::svin2
