// A rectangle of paper with scales on two sides.
#pragma once

#include <string>
#include <vector>

#include "scenarios/report/canvas.h"

namespace drydock::report {

/// An interval of data values, low < high.
struct Range {
  double low = 0.0;
  double high = 1.0;

  double Length() const { return high - low; }
  double Middle() const { return 0.5 * (low + high); }
};

/// The smallest range around the values, widened to at least `min_length`; [0, min_length] for
/// none.
Range RangeOf(const std::vector<double>& values, double min_length);

/// Round values (1, 2 or 5 times a power of ten apart) within `range`, about `wanted` of them and
/// at least two.
std::vector<double> Ticks(Range range, int wanted);

/// The values with as many decimals as their distance asks for.
std::vector<std::string> TickLabels(const std::vector<double>& ticks);

/// Maps data to the canvas and draws the frame around it.
class Axes {
 public:
  /// `box` is the frame without labels, which need 56 px on its left and 40 px below.
  Axes(const cv::Rect2d& box, Range x, Range y) : box_(box), x_(x), y_(y) {}

  /// The same, but both ranges widened where needed so that a unit is as long along x as along y.
  static Axes WithEqualScales(const cv::Rect2d& box, Range x, Range y);

  /// Grid, ticks, labels; `title` stands above the frame at the left, `x_label` below at the right.
  void Draw(Canvas& canvas, const std::string& title, const std::string& x_label) const;

  cv::Point2d ToCanvas(double x, double y) const;

  Range x() const { return x_; }
  Range y() const { return y_; }

 private:
  cv::Rect2d box_;
  Range x_;
  Range y_;
};

}  // namespace drydock::report
