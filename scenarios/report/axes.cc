#include "scenarios/report/axes.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace drydock::report {
namespace {

constexpr double kLabelSize = 9.0;
constexpr double kTitleSize = 11.0;
constexpr double kPixelsPerTickX = 95.0;
constexpr double kPixelsPerTickY = 45.0;

int WantedTicks(double pixels, double pixels_per_tick) {
  return std::max(2, static_cast<int>(pixels / pixels_per_tick));
}

/// The distance of round ticks: 1, 2 or 5 times a power of ten, at least `distance`.
double RoundUp(double distance) {
  const double power = std::pow(10.0, std::floor(std::log10(distance)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= distance * (1.0 - 1e-9)) return factor * power;
  }
  return 10.0 * power;
}

}  // namespace

Range RangeOf(const std::vector<double>& values, double min_length) {
  if (values.empty()) return {0.0, min_length};
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  Range range{*low, *high};
  if (range.Length() < min_length) {
    range = {range.Middle() - 0.5 * min_length, range.Middle() + 0.5 * min_length};
  }
  return range;
}

std::vector<double> Ticks(Range range, int wanted) {
  const double step = RoundUp(range.Length() / wanted);
  std::vector<double> ticks;
  const double first = std::ceil(range.low / step - 1e-9);
  for (double k = first; k * step <= range.high + 1e-9 * step; ++k) {
    ticks.push_back(k == 0.0 ? 0.0 : k * step);
  }
  // One tick alone does not tell the scale.
  return ticks.size() < 2 ? Ticks(range, 2 * wanted) : ticks;
}

std::vector<std::string> TickLabels(const std::vector<double>& ticks) {
  const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : 1.0;
  const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 9);
  std::vector<std::string> labels;
  for (const double tick : ticks) labels.push_back(fmt::format("{:.{}f}", tick, decimals));
  return labels;
}

Axes Axes::WithEqualScales(const cv::Rect2d& box, Range x, Range y) {
  const double unit = std::max(x.Length() / box.width, y.Length() / box.height);
  const auto around = [unit](Range range, double pixels) {
    return Range{range.Middle() - 0.5 * unit * pixels, range.Middle() + 0.5 * unit * pixels};
  };
  return {box, around(x, box.width), around(y, box.height)};
}

cv::Point2d Axes::ToCanvas(double x, double y) const {
  return {box_.x + (x - x_.low) / x_.Length() * box_.width,
          box_.y + (y_.high - y) / y_.Length() * box_.height};
}

void Axes::Draw(Canvas& canvas, const std::string& title, const std::string& x_label) const {
  const double bottom = box_.y + box_.height;
  const double right = box_.x + box_.width;
  const std::vector<double> x_ticks = Ticks(x_, WantedTicks(box_.width, kPixelsPerTickX));
  const std::vector<double> y_ticks = Ticks(y_, WantedTicks(box_.height, kPixelsPerTickY));
  const std::vector<std::string> x_names = TickLabels(x_ticks);
  const std::vector<std::string> y_names = TickLabels(y_ticks);
  for (std::size_t i = 0; i < x_ticks.size(); ++i) {
    const double x = ToCanvas(x_ticks[i], y_.low).x;
    canvas.Line({x, box_.y}, {x, bottom}, kGridInk, 1.0);
    canvas.Text(x_names[i], {x, bottom + 18.0}, kLabelSize, kFaintInk, TextAnchor::kCentre);
  }
  for (std::size_t i = 0; i < y_ticks.size(); ++i) {
    const double y = ToCanvas(x_.low, y_ticks[i]).y;
    canvas.Line({box_.x, y}, {right, y}, kGridInk, 1.0);
    canvas.Text(y_names[i], {box_.x - 8.0, y + 0.5 * kLabelSize}, kLabelSize, kFaintInk,
                TextAnchor::kRight);
  }
  canvas.Rectangle(box_, kFaintInk, 0.5);
  canvas.Text(title, {box_.x, box_.y - 10.0}, kTitleSize, kInk);
  canvas.Text(x_label, {right, bottom + 35.0}, kLabelSize, kInk, TextAnchor::kRight);
}

}  // namespace drydock::report
