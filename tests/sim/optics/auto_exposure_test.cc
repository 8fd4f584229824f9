#include "sim/optics/auto_exposure.h"

#include <cmath>

#include <gtest/gtest.h>

namespace drydock::sim {
namespace {

ImagerSheet Imager() {
  ImagerSheet imager;
  imager.sensitivity_per_s = 1000.0;
  imager.shutter_max_s = 0.01;
  imager.gain_max_db = 20.0;
  imager.auto_exposure_target = 0.2;
  imager.auto_exposure_time_s = 0.5;
  return imager;
}

class StepResponse : public ::testing::TestWithParam<double> {};

// The light falls to a quarter: the logarithm of the exposure approaches its new aim as 1 -
// exp(-t/tau), in seconds, whatever the frame rate. The step counts from the first frame that saw
// it.
TEST_P(StepResponse, IsExponentialInSeconds) {
  const ImagerSheet imager = Imager();
  AutoExposure control(imager, std::nullopt);
  const double rate_hz = GetParam();
  const double before = control.Next(SampleTime(Time{}, 0, rate_hz), 0.4).Scale(imager);
  EXPECT_NEAR(before, 0.5, 1e-12);
  for (int k = 1; k <= static_cast<int>(3.0 * rate_hz); ++k) {
    const double scale = control.Next(SampleTime(Time{}, k, rate_hz), 0.1).Scale(imager);
    const double seconds = (k - 1) / rate_hz;
    const double share = 1.0 - std::exp(-seconds / imager.auto_exposure_time_s);
    EXPECT_NEAR(std::log(scale / before), share * std::log(4.0), 1e-6) << seconds << " s";
  }
}

INSTANTIATE_TEST_SUITE_P(FrameRates, StepResponse, ::testing::Values(4.0, 15.0, 60.0));

TEST(AutoExposure, StaysWithinTheSheet) {
  const ImagerSheet imager = Imager();
  const AutoExposure control(imager, std::nullopt);
  const Exposure night = control.Settled(1e-8);
  EXPECT_DOUBLE_EQ(night.shutter_s, 0.01);
  EXPECT_NEAR(night.gain, 10.0, 1e-9);
  EXPECT_LE(control.Settled(1e9).gain, 1.0);
  EXPECT_GT(control.Settled(0.0).shutter_s, 0.0);
}

TEST(AutoExposure, FixedIsFixed) {
  const ImagerSheet imager = Imager();
  AutoExposure control(imager, 1.6);
  EXPECT_NEAR(control.Next(Time::FromSeconds(0.0), 0.4).Scale(imager), 1.6, 1e-12);
  EXPECT_NEAR(control.Next(Time::FromSeconds(9.0), 0.01).Scale(imager), 1.6, 1e-12);
}

TEST(MeterLight, IsTheMean) {
  cv::Mat light(64, 64, CV_32FC1, cv::Scalar(0.2));
  light.colRange(0, 32).setTo(0.6);
  EXPECT_NEAR(MeterLight(light), 0.4, 1e-6);
  EXPECT_NEAR(MeterLight(cv::Mat(64, 64, CV_32FC3, cv::Scalar(0.1, 0.2, 0.6))), 0.3, 1e-6);
}

}  // namespace
}  // namespace drydock::sim
