#include "estimator/svin2/sonar/landmark_memory.h"

#include <vector>

#include <gtest/gtest.h>

namespace drydock::svin2 {
namespace {

using Eigen::Vector3d;

std::vector<Vector3d> Near(const LandmarkMemory& memory, const Vector3d& p_W, double radius) {
  std::vector<Vector3d> found;
  memory.ForEachNear(p_W, radius, [&](const Vector3d& landmark) { found.push_back(landmark); });
  return found;
}

TEST(LandmarkMemory, FindsWhatIsNearTheOldestFirst) {
  LandmarkMemory memory(Duration::FromSeconds(15));
  memory.Add(Time::FromSeconds(1), std::vector<Vector3d>{{1, 0, 0}, {5, 0, 0}});
  memory.Add(Time::FromSeconds(2), std::vector<Vector3d>{{1.1, 0, 0}});
  const auto found = Near(memory, {1, 0, 0}, 0.2);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0], Vector3d(1, 0, 0));
  EXPECT_EQ(found[1], Vector3d(1.1, 0, 0));
}

TEST(LandmarkMemory, ForgetsAfterItsSpan) {
  LandmarkMemory memory(Duration::FromSeconds(15));
  memory.Add(Time::FromSeconds(1), std::vector<Vector3d>{{1, 0, 0}});
  memory.Add(Time::FromSeconds(16), {});
  EXPECT_EQ(Near(memory, {1, 0, 0}, 1.0).size(), 1U);
  memory.Add(Time::FromSeconds(16.1), {});
  EXPECT_TRUE(Near(memory, {1, 0, 0}, 1.0).empty());
}

}  // namespace
}  // namespace drydock::svin2
