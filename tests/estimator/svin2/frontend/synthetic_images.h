// Images with known sub-pixel geometry, for tests of the visual front end.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <vector>

#include <opencv2/core.hpp>

#include "sensors_models/base/random_stream.h"

namespace drydock::svin2::testing {

/// A smooth random texture, exact at every point of the plane: a sum of waves 8 to 40 px long.
/// Its values have mean 0 and standard deviation about 1.
class Texture {
 public:
  explicit Texture(std::uint64_t seed) {
    RandomStream random(seed, "texture");
    for (int i = 0; i < kWaves; ++i) {
      const double direction = random.Uniform(0.0, 2.0 * std::numbers::pi);
      const double length = random.Uniform(8.0, 40.0);
      const double k = 2.0 * std::numbers::pi / length;
      waves_.push_back({k * std::cos(direction), k * std::sin(direction),
                        random.Uniform(0.0, 2.0 * std::numbers::pi)});
    }
  }

  double operator()(const Eigen::Vector2d& p) const {
    double sum = 0.0;
    for (const Wave& wave : waves_) sum += std::sin(wave.kx * p.x() + wave.ky * p.y() + wave.phase);
    return sum / std::sqrt(0.5 * kWaves);
  }

 private:
  static constexpr int kWaves = 24;
  struct Wave {
    double kx, ky, phase;
  };
  std::vector<Wave> waves_;
};

/// `value` at each pixel's centre, rounded to a grey level, with white noise before if `noise` > 0.
inline cv::Mat Draw(int width, int height,
                    const std::function<double(const Eigen::Vector2d&)>& value, double noise = 0.0,
                    std::uint64_t seed = 1) {
  RandomStream random(seed, "image noise");
  cv::Mat image(height, width, CV_8UC1);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      double level = value(Eigen::Vector2d(x, y));
      if (noise > 0.0) level += noise * random.Gaussian();
      image.at<std::uint8_t>(y, x) =
          static_cast<std::uint8_t>(std::clamp(std::lround(level), 0L, 255L));
    }
  }
  return image;
}

}  // namespace drydock::svin2::testing
