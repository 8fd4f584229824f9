// A body that does not move.
#pragma once

#include "sim/motion/motion.h"

namespace drydock::sim {

class StillMotion final : public Motion {
 public:
  explicit StillMotion(const Pose& T_WI, Time end = Time::FromSeconds(10.0)) : end_(end) {
    state_.T_WI = T_WI;
  }

  MotionState At(Time) const override { return state_; }
  Time End() const override { return end_; }

 private:
  MotionState state_;
  Time end_;
};

}  // namespace drydock::sim
