// Landmarks that the cameras have left behind and the sonar has still to pass.
#pragma once

#include <Eigen/Core>
#include <deque>
#include <span>
#include <vector>

#include "sensors_models/base/time.h"

namespace drydock::svin2 {

/// Keeps landmarks for a while after they left the window. The sonar looks across the travel: a
/// wall that it passes left the image some seconds before.
class LandmarkMemory {
 public:
  explicit LandmarkMemory(Duration span) : span_(span) {}

  /// Landmarks [m, in W] that left the window at `now`; forgets what is too old.
  void Add(Time now, std::span<const Eigen::Vector3d> landmarks);
  void Clear() { landmarks_.clear(); }

  /// Calls `visit` for each landmark within `radius` [m] of `p_W`, the oldest first.
  template <typename Visit>
  void ForEachNear(const Eigen::Vector3d& p_W, double radius, Visit visit) const {
    for (const Remembered& landmark : landmarks_)
      if ((landmark.p_W - p_W).squaredNorm() <= radius * radius) visit(landmark.p_W);
  }

 private:
  struct Remembered {
    Time left;
    Eigen::Vector3d p_W;
  };

  Duration span_;
  std::deque<Remembered> landmarks_;
};

}  // namespace drydock::svin2
