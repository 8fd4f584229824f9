#include "sim/optics/image_sensor.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

namespace drydock::sim {
namespace {

ImagerSheet LinearImager() {
  ImagerSheet imager;
  imager.gamma = 1.0;
  imager.sensitivity_per_s = 1000.0;
  imager.shutter_max_s = 0.01;
  return imager;
}

CameraIntrinsics Camera(int width, int height) {
  CameraIntrinsics camera;
  camera.width = width;
  camera.height = height;
  camera.fx = camera.fy = 100.0;
  camera.cx = (width - 1) / 2.0;
  camera.cy = (height - 1) / 2.0;
  return camera;
}

cv::Mat Expose(const ImagerSheet& imager, const cv::Mat& light, double scale,
               std::int64_t index = 0, const std::string& stream = "cam0/noise",
               const ImageSensorConfig& config = {}) {
  const ImageSensor sensor(imager, config, Camera(light.cols, light.rows), 1, stream);
  cv::Mat image;
  sensor.Expose(light, ExposureOfScale(scale, imager), index, image);
  return image;
}

/// Mean and variance of an image of even light, in shares of full scale.
std::pair<double, double> Statistics(const cv::Mat& image) {
  cv::Scalar mean, sigma;
  cv::meanStdDev(image, mean, sigma);
  return {mean[0] / 255.0, sigma[0] * sigma[0] / 255.0 / 255.0};
}

TEST(Exposure, TheShutterComesBeforeTheGain) {
  const ImagerSheet imager = LinearImager();
  const Exposure bright = ExposureOfScale(4.0, imager);
  EXPECT_DOUBLE_EQ(bright.shutter_s, 0.004);
  EXPECT_DOUBLE_EQ(bright.gain, 1.0);
  const Exposure dark = ExposureOfScale(80.0, imager);
  EXPECT_DOUBLE_EQ(dark.shutter_s, 0.01);
  EXPECT_DOUBLE_EQ(dark.gain, 8.0);
  EXPECT_DOUBLE_EQ(dark.Scale(imager), 80.0);
}

TEST(ImageSensor, CodesFollowTheGammaCurve) {
  ImagerSheet imager = LinearImager();
  imager.gamma = 2.2;
  cv::Mat light(1, 5, CV_32FC1);
  light.at<float>(0, 0) = 0.F;
  light.at<float>(0, 1) = 0.001F;
  light.at<float>(0, 2) = 0.45F;
  light.at<float>(0, 3) = 7.F;  // Far beyond saturation.
  light.at<float>(0, 4) = 0.1F;
  const cv::Mat image = Expose(imager, light, 2.0);
  ASSERT_EQ(image.type(), CV_8UC1);
  EXPECT_EQ(image.at<unsigned char>(0, 0), 0);
  EXPECT_NEAR(image.at<unsigned char>(0, 1), 255.0 * std::pow(0.002, 1 / 2.2), 0.6);
  EXPECT_NEAR(image.at<unsigned char>(0, 2), 255.0 * std::pow(0.9, 1 / 2.2), 0.6);
  EXPECT_EQ(image.at<unsigned char>(0, 3), 255);
  EXPECT_NEAR(image.at<unsigned char>(0, 4), 255.0 * std::pow(0.2, 1 / 2.2), 0.6);
}

TEST(ImageSensor, ColourComesOutAsBgr) {
  const cv::Mat light(1, 1, CV_32FC3, cv::Scalar(0.9, 0.5, 0.1));  // Red, green, blue.
  const cv::Mat image = Expose(LinearImager(), light, 1.0);
  ASSERT_EQ(image.type(), CV_8UC3);
  const auto& pixel = image.at<cv::Vec3b>(0, 0);
  EXPECT_NEAR(pixel[0], 25.5, 1.0);
  EXPECT_NEAR(pixel[1], 127.5, 1.0);
  EXPECT_NEAR(pixel[2], 229.5, 1.0);
}

// Of N electrons of full well F the variance is N + read^2; in shares of F, x / F + (read / F)^2,
// and 1 / 12 of a grey level squared for the rounding.
TEST(ImageSensor, NoiseIsThatOfElectrons) {
  ImagerSheet imager = LinearImager();
  imager.full_well_e = 2000.0;
  imager.read_noise_e = 20.0;
  const double rounding = 1.0 / 12.0 / 255.0 / 255.0;
  for (const double gain : {1.0, 3.0}) {
    for (const double share : {0.3, 0.6}) {
      const double scale = gain * imager.sensitivity_per_s * imager.shutter_max_s;
      const cv::Mat light(300, 400, CV_32FC1, cv::Scalar(share / scale));
      const auto [mean, variance] = Statistics(Expose(imager, light, scale));
      const double a = gain / 2000.0;
      const double expected = share * a + std::pow(20.0 * a, 2.0) + rounding;
      EXPECT_NEAR(mean, share, 4.0 * std::sqrt(expected / 120'000.0) + 2e-4);
      EXPECT_NEAR(variance / expected, 1.0, 0.03) << gain << " " << share;
    }
  }
}

TEST(ImageSensor, NoiseIsThatOfFrameAndEye) {
  ImagerSheet imager = LinearImager();
  imager.full_well_e = 1000.0;
  const cv::Mat light(40, 60, CV_32FC1, cv::Scalar(0.4));
  const auto same = [](const cv::Mat& a, const cv::Mat& b) { return cv::norm(a, b) == 0.0; };
  const cv::Mat first = Expose(imager, light, 1.0, 7);
  EXPECT_TRUE(same(first, Expose(imager, light, 1.0, 7)));
  EXPECT_FALSE(same(first, Expose(imager, light, 1.0, 8)));
  EXPECT_FALSE(same(first, Expose(imager, light, 1.0, 7, "cam1/noise")));
}

// Neighbouring pixels, rows and frames have nothing to do with each other.
TEST(ImageSensor, NoiseIsWhite) {
  ImagerSheet imager = LinearImager();
  imager.full_well_e = 500.0;
  const cv::Mat light(400, 400, CV_32FC1, cv::Scalar(0.5));
  cv::Mat noise, next;
  Expose(imager, light, 1.0, 0).convertTo(noise, CV_64F);
  Expose(imager, light, 1.0, 1).convertTo(next, CV_64F);
  noise -= cv::mean(noise);
  next -= cv::mean(next);
  const auto part = [](const cv::Mat& image, int right, int down) {
    return image(cv::Rect(right, down, 399, 399));
  };
  const double power = noise.dot(noise);
  // The sum over 160 000 products has a standard deviation of power / 400.
  EXPECT_LT(std::abs(part(noise, 0, 0).dot(part(noise, 1, 0))), 4.0 * power / 400.0);
  EXPECT_LT(std::abs(part(noise, 0, 0).dot(part(noise, 0, 1))), 4.0 * power / 400.0);
  EXPECT_LT(std::abs(noise.dot(next)), 4.0 * power / 400.0);
}

TEST(ImageSensor, NoiseCanBeSwitchedOff) {
  ImagerSheet imager = LinearImager();
  imager.full_well_e = 100.0;
  ImageSensorConfig config;
  config.noise = false;
  const cv::Mat light(40, 60, CV_32FC1, cv::Scalar(0.4));
  EXPECT_EQ(Statistics(Expose(imager, light, 1.0, 0, "cam0/noise", config)).second, 0.0);
}

TEST(ImageSensor, VignettingFallsOffAsCosineToTheFourth) {
  ImagerSheet imager = LinearImager();
  imager.vignetting = 1.0;
  const cv::Mat light(101, 201, CV_32FC1, cv::Scalar(0.9));
  const cv::Mat image = Expose(imager, light, 1.0);
  EXPECT_NEAR(image.at<unsigned char>(50, 100), 0.9 * 255.0, 0.6);
  // The middle of the right edge lies 100 px out at a focal length of 100 px: 45 degrees.
  EXPECT_NEAR(image.at<unsigned char>(50, 200),
              0.9 * 255.0 * std::pow(std::cos(std::numbers::pi / 4.0), 4.0), 0.6);
  ImageSensorConfig config;
  config.vignetting = false;
  EXPECT_EQ(Statistics(Expose(imager, light, 1.0, 0, "cam0/noise", config)).second, 0.0);
}

}  // namespace
}  // namespace drydock::sim
