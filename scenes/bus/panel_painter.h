// Sheet metal: seams, rows of rivets, frames round openings, and where rust starts because of them.
#pragma once

#include <functional>

#include "scenes/texture/canvas.h"
#include "scenes/texture/stamps.h"

namespace drydock::scenes::bus {

/// Draws on a canvas in the coordinates of the part (a, b), mapped to the canvas by `place`.
class PanelPainter {
 public:
  using Place = std::function<cv::Point2d(double a, double b)>;
  PanelPainter(Canvas& canvas, Place place);

  /// A joint between sheets from (a0, b0) to (a1, b1), riveted every `pitch` unless that is 0.
  void Seam(double a0, double b0, double a1, double b1, double pitch = 0.08);
  void Rivets(double a0, double b0, double a1, double b1, double pitch, double radius = 0.006);
  /// A rubber-framed opening: the frame lies outside the rectangle, dirt below its corners.
  void Opening(double a0, double b0, double a1, double b1, double frame = 0.025);
  /// A painted line or field.
  void Stripe(double a0, double b0, double a1, double b1, double width, const Rgb& color);
  void Field(double a0, double b0, double a1, double b1, const Rgb& color);
  /// A flap: a thin dark outline, a latch.
  void Flap(double a0, double b0, double a1, double b1);
  void Text(const char* text, double a, double b, double height, double weight, const Rgb& color,
            double squeeze = 1.0);
  /// Silt that lies on a ledge along the line, thinning out upwards over `depth`.
  void Ledge(double a0, double b0, double a1, double b1, double depth, std::uint64_t key);
  /// Marks where water gets in, without drawing.
  void MarkEdge(double a0, double b0, double a1, double b1, double width);

  cv::Mat1b& edges() { return edges_; }

 private:
  Canvas& canvas_;
  Place place_;
  cv::Mat1b edges_;
};

/// 0 at and above b = `from`, 255 at and below `to`, for canvases whose b is `top` at the first
/// row.
cv::Mat1b DownwardGrade(const Canvas& canvas, double top, double from, double to);

}  // namespace drydock::scenes::bus
