#include "sim/optics/image_sensor.h"

#include <cmath>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

namespace drydock::sim {
namespace {

TEST(ImageSensor, CodesFollowTheGammaCurve) {
  const ImageSensor sensor({.color = false, .exposure = 2.0, .gamma = 2.2});
  cv::Mat light(1, 4, CV_32FC1), image;
  light.at<float>(0, 0) = 0.F;
  light.at<float>(0, 1) = 0.1F;
  light.at<float>(0, 2) = 0.45F;
  light.at<float>(0, 3) = 7.F;  // Far beyond saturation.
  sensor.Expose(light, image);
  ASSERT_EQ(image.type(), CV_8UC1);
  EXPECT_LE(image.at<unsigned char>(0, 0), 5);
  EXPECT_NEAR(image.at<unsigned char>(0, 1), 255.0 * std::pow(0.2, 1 / 2.2), 1.0);
  EXPECT_NEAR(image.at<unsigned char>(0, 2), 255.0 * std::pow(0.9, 1 / 2.2), 1.0);
  EXPECT_EQ(image.at<unsigned char>(0, 3), 255);
}

TEST(ImageSensor, ColourComesOutAsBgr) {
  const ImageSensor sensor({.color = true, .exposure = 1.0, .gamma = 1.0});
  cv::Mat light(1, 1, CV_32FC3, cv::Scalar(0.9, 0.5, 0.1)), image;  // Red, green, blue.
  sensor.Expose(light, image);
  ASSERT_EQ(image.type(), CV_8UC3);
  const auto pixel = image.at<cv::Vec3b>(0, 0);
  EXPECT_NEAR(pixel[0], 25.5, 1.0);
  EXPECT_NEAR(pixel[1], 127.5, 1.0);
  EXPECT_NEAR(pixel[2], 229.5, 1.0);
}

}  // namespace
}  // namespace drydock::sim
