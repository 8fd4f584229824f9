#include "sensors_models/models/sonar_peaks.h"

#include <vector>

#include <gtest/gtest.h>

namespace drydock {
namespace {

TEST(SonarPeaks, FirstAndStrongestDiffer) {
  const std::vector<double> profile = {0.01, 0.3, 0.0, 0.05, 0.8, 0.7, 0.8};
  const auto peaks = FindSonarPeaks(profile, 0.1);
  ASSERT_TRUE(peaks);
  EXPECT_EQ(peaks->first, 1U);
  EXPECT_EQ(peaks->strongest, 4U) << "the nearer one of two";
}

TEST(SonarPeaks, OnlyWhatIsAboveTheFloorCounts) {
  const std::vector<double> profile = {0.1, 0.2, 0.3};
  EXPECT_EQ(FindSonarPeaks(profile, 0.2)->first, 2U);
  EXPECT_FALSE(FindSonarPeaks(profile, 0.3));
  EXPECT_FALSE(FindSonarPeaks(std::vector<double>(5, 0.0), 0.0));
  EXPECT_FALSE(FindSonarPeaks({}, 0.0));
}

}  // namespace
}  // namespace drydock
