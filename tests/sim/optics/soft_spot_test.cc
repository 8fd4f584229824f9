#include "sim/optics/soft_spot.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace drydock::sim {
namespace {

/// What a white spot covers of a black image.
cv::Mat Cover(const SoftSpot& spot, float depth = 10.F) {
  const cv::Mat depths(60, 80, CV_32FC1, cv::Scalar(depth));
  cv::Mat radiance(60, 80, CV_32FC1, cv::Scalar(0.0));
  SpotPainter(depths, radiance).Draw(spot, {{1.F}, {1.F}});
  return radiance;
}

SoftSpot Spot(double u, double v, double half_along, double half_across) {
  SoftSpot spot;
  spot.u = u;
  spot.v = v;
  spot.half_along = half_along;
  spot.half_across = half_across;
  spot.edge = 2.5;
  spot.depth = 1.0;
  return spot;
}

TEST(SoftSpot, CoversItsAreaWhereverItLies) {
  for (const double size : {0.05, 0.3, 1.0, 3.0, 9.0}) {
    for (const double off : {0.0, 0.2, 0.5, 0.8}) {
      SoftSpot spot = Spot(40.0 + off, 30.0 + 0.7 * off, size, 0.6 * size);
      spot.along_u = 0.8;
      spot.along_v = 0.6;
      spot.lobe_cos = 0.1;
      spot.lobe_sin = 0.1;
      const double area = std::numbers::pi * size * 0.6 * size;
      EXPECT_NEAR(cv::sum(Cover(spot))[0] / area, 1.0, 0.01) << size << " px, off " << off;
    }
  }
}

TEST(SoftSpot, HasItsMiddleBetweenPixels) {
  for (const double off : {0.0, 0.2, 0.5, 0.8}) {
    const cv::Mat cover = Cover(Spot(40.0 + off, 30.0 - off, 0.4, 0.4));
    const cv::Moments moments = cv::moments(cover);
    EXPECT_NEAR(moments.m10 / moments.m00, 40.0 + off, 0.05);
    EXPECT_NEAR(moments.m01 / moments.m00, 30.0 - off, 0.05);
  }
}

TEST(SoftSpot, IsAsLongAsSaidAlongItsAxis) {
  SoftSpot spot = Spot(40.0, 30.0, 12.0, 4.0);
  spot.along_u = 0.0;
  spot.along_v = 1.0;
  spot.edge = 1.0;
  const cv::Mat cover = Cover(spot);
  EXPECT_NEAR(cover.at<float>(30, 40), 1.0, 0.02);
  EXPECT_NEAR(cover.at<float>(30 + 10, 40), 1.0, 0.02);
  EXPECT_EQ(cover.at<float>(30 + 14, 40), 0.F);
  EXPECT_NEAR(cover.at<float>(30, 40 + 3), 1.0, 0.02);
  EXPECT_EQ(cover.at<float>(30, 40 + 6), 0.F);
}

TEST(SoftSpot, IsCutOffAtTheBorder) {
  const double whole = cv::sum(Cover(Spot(40.0, 30.0, 5.0, 5.0)))[0];
  EXPECT_NEAR(cv::sum(Cover(Spot(-0.5, 30.0, 5.0, 5.0)))[0] / whole, 0.5, 0.01);
  EXPECT_EQ(cv::sum(Cover(Spot(-20.0, 30.0, 5.0, 5.0)))[0], 0.0);
  EXPECT_EQ(cv::sum(Cover(Spot(40.0, 90.0, 5.0, 5.0)))[0], 0.0);
}

TEST(SoftSpot, IsHiddenByWhatIsNearer) {
  EXPECT_GT(cv::sum(Cover(Spot(40.0, 30.0, 2.0, 2.0), 1.01F))[0], 1.0);
  EXPECT_EQ(cv::sum(Cover(Spot(40.0, 30.0, 2.0, 2.0), 0.99F))[0], 0.0);
}

}  // namespace
}  // namespace drydock::sim
