#include "sim/optics/image_sensor.h"

#include <algorithm>
#include <cmath>

namespace drydock::sim {

ImageSensorConfig ReadImageSensor(YamlReader& yaml) {
  ImageSensorConfig config;
  config.color = yaml.Boolean("color", config.color);
  config.exposure = yaml.Real("exposure", {1e-3, 1e3}, config.exposure);
  config.gamma = yaml.Real("gamma", {0.5, 4.0}, config.gamma);
  return config;
}

ImageSensor::ImageSensor(const ImageSensorConfig& config)
    : scale_(static_cast<float>(config.exposure * kCodes)) {
  for (int i = 0; i < kCodes; ++i) {
    const double coded = std::pow((i + 0.5) / kCodes, 1.0 / config.gamma);
    code_.push_back(static_cast<unsigned char>(std::lround(255.0 * coded)));
  }
}

void ImageSensor::Expose(const cv::Mat& radiance, cv::Mat& image) const {
  const int channels = radiance.channels();
  image.create(radiance.size(), CV_8UC(channels));
  const auto to_code = [this](float light) {
    return code_[static_cast<std::size_t>(std::clamp(light * scale_, 0.F, kCodes - 1.F))];
  };
  for (int v = 0; v < radiance.rows; ++v) {
    const auto* in = radiance.ptr<float>(v);
    auto* out = image.ptr<unsigned char>(v);
    for (int u = 0; u < radiance.cols; ++u) {
      // OpenCV's order is blue, green, red.
      for (int k = 0; k < channels; ++k)
        out[channels * u + channels - 1 - k] = to_code(in[channels * u + k]);
    }
  }
}

}  // namespace drydock::sim
