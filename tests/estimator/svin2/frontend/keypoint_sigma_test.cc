#include "estimator/svin2/frontend/keypoint_sigma.h"

#include <gtest/gtest.h>

namespace drydock::svin2 {
namespace {

TEST(KeypointSigma, GrowsAsNoiseOverContrast) {
  const KeypointSigma sigma{.recognised_px = 0.05, .per_unlikeness_px = 1.0};
  EXPECT_DOUBLE_EQ(sigma.Of(0, 1.0), 0.05);
  // Noise that is a third of the contrast, in one of two patches: 1 - c = 0.1.
  EXPECT_NEAR(sigma.Of(0, 0.9), 0.32, 0.01);
  // Twice the noise is four times the unlikeness.
  EXPECT_NEAR(sigma.Of(0, 0.6), 2.0 * sigma.Of(0, 0.9), 0.02);
  EXPECT_DOUBLE_EQ(sigma.Of(0, 1.0 + 1e-9), 0.05) << "rounding";
}

TEST(KeypointSigma, OfCoarsePointsIsInPixelsOfTheImage) {
  const KeypointSigma sigma{.recognised_px = 0.05, .per_unlikeness_px = 1.0, .coarse_px = 0.4};
  EXPECT_DOUBLE_EQ(sigma.Of(1, 0.75), 2.0 * sigma.Of(0, 0.75));
  EXPECT_DOUBLE_EQ(sigma.Of(2, 0.75), 4.0 * sigma.Of(0, 0.75));
  EXPECT_DOUBLE_EQ(sigma.Of(1, 1.0), 0.8);
  EXPECT_DOUBLE_EQ(sigma.Of(2, 1.0), 1.6);
}

}  // namespace
}  // namespace drydock::svin2
