#include "sim/optics/image_sensor.h"

#include <algorithm>
#include <cmath>

#include "sensors_models/base/check.h"
#include "sensors_models/models/camera_model.h"
#include "sim/optics/sensor_rows.h"

namespace drydock::sim {
namespace {

cv::Mat Falloff(const CameraIntrinsics& intrinsics, double vignetting) {
  cv::Mat falloff(intrinsics.height, intrinsics.width, CV_32FC1, cv::Scalar(1.0));
  if (vignetting == 0.0) return falloff;
  const CameraModel camera(intrinsics);
  for (int v = 0; v < falloff.rows; ++v) {
    for (int u = 0; u < falloff.cols; ++u) {
      // cos^4 of the field angle is (1 + tan^2)^-2. Lens has refused views that do not unproject.
      const auto point = camera.Unproject({u, v});
      const double tan2 = point ? point->squaredNorm() : 0.0;
      falloff.at<float>(v, u) = static_cast<float>(std::pow(1.0 + tan2, -2.0 * vignetting));
    }
  }
  return falloff;
}

}  // namespace

ImageSensorConfig ReadImageSensor(YamlReader& yaml) {
  ImageSensorConfig config;
  config.color = yaml.Boolean("color", config.color);
  if (yaml.Has("exposure")) config.exposure = yaml.Real("exposure", {1e-3, 1e6});
  config.noise = yaml.Boolean("noise", config.noise);
  config.vignetting = yaml.Boolean("vignetting", config.vignetting);
  return config;
}

Exposure ExposureOfScale(double scale, const ImagerSheet& imager) {
  Exposure exposure;
  exposure.shutter_s = std::min(scale / imager.sensitivity_per_s, imager.shutter_max_s);
  exposure.gain = scale / (imager.sensitivity_per_s * exposure.shutter_s);
  return exposure;
}

ImageSensor::ImageSensor(const ImagerSheet& imager, const ImageSensorConfig& config,
                         const CameraIntrinsics& camera, std::uint64_t seed,
                         const std::string& stream)
    : imager_(imager),
      noise_(config.noise && imager.full_well_e > 0.0),
      stream_(seed, stream),
      falloff_(Falloff(camera, config.vignetting ? imager.vignetting : 0.0)) {
  for (std::size_t i = 0; i < code_.size(); ++i) {
    const double light = std::pow(static_cast<double>(i) / (kCodes - 1), 2.0);
    code_[i] = static_cast<unsigned char>(std::lround(255.0 * std::pow(light, 1.0 / imager.gamma)));
  }
}

void ImageSensor::Expose(const cv::Mat& radiance, const Exposure& exposure, std::int64_t index,
                         cv::Mat& image) const {
  Check(radiance.size() == falloff_.size(), "the sensor needs an image of its camera's size");
  const int width = radiance.cols, channels = radiance.channels();
  image.create(radiance.size(), CV_8UC(channels));
  const double per_electron = noise_ ? exposure.gain / imager_.full_well_e : 0.0;
  rows::SensorRow row;
  row.scale = static_cast<float>(exposure.Scale(imager_));
  row.shot = static_cast<float>(per_electron);
  row.read = static_cast<float>(std::pow(imager_.read_noise_e * per_electron, 2.0));
  row.last_code = kCodes - 1;

  const auto samples = static_cast<std::size_t>(width);
  std::vector<float> light(samples);
  std::vector<int> codes(samples);
  for (int v = 0; v < radiance.rows; ++v) {
    // One key for each row and channel of each frame.
    const std::uint64_t bits =
        stream_.BitsAt(static_cast<std::uint64_t>(index) * 65536U + static_cast<std::uint64_t>(v));
    const auto* in = radiance.ptr<float>(v);
    auto* out = image.ptr<unsigned char>(v);
    for (int k = 0; k < channels; ++k) {
      for (std::size_t u = 0; u < samples; ++u)
        light[u] = in[static_cast<std::size_t>(channels) * u + static_cast<std::size_t>(k)];
      row.key = static_cast<std::uint32_t>(bits >> (16 * k));
      rows::Read(row, width, light.data(), falloff_.ptr<float>(v), codes.data());
      // OpenCV's order is blue, green, red.
      for (int u = 0; u < width; ++u)
        out[channels * u + channels - 1 - k] =
            code_[static_cast<std::size_t>(codes[static_cast<std::size_t>(u)])];
    }
  }
}

}  // namespace drydock::sim
