#include "scenarios/report/contact_sheet.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "scenarios/report/canvas.h"
#include "sensors_models/base/check.h"

namespace drydock::report {
namespace {

constexpr double kWidth = 1200.0;
constexpr double kMargin = 24.0;
constexpr double kGutter = 24.0;  ///< Between pairs [px].
constexpr double kPairGap = 2.0;  ///< Between the eyes of a pair [px].
constexpr double kLabel = 24.0;   ///< Of the line above a pair [px].
constexpr double kHeader = 48.0;

/// Height over width of the frames' images: the largest, so that no cell is too low.
double AspectOf(const std::vector<SheetFrame>& frames) {
  double aspect = 0.0;
  for (const SheetFrame& frame : frames) {
    for (const cv::Mat& image : frame.images) {
      Check(!image.empty(), "a contact sheet of an empty image");
      aspect = std::max(aspect, static_cast<double>(image.rows) / image.cols);
    }
  }
  return aspect;
}

void DrawPair(Canvas& canvas, const SheetFrame& frame, cv::Point2d corner, double eye_width) {
  canvas.Text(fmt::format("{:.3f} s", frame.t.Seconds()), {corner.x, corner.y + kLabel - 7.0}, 9.0,
              kFaintInk);
  for (std::size_t i = 0; i < 2; ++i) {
    const cv::Mat& image = frame.images[i];
    const double x = corner.x + static_cast<double>(i) * (eye_width + kPairGap);
    const double height = eye_width * image.rows / image.cols;
    canvas.Picture(image, {x, corner.y + kLabel, eye_width, height});
  }
}

}  // namespace

cv::Mat DrawContactSheet(const std::string& title, const std::vector<SheetFrame>& frames,
                         int columns) {
  Check(columns >= 1, "a contact sheet of {} columns", columns);
  const double pair_width = (kWidth - 2.0 * kMargin - (columns - 1) * kGutter) / columns;
  const double eye_width = std::floor(0.5 * (pair_width - kPairGap));
  const double cell_height = kLabel + std::ceil(eye_width * AspectOf(frames));
  const int rows = (static_cast<int>(frames.size()) + columns - 1) / columns;
  const double height = kHeader + rows * (cell_height + kGutter * 0.5) + kMargin;
  Canvas canvas(static_cast<int>(kWidth), static_cast<int>(std::ceil(height)), kPaper);
  canvas.Text(title, {kMargin, 32.0}, 14.0, kInk);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const auto [row, column] = std::div(static_cast<int>(i), columns);
    DrawPair(
        canvas, frames[i],
        {kMargin + column * (pair_width + kGutter), kHeader + row * (cell_height + kGutter * 0.5)},
        eye_width);
  }
  return canvas.Finish();
}

std::vector<std::size_t> SpreadEvenly(std::size_t size, std::size_t count) {
  std::vector<std::size_t> indices;
  const std::size_t n = std::min(size, count);
  for (std::size_t i = 0; i < n; ++i) {
    indices.push_back(n == 1 ? 0 : (i * (size - 1) + (n - 1) / 2) / (n - 1));
  }
  return indices;
}

}  // namespace drydock::report
