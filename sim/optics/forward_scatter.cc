#include "sim/optics/forward_scatter.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <opencv2/imgproc.hpp>

#include "sim/optics/optics_rows.h"

namespace drydock::sim {
namespace {

constexpr int kSharpest = 1;
constexpr int kMostBlurred = 5;

double ScatteringPerMetre(const WaterConfig& water) {
  return (ScatteringAlbedo(water) * BeamAttenuation(water))[1];
}

}  // namespace

// Each reduction filters with (1 4 6 4 1) / 16, of variance 1 of the pixels it works on; linear
// interpolation over a spacing s has the variance s^2 / 6.
double ForwardScatter::LayerVariance(int level) {
  const double spacing2 = std::pow(4.0, level);
  return (spacing2 - 1.0) / 3.0 + spacing2 / 6.0;
}

ForwardScatter::ForwardScatter(const WaterConfig& water, double focal)
    : scattering_(static_cast<float>(water.forward_scatter * ScatteringPerMetre(water))) {
  const double bend = focal * water.forward_scatter_deg * std::numbers::pi / 180.0;
  variance_ = static_cast<float>(bend * bend / 3.0);
  level_ = kSharpest;
  while (level_ + 1 < kMostBlurred && LayerVariance(level_ + 1) < variance_) ++level_;
}

void ForwardScatter::Upsample(std::size_t layer, int row, int width) {
  const int level = level_ + static_cast<int>(layer);
  const int spacing = 1 << level;
  const cv::Mat& image = pyramid_[static_cast<std::size_t>(level)];
  const int above = row / spacing;
  const int below = std::min(above + 1, image.rows - 1);
  const int count = (width + spacing - 1) / spacing;
  std::vector<float>& coarse = coarse_[layer];
  coarse.resize(static_cast<std::size_t>(std::max(count + 1, image.cols)));
  rows::Interpolate(image.cols, image.ptr<float>(above), image.ptr<float>(below),
                    static_cast<float>(row % spacing) / static_cast<float>(spacing), coarse.data());
  for (std::size_t i = static_cast<std::size_t>(image.cols); i < coarse.size(); ++i)
    coarse[i] = coarse[i - 1];
  fine_[layer].resize(static_cast<std::size_t>(count) * static_cast<std::size_t>(spacing));
  rows::Stretch(count, spacing, coarse.data(), fine_[layer].data());
}

void ForwardScatter::AddTo(const cv::Mat& direct, const cv::Mat& range, cv::Mat& radiance) {
  if (scattering_ == 0.F) {
    radiance += direct;
    return;
  }
  pyramid_.resize(static_cast<std::size_t>(level_) + 2);
  pyramid_[0] = direct;
  for (std::size_t i = 1; i < pyramid_.size(); ++i)
    cv::pyrDown(pyramid_[i - 1], pyramid_[i], {}, cv::BORDER_REPLICATE);
  const double less = LayerVariance(level_), more = LayerVariance(level_ + 1);
  const rows::BlurMix mix{scattering_, variance_, static_cast<float>(less),
                          static_cast<float>(1.0 / (more - less))};
  for (int v = 0; v < direct.rows; ++v) {
    for (std::size_t layer = 0; layer < 2; ++layer) Upsample(layer, v, direct.cols);
    rows::AddBlurred(direct.cols, mix, range.ptr<float>(v), direct.ptr<float>(v), fine_[0].data(),
                     fine_[1].data(), radiance.ptr<float>(v));
  }
}

}  // namespace drydock::sim
