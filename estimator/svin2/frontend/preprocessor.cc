#include "estimator/svin2/frontend/preprocessor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "sensors_models/base/check.h"

namespace drydock::svin2 {
namespace {

// Between rounding and the end, one grey level is this many steps (CV_16UC1).
constexpr int kFine = 256;

// The grey level [8 bit, with fractions] below which `share` of the pixels lie.
double Percentile(const std::array<std::int64_t, 256>& histogram, std::int64_t pixels,
                  double share) {
  const double wanted = share * static_cast<double>(pixels);
  double below = 0.0;
  for (int level = 0; level < 256; ++level) {
    const auto here = static_cast<double>(histogram[level]);
    if (here > 0.0 && below + here >= wanted) return level + (wanted - below) / here;
    below += here;
  }
  return 255.0;
}

std::array<std::int64_t, 256> Histogram(const cv::Mat& fine) {
  std::array<std::int64_t, 256> histogram{};
  for (int row = 0; row < fine.rows; ++row) {
    const auto* pixels = fine.ptr<std::uint16_t>(row);
    for (int column = 0; column < fine.cols; ++column) ++histogram[pixels[column] / kFine];
  }
  return histogram;
}

}  // namespace

Preprocessor::Preprocessor(const Config& config) : config_(config) {
  RequireInput(config.denoise_sigma_px >= 0.0 && config.denoise_sigma_px <= 5.0,
               "denoise_sigma_px is {}; it must lie in [0, 5]", config.denoise_sigma_px);
  RequireInput(config.background_sigma_px >= 0.0 && config.background_sigma_px <= 1000.0,
               "background_sigma_px is {}; it must lie in [0, 1000]", config.background_sigma_px);
  RequireInput(config.low_percentile >= 0.0 && config.low_percentile < config.high_percentile &&
                   config.high_percentile <= 100.0,
               "percentiles are {} and {}; they must rise within [0, 100]", config.low_percentile,
               config.high_percentile);
  RequireInput(config.max_gain >= 1.0, "max_gain is {}; it must be at least 1", config.max_gain);
  RequireInput(config.clahe_clip_limit >= 1.0 && config.clahe_tiles >= 1,
               "clahe_clip_limit is {} and clahe_tiles {}; both must be at least 1",
               config.clahe_clip_limit, config.clahe_tiles);
  clahe_ = cv::createCLAHE(config.clahe_clip_limit, {config.clahe_tiles, config.clahe_tiles});
}

// What is left lies about the middle of the codes.
cv::Mat Preprocessor::WithoutBackground(const cv::Mat& fine) const {
  // Blurred at an eighth of the size: as smooth, and for next to nothing.
  constexpr int kShrink = 8;
  cv::Mat background;
  const cv::Size small(std::max(fine.cols / kShrink, 1), std::max(fine.rows / kShrink, 1));
  cv::resize(fine, background, small, 0.0, 0.0, cv::INTER_AREA);
  cv::GaussianBlur(background, background, {}, config_.background_sigma_px / kShrink, 0.0,
                   cv::BORDER_REPLICATE);
  cv::resize(background, background, fine.size(), 0.0, 0.0, cv::INTER_LINEAR);
  cv::Mat detail;
  cv::addWeighted(fine, 1.0, background, -1.0, 128.0 * kFine, detail);
  return detail;
}

cv::Mat Preprocessor::AdjustContrast(const cv::Mat& fine) const {
  const auto histogram = Histogram(fine);
  const auto pixels = static_cast<std::int64_t>(fine.total());
  const double low = Percentile(histogram, pixels, config_.low_percentile / 100.0);
  const double high = Percentile(histogram, pixels, config_.high_percentile / 100.0);
  const double gain = std::clamp(255.0 / std::max(high - low, 1e-6), 1.0, config_.max_gain);
  // Where the gain is capped, the middle of the image's range stays at its place in the codes'.
  const double middle = 0.5 * (low + high);
  const double target = std::clamp(middle, 0.5 * gain * (high - low),
                                   std::max(255.0 - 0.5 * gain * (high - low), 0.0));
  cv::Mat adjusted;
  fine.convertTo(adjusted, CV_8U, gain / kFine, target - gain * middle);
  return adjusted;
}

cv::Mat Preprocessor::Process(const cv::Mat& image, int halvings) {
  Check(!image.empty() && (image.type() == CV_8UC1 || image.type() == CV_8UC3),
        "the front end takes images of type CV_8UC1 or CV_8UC3");
  cv::Mat grey;
  if (image.channels() == 3) {
    cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  } else {
    grey = image;
  }
  cv::Mat fine;
  grey.convertTo(fine, CV_16U, kFine);
  for (int k = 0; k < halvings; ++k) cv::pyrDown(fine, fine);
  if (config_.denoise_sigma_px > 0.0) {
    const int radius = std::max(1, static_cast<int>(std::lround(2.5 * config_.denoise_sigma_px)));
    cv::GaussianBlur(fine, fine, {2 * radius + 1, 2 * radius + 1}, config_.denoise_sigma_px,
                     config_.denoise_sigma_px, cv::BORDER_REPLICATE);
  }
  if (config_.background_sigma_px > 0.0) fine = WithoutBackground(fine);
  cv::Mat result;
  if (config_.adjust_contrast) {
    result = AdjustContrast(fine);
  } else {
    fine.convertTo(result, CV_8U, 1.0 / kFine);
  }
  if (config_.clahe) clahe_->apply(result, result);
  return result;
}

}  // namespace drydock::svin2
