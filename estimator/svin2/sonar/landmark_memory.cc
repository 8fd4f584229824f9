#include "estimator/svin2/sonar/landmark_memory.h"

namespace drydock::svin2 {

void LandmarkMemory::Add(Time now, std::span<const Eigen::Vector3d> landmarks) {
  for (const Eigen::Vector3d& p_W : landmarks) landmarks_.push_back({now, p_W});
  while (!landmarks_.empty() && now - landmarks_.front().left > span_) landmarks_.pop_front();
}

}  // namespace drydock::svin2
