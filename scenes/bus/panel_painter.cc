#include "scenes/bus/panel_painter.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace drydock::scenes::bus {

PanelPainter::PanelPainter(Canvas& canvas, Place place)
    : canvas_(canvas), place_(std::move(place)), edges_(canvas.Mask()) {}

void PanelPainter::Seam(double a0, double b0, double a1, double b1, double pitch) {
  DrawLine(canvas_, place_(a0, b0), place_(a1, b1), 0.012, Rgb(120, 96, 44));
  DrawLine(canvas_, place_(a0, b0), place_(a1, b1), 0.005, Rgb(34, 28, 20));
  MarkEdge(a0, b0, a1, b1, 0.022);
  if (pitch <= 0) return;
  const bool upright = std::abs(b1 - b0) > std::abs(a1 - a0);
  const double da = upright ? 0.022 : 0.0;
  const double db = upright ? 0.0 : 0.022;
  Rivets(a0 - da, b0 - db, a1 - da, b1 - db, pitch);
  Rivets(a0 + da, b0 + db, a1 + da, b1 + db, pitch);
}

void PanelPainter::Rivets(double a0, double b0, double a1, double b1, double pitch, double radius) {
  const double length = std::hypot(a1 - a0, b1 - b0);
  const int count = std::max(1, static_cast<int>(length / pitch));
  for (int i = 0; i < count; ++i) {
    const double t = (i + 0.5) / count;
    const cv::Point2d p = place_(a0 + t * (a1 - a0), b0 + t * (b1 - b0));
    DrawRivet(canvas_, edges_, p.x, p.y, radius);
  }
}

void PanelPainter::Opening(double a0, double b0, double a1, double b1, double frame) {
  Field(a0 - frame, b0 - frame, a1 + frame, b1 + frame, Rgb(30, 30, 28));
  const double corners[5][2] = {{a0, b0}, {a1, b0}, {a1, b1}, {a0, b1}, {a0, b0}};
  for (int i = 0; i < 4; ++i) {
    DrawLine(canvas_, place_(corners[i][0], corners[i][1]),
             place_(corners[i + 1][0], corners[i + 1][1]), 0.006, Rgb(92, 92, 86));
    MarkEdge(corners[i][0], corners[i][1], corners[i + 1][0], corners[i + 1][1], 2.4 * frame);
  }
}

void PanelPainter::Stripe(double a0, double b0, double a1, double b1, double width,
                          const Rgb& color) {
  DrawLine(canvas_, place_(a0, b0), place_(a1, b1), width, color);
}

void PanelPainter::Field(double a0, double b0, double a1, double b1, const Rgb& color) {
  const cv::Point2d p = place_(a0, b0);
  const cv::Point2d q = place_(a1, b1);
  FillRectangle(canvas_, {std::min(p.x, q.x), std::min(p.y, q.y)},
                {std::max(p.x, q.x), std::max(p.y, q.y)}, color);
}

void PanelPainter::Flap(double a0, double b0, double a1, double b1) {
  const double corners[5][2] = {{a0, b0}, {a1, b0}, {a1, b1}, {a0, b1}, {a0, b0}};
  for (int i = 0; i < 4; ++i) {
    DrawLine(canvas_, place_(corners[i][0], corners[i][1]),
             place_(corners[i + 1][0], corners[i + 1][1]), 0.006, Rgb(36, 30, 20));
    MarkEdge(corners[i][0], corners[i][1], corners[i + 1][0], corners[i + 1][1], 0.02);
  }
  const double middle = 0.5 * (a0 + a1);
  Field(middle - 0.03, std::max(b0, b1) - 0.05, middle + 0.03, std::max(b0, b1) - 0.03,
        Rgb(60, 58, 54));
}

void PanelPainter::Text(const char* text, double a, double b, double height, double weight,
                        const Rgb& color, double squeeze) {
  const cv::Point2d p = place_(a, b);
  DrawText(canvas_, text, p.x, p.y, height, weight, color, squeeze);
}

void PanelPainter::Ledge(double a0, double b0, double a1, double b1, double depth,
                         std::uint64_t key) {
  cv::Mat1b band = canvas_.Mask();
  const double up = 0.35 * depth;
  DrawLine(canvas_, band, place_(a0, b0 + up), place_(a1, b1 + up), 0.8 * depth);
  SoftenMask(band, canvas_.Pixels(0.3 * depth));
  cv::Mat1f field = canvas_.Noise(0.25, 0.005, 0.65, key);
  AddMask(field, band, 3.2);
  cv::Mat1b mask = Ramp(field, 2.0, 2.5);
  // Only where the band reaches: noise alone does not silt up the wall.
  cv::Mat1b reach;
  cv::threshold(band, reach, 8, 255, cv::THRESH_BINARY);
  mask &= reach;
  canvas_.Blend(mask, canvas_.Noise(0.03, 0.003, 0.8, key + 1), Rgb(112, 104, 82),
                Rgb(178, 168, 140), 0.9);
}

void PanelPainter::MarkEdge(double a0, double b0, double a1, double b1, double width) {
  cv::line(edges_, canvas_.Fixed(place_(a0, b0).x, place_(a0, b0).y),
           canvas_.Fixed(place_(a1, b1).x, place_(a1, b1).y), cv::Scalar(170),
           canvas_.Pixels(width), cv::LINE_8, Canvas::kShift);
}

cv::Mat1b DownwardGrade(const Canvas& canvas, double top, double from, double to) {
  cv::Mat1b grade = canvas.Mask();
  for (int y = 0; y < grade.rows; ++y) {
    const double b = top - (y + 0.5) / canvas.scale();
    const double t = std::clamp((from - b) / (from - to), 0.0, 1.0);
    grade.row(y).setTo(cv::Scalar(std::lround(255 * t)));
  }
  return grade;
}

}  // namespace drydock::scenes::bus
