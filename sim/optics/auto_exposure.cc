#include "sim/optics/auto_exposure.h"

#include <algorithm>
#include <cmath>

#include "sensors_models/base/check.h"

namespace drydock::sim {
namespace {

constexpr int kRaster = 8;          // [px]
constexpr double kDarkest = 1e-9;   // Radiance that stands for none at all.
constexpr double kShortest = 1e-6;  // Shutter [s].

}  // namespace

double MeterLight(const cv::Mat& radiance) {
  const int channels = radiance.channels();
  double sum = 0.0;
  std::int64_t count = 0;
  for (int v = kRaster / 2; v < radiance.rows; v += kRaster) {
    const auto* row = radiance.ptr<float>(v);
    for (int u = kRaster / 2; u < radiance.cols; u += kRaster) {
      for (int k = 0; k < channels; ++k) sum += static_cast<double>(row[channels * u + k]);
      count += channels;
    }
  }
  return count == 0 ? 0.0 : sum / static_cast<double>(count);
}

AutoExposure::AutoExposure(const ImagerSheet& imager, std::optional<double> fixed)
    : imager_(imager), fixed_(fixed) {}

double AutoExposure::Aim(double light) const {
  const double least = imager_.sensitivity_per_s * kShortest;
  const double most = imager_.sensitivity_per_s * imager_.shutter_max_s *
                      std::pow(10.0, imager_.gain_max_db / 20.0);
  return std::clamp(imager_.auto_exposure_target / std::max(light, kDarkest), least, most);
}

Exposure AutoExposure::Settled(double light) const {
  return ExposureOfScale(fixed_ ? *fixed_ : Aim(light), imager_);
}

Exposure AutoExposure::Next(Time t, double light) {
  if (!last_time_) {
    log_scale_ = std::log(Aim(light));
  } else {
    Check(t > *last_time_, "exposures must follow each other in time");
    const double dt = (t - *last_time_).Seconds();
    const double lag = imager_.auto_exposure_time_s;
    const double share = lag > 0.0 ? -std::expm1(-dt / lag) : 1.0;
    log_scale_ += share * (std::log(Aim(last_light_)) - log_scale_);
  }
  last_time_ = t;
  last_light_ = light;
  return ExposureOfScale(fixed_ ? *fixed_ : std::exp(log_scale_), imager_);
}

}  // namespace drydock::sim
