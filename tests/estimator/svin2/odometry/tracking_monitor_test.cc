#include "estimator/svin2/odometry/tracking_monitor.h"

#include <gtest/gtest.h>

namespace drydock::svin2 {
namespace {

using enum TrackingStatus;

TEST(TrackingMonitor, GoesBlindRecoversAndIsLostInTheEnd) {
  TrackingMonitor monitor({6, 15.0});
  EXPECT_EQ(monitor.Status(), kInitialising);
  EXPECT_EQ(monitor.Update(Time::FromSeconds(0), 50), kTracking);
  EXPECT_EQ(monitor.Update(Time::FromSeconds(1), 5), kDeadReckoning);
  EXPECT_EQ(monitor.Update(Time::FromSeconds(2), 6), kTracking);
  EXPECT_EQ(monitor.Update(Time::FromSeconds(17), 0), kDeadReckoning);
  EXPECT_EQ(monitor.Update(Time::FromSeconds(17.1), 0), kLost);
  // Landmarks seen from a pose that is not believed bring nothing back.
  EXPECT_EQ(monitor.Update(Time::FromSeconds(18), 100), kLost);
  monitor.Restart();
  EXPECT_EQ(monitor.Update(Time::FromSeconds(19), 100), kTracking);
}

TEST(TrackingMonitor, CountsFromTheFirstFrameIfNothingWasEverSeen) {
  TrackingMonitor monitor({6, 15.0});
  EXPECT_EQ(monitor.Update(Time::FromSeconds(100), 0), kDeadReckoning);
  EXPECT_EQ(monitor.Update(Time::FromSeconds(115.1), 0), kLost);
}

}  // namespace
}  // namespace drydock::svin2
