#include "scenes/texture/stamps.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <opencv2/imgproc.hpp>

namespace drydock::scenes {
namespace {
constexpr int kShift = Canvas::kShift;
constexpr double kDegrees = 180.0 / std::numbers::pi;

cv::Scalar ToScalar(const Rgb& color) {
  return {double(color[0]), double(color[1]), double(color[2])};
}

Rgb Shade(const Rgb& color, double factor) {
  Rgb out;
  for (int c = 0; c < 3; ++c) {
    out[c] = static_cast<std::uint8_t>(std::clamp(color[c] * factor, 0.0, 255.0));
  }
  return out;
}

Rgb MixRgb(const Rgb& a, const Rgb& b, double t) {
  Rgb out;
  for (int c = 0; c < 3; ++c) out[c] = static_cast<std::uint8_t>(a[c] + (b[c] - a[c]) * t);
  return out;
}

void Arc(Canvas& canvas, double x, double y, double a, double b, double angle, const Rgb& color) {
  cv::ellipse(canvas.image(), canvas.Fixed(x, y), {canvas.FixedLength(a), canvas.FixedLength(b)},
              angle * kDegrees, 20, 160, ToScalar(color), 1, cv::LINE_AA, kShift);
}

void DrawMussel(Canvas& canvas, double x, double y, RandomStream& random) {
  const double angle = random.Uniform(0.0, 2.0 * std::numbers::pi);
  if (random.Uniform() < 0.35) {
    // A barnacle or a limpet: a pale ring with a dark mouth.
    const double r = random.Uniform(0.003, 0.008);
    FillEllipse(canvas, x, y, r * 1.25, r * 1.2, 0.0, Rgb(44, 42, 36));
    FillEllipse(canvas, x, y, r, r * 0.9, angle,
                MixRgb({170, 166, 150}, {206, 202, 188}, random.Uniform()));
    FillEllipse(canvas, x, y, r * 0.35, r * 0.3, angle, Rgb(52, 48, 42));
    return;
  }
  const double length = random.Uniform(0.006, 0.015);
  const Rgb shell = MixRgb({44, 34, 26}, {120, 98, 68}, random.Uniform());
  FillEllipse(canvas, x, y + 0.1 * length, length * 1.1, length * 0.62, angle, Rgb(22, 20, 16));
  FillEllipse(canvas, x, y, length, length * 0.5, angle, shell);
  Arc(canvas, x, y, length * 0.8, length * 0.3, angle, Rgb(190, 176, 140));
}

}  // namespace

void StampMussels(Canvas& canvas, double density, std::uint64_t key) {
  RandomStream random(key, "mussels");
  const double area = canvas.width() * canvas.height();
  const int clusters = static_cast<int>(std::lround(area * density / 16.0));
  for (int i = 0; i < clusters; ++i) {
    const double x = random.Uniform(0.0, canvas.width());
    const double y = random.Uniform(0.0, canvas.height());
    const int count = static_cast<int>(random.Uniform(3.0, 30.0));
    const double spread = 0.006 * std::sqrt(count) + random.Uniform(0.0, 0.05);
    for (int k = 0; k < count; ++k) {
      const double px = x + spread * random.Gaussian();
      const double py = y + spread * random.Gaussian();
      DrawMussel(canvas, px, py, random);
    }
  }
}

void DrawPebble(Canvas& canvas, double x, double y, double radius, RandomStream& random) {
  const Rgb grey = MixRgb({70, 66, 58}, {160, 154, 140}, random.Uniform());
  const Rgb tint = MixRgb({120, 78, 52}, {92, 98, 88}, random.Uniform());
  const Rgb color = MixRgb(grey, tint, random.Uniform(0.0, 0.5));
  const double angle = random.Uniform(0.0, std::numbers::pi);
  const double b = radius * random.Uniform(0.6, 1.0);
  FillEllipse(canvas, x + 0.12 * radius, y + 0.15 * radius, radius * 1.12, b * 1.12, angle,
              Rgb(46, 42, 34));
  FillEllipse(canvas, x, y, radius, b, angle, color);
  FillEllipse(canvas, x - 0.15 * radius, y - 0.18 * radius, radius * 0.6, b * 0.55, angle,
              Shade(color, 1.14));
  if (radius * canvas.scale() > 6.0 && random.Uniform() < 0.4) {
    const double dx = radius * std::cos(angle);
    const double dy = radius * std::sin(angle);
    DrawLine(canvas, {x - 0.8 * dx, y - 0.8 * dy}, {x + 0.8 * dx, y + 0.7 * dy}, 0.12 * radius,
             Shade(color, random.Uniform() < 0.5 ? 0.7 : 1.35));
  }
}

void DrawShell(Canvas& canvas, double x, double y, double length, RandomStream& random) {
  const double angle = random.Uniform(0.0, 2.0 * std::numbers::pi);
  const Rgb color = MixRgb({196, 188, 168}, {236, 230, 216}, random.Uniform());
  FillEllipse(canvas, x + 0.1 * length, y + 0.1 * length, length * 0.55, length * 0.4, angle,
              Rgb(50, 46, 38));
  FillEllipse(canvas, x, y, length * 0.5, length * 0.34, angle, color);
  Arc(canvas, x, y, length * 0.36, length * 0.22, angle, Rgb(120, 104, 84));
  Arc(canvas, x, y, length * 0.22, length * 0.12, angle, Rgb(134, 118, 96));
}

void DrawLeaf(Canvas& canvas, double x, double y, double length, RandomStream& random) {
  const double angle = random.Uniform(0.0, 2.0 * std::numbers::pi);
  const cv::Point2d along(std::cos(angle), std::sin(angle));
  const cv::Point2d across(-along.y, along.x);
  const double width = length * random.Uniform(0.22, 0.36);
  const Rgb color = MixRgb({58, 40, 24}, {150, 112, 62}, random.Uniform());
  std::vector<cv::Point2d> outline;
  const int n = 7;
  for (int side = -1; side <= 1; side += 2) {
    for (int i = 0; i < n; ++i) {
      const double t = side < 0 ? double(i) / n : 1.0 - double(i) / n;
      const double w =
          width * std::sin(std::numbers::pi * std::pow(t, 0.8)) * random.Uniform(0.8, 1.15);
      outline.push_back(cv::Point2d(x, y) + along * ((t - 0.5) * length) + across * (side * w));
    }
  }
  std::vector<cv::Point2d> shadow = outline;
  for (cv::Point2d& p : shadow) p += cv::Point2d(0.004, 0.005);
  FillPolygon(canvas, shadow, Rgb(40, 36, 28));
  FillPolygon(canvas, outline, color);
  const cv::Point2d center(x, y);
  DrawLine(canvas, center - along * (0.7 * length), center + along * (0.45 * length), 0.003,
           Shade(color, 0.5));
  for (int i = -2; i <= 2; ++i) {
    const cv::Point2d root = center + along * (0.15 * i * length);
    DrawLine(canvas, root, root + along * (0.1 * length) + across * (0.6 * width), 0.002,
             Shade(color, 0.65));
    DrawLine(canvas, root, root + along * (0.1 * length) - across * (0.6 * width), 0.002,
             Shade(color, 0.65));
  }
}

void DrawTwig(Canvas& canvas, double x, double y, double length, RandomStream& random) {
  double angle = random.Uniform(0.0, 2.0 * std::numbers::pi);
  const Rgb color = MixRgb({38, 28, 20}, {104, 80, 56}, random.Uniform());
  const double width = std::max(0.004, 0.02 * length);
  cv::Point2d p(x, y);
  for (int i = 0; i < 6; ++i) {
    angle += random.Uniform(-0.45, 0.45);
    const cv::Point2d q = p + cv::Point2d(std::cos(angle), std::sin(angle)) * (length / 6);
    DrawLine(canvas, p + cv::Point2d(0.004, 0.006), q + cv::Point2d(0.004, 0.006), width,
             Rgb(44, 40, 32));
    DrawLine(canvas, p, q, width * (1.0 - 0.1 * i), color);
    if (random.Uniform() < 0.4) {
      const double side = angle + random.Uniform(0.5, 1.2) * (random.Uniform() < 0.5 ? 1 : -1);
      DrawLine(canvas, q, q + cv::Point2d(std::cos(side), std::sin(side)) * (0.2 * length),
               0.5 * width, color);
    }
    p = q;
  }
}

void DrawRivet(Canvas& canvas, cv::Mat1b& edges, double x, double y, double radius) {
  FillEllipse(canvas, x, y, radius * 1.35, radius * 1.35, 0, Rgb(50, 40, 26));
  const cv::Vec3b under = canvas.image()(
      std::clamp(static_cast<int>((y - 2 * radius) * canvas.scale()), 0, canvas.size().height - 1),
      std::clamp(static_cast<int>(x * canvas.scale()), 0, canvas.size().width - 1));
  FillEllipse(canvas, x, y, radius, radius, 0, Shade(under, 0.92));
  FillEllipse(canvas, x - 0.25 * radius, y - 0.3 * radius, radius * 0.45, radius * 0.45, 0,
              Shade(under, 1.2));
  cv::circle(edges, canvas.Fixed(x, y), canvas.FixedLength(1.6 * radius), cv::Scalar(190),
             cv::FILLED, cv::LINE_8, kShift);
}

void FillEllipse(Canvas& canvas, double x, double y, double a, double b, double angle,
                 const Rgb& color) {
  cv::ellipse(canvas.image(), canvas.Fixed(x, y), {canvas.FixedLength(a), canvas.FixedLength(b)},
              angle * kDegrees, 0, 360, ToScalar(color), cv::FILLED, cv::LINE_AA, kShift);
}

void FillPolygon(Canvas& canvas, const std::vector<cv::Point2d>& corners, const Rgb& color) {
  std::vector<cv::Point> fixed;
  fixed.reserve(corners.size());
  for (const cv::Point2d& c : corners) fixed.push_back(canvas.Fixed(c.x, c.y));
  cv::fillPoly(canvas.image(), std::vector<std::vector<cv::Point>>{fixed}, ToScalar(color),
               cv::LINE_AA, kShift);
}

void DrawLine(Canvas& canvas, cv::Point2d from, cv::Point2d to, double width, const Rgb& color) {
  cv::line(canvas.image(), canvas.Fixed(from.x, from.y), canvas.Fixed(to.x, to.y), ToScalar(color),
           canvas.Pixels(width), cv::LINE_AA, kShift);
}

void DrawLine(const Canvas& canvas, cv::Mat1b& mask, cv::Point2d from, cv::Point2d to,
              double width) {
  cv::line(mask, canvas.Fixed(from.x, from.y), canvas.Fixed(to.x, to.y), cv::Scalar(255),
           canvas.Pixels(width), cv::LINE_AA, kShift);
}

void FillRectangle(Canvas& canvas, cv::Point2d low, cv::Point2d high, const Rgb& color) {
  cv::rectangle(canvas.image(), canvas.Fixed(low.x, low.y), canvas.Fixed(high.x, high.y),
                ToScalar(color), cv::FILLED, cv::LINE_8, kShift);
}

void DrawText(Canvas& canvas, const std::string& text, double x, double y, double height,
              double weight, const Rgb& color, double squeeze) {
  // Drawn large as a mask, then scaled to where it goes.
  const int face = cv::FONT_HERSHEY_SIMPLEX;
  const double scale = 4.0;
  const int thickness = std::max(1, static_cast<int>(std::lround(weight * 21.0 * scale)));
  int baseline = 0;
  const cv::Size extent = cv::getTextSize(text, face, scale, 0, &baseline);
  cv::Mat1b letters(extent.height + 2 * thickness, extent.width + 2 * thickness, std::uint8_t{0});
  cv::putText(letters, text, {thickness, thickness + extent.height}, face, scale, cv::Scalar(255),
              thickness, cv::LINE_AA);
  const double pixel = height / (extent.height + thickness);
  const int rows = canvas.Pixels(pixel * letters.rows);
  const int columns = canvas.Pixels(pixel * letters.cols * squeeze);
  cv::Mat1b small;
  cv::resize(letters, small, {columns, rows}, 0, 0, cv::INTER_LINEAR_EXACT);
  cv::Mat1b mask = canvas.Mask();
  const cv::Rect place(static_cast<int>(x * canvas.scale()) - columns / 2,
                       static_cast<int>(y * canvas.scale()) - rows / 2, columns, rows);
  const cv::Rect visible = place & cv::Rect({0, 0}, canvas.size());
  if (visible.empty()) return;
  small(visible - place.tl()).copyTo(mask(visible));
  canvas.Blend(mask, color);
}

}  // namespace drydock::scenes
