#include "estimator/svin2/odometry/tracking_monitor.h"

#include <gtest/gtest.h>

namespace drydock::svin2 {
namespace {

using enum TrackingStatus;

TEST(TrackingMonitor, GoesBlindRecoversAndIsLostInTheEnd) {
  TrackingMonitor monitor({15.0});
  EXPECT_EQ(monitor.Status(), kInitialising);
  EXPECT_EQ(monitor.Update(Time::FromSeconds(0), true), kTracking);
  EXPECT_EQ(monitor.Update(Time::FromSeconds(1), false), kDeadReckoning);
  EXPECT_EQ(monitor.Update(Time::FromSeconds(2), true), kTracking);
  EXPECT_EQ(monitor.Update(Time::FromSeconds(17), false), kDeadReckoning);
  EXPECT_EQ(monitor.Update(Time::FromSeconds(17.1), false), kLost);
  // Landmarks seen from a pose that is not believed bring nothing back.
  EXPECT_EQ(monitor.Update(Time::FromSeconds(18), true), kLost);
  monitor.Restart();
  EXPECT_EQ(monitor.Update(Time::FromSeconds(19), true), kTracking);
}

TEST(TrackingMonitor, CountsFromTheFirstFrameIfNothingWasEverSeen) {
  TrackingMonitor monitor({15.0});
  EXPECT_EQ(monitor.Update(Time::FromSeconds(100), false), kDeadReckoning);
  EXPECT_EQ(monitor.Update(Time::FromSeconds(115.1), false), kLost);
}

}  // namespace
}  // namespace drydock::svin2
