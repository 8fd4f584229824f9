#include "scenes/texture/canvas.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "sensors_models/base/check.h"
#include "sensors_models/base/random_stream.h"

namespace drydock::scenes {
namespace {

std::uint8_t Toward(int from, int to, int alpha) {
  // alpha in 0..256; exact at both ends.
  return static_cast<std::uint8_t>(from + (((to - from) * alpha) >> 8));
}

int Alpha256(double alpha) {
  return static_cast<int>(std::lround(256.0 * std::clamp(alpha, 0.0, 1.0)));
}

template <typename RowFunction>
void ForRows(int rows, const RowFunction& function) {
  cv::parallel_for_(cv::Range(0, rows), [&](const cv::Range& range) {
    for (int y = range.start; y < range.end; ++y) function(y);
  });
}

}  // namespace

NoiseKeys::NoiseKeys(std::uint64_t seed, std::string_view texture)
    : base_(RandomStream(seed, "texture/" + std::string(texture)).BitsAt(0)) {}

std::uint64_t NoiseKeys::Key(std::string_view name) const {
  return RandomStream(base_, name).BitsAt(0);
}

Canvas::Canvas(double width, double height, double pixels_per_metre, const Rgb& color, bool wrap)
    : width_(width),
      height_(height),
      scale_(pixels_per_metre),
      wrap_(wrap),
      image_(std::max(1, static_cast<int>(std::lround(height * pixels_per_metre))),
             std::max(1, static_cast<int>(std::lround(width * pixels_per_metre))), color) {}

cv::Point Canvas::Fixed(double x, double y) const { return {FixedLength(x), FixedLength(y)}; }

int Canvas::FixedLength(double metres) const {
  return static_cast<int>(std::lround(metres * scale_ * (1 << kShift)));
}

int Canvas::Pixels(double metres) const {
  return std::max(1, static_cast<int>(std::lround(metres * scale_)));
}

cv::Mat1f Canvas::Noise(double largest, double smallest, double gain, std::uint64_t key,
                        double stretch_y) const {
  // Below three pixels a cell, noise is white: nothing a mipmap would keep.
  const double floor = std::max(smallest * scale_, 2.0);
  return NoiseField(size(), {std::max(largest * scale_, floor), floor, gain, stretch_y, wrap_},
                    key);
}

void Canvas::Blend(const cv::Mat1b& mask, const Rgb& color, double alpha) {
  const int alpha256 = Alpha256(alpha);
  ForRows(image_.rows, [&](int y) {
    const std::uint8_t* m = mask[y];
    Rgb* out = image_[y];
    for (int x = 0; x < image_.cols; ++x) {
      if (m[x] == 0) continue;
      const int a = ((m[x] + (m[x] >> 7)) * alpha256) >> 8;
      for (int c = 0; c < 3; ++c) out[x][c] = Toward(out[x][c], color[c], a);
    }
  });
}

void Canvas::Blend(const cv::Mat1b& mask, const cv::Mat1f& mix, const Rgb& low, const Rgb& high,
                   double alpha) {
  const int alpha256 = Alpha256(alpha);
  ForRows(image_.rows, [&](int y) {
    const std::uint8_t* m = mask[y];
    const float* f = mix[y];
    Rgb* out = image_[y];
    for (int x = 0; x < image_.cols; ++x) {
      if (m[x] == 0) continue;
      const int a = ((m[x] + (m[x] >> 7)) * alpha256) >> 8;
      const int t = std::clamp(static_cast<int>((f[x] + 2.0F) * 64.0F), 0, 256);
      for (int c = 0; c < 3; ++c) out[x][c] = Toward(out[x][c], Toward(low[c], high[c], t), a);
    }
  });
}

void Canvas::Modulate(const cv::Mat1f& field, double amount) {
  const auto gain = static_cast<float>(256.0 * amount);
  ForRows(image_.rows, [&](int y) {
    const float* f = field[y];
    Rgb* out = image_[y];
    for (int x = 0; x < image_.cols; ++x) {
      const int factor = 256 + static_cast<int>(gain * std::clamp(f[x], -2.5F, 2.5F));
      for (int c = 0; c < 3; ++c) {
        out[x][c] = static_cast<std::uint8_t>(std::clamp((out[x][c] * factor) >> 8, 0, 255));
      }
    }
  });
}

void Canvas::Darken(const cv::Mat1b& mask, double amount) { Blend(mask, Rgb(12, 14, 12), amount); }

void SoftenMask(cv::Mat1b& mask, int sigma) {
  const int side = 2 * std::max(1, sigma) + 1;
  for (int pass = 0; pass < 2; ++pass) {
    cv::Mat1b blurred;
    cv::boxFilter(mask, blurred, -1, {side, side}, {-1, -1}, true, cv::BORDER_REPLICATE);
    mask = std::move(blurred);
  }
}

void WritePng(const cv::Mat3b& rgb, const std::filesystem::path& path) {
  cv::Mat3b bgr;
  cv::cvtColor(rgb, bgr, cv::COLOR_RGB2BGR);
  const std::vector<int> options = {cv::IMWRITE_PNG_COMPRESSION, 1, cv::IMWRITE_PNG_STRATEGY,
                                    cv::IMWRITE_PNG_STRATEGY_RLE};
  RequireInput(cv::imwrite(path.string(), bgr, options), "{}: cannot be written", path.string());
}

}  // namespace drydock::scenes
