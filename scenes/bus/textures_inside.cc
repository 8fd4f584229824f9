// The bus from inside.
#include <cmath>
#include <numbers>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "scenes/bus/bus_shape.h"
#include "scenes/bus/panel_painter.h"
#include "scenes/bus/textures.h"
#include "scenes/texture/weathering.h"

namespace drydock::scenes::bus {
namespace {

const Rgb kCream(164, 166, 140);
const Rgb kDarkGreen(72, 88, 66);

cv::Mat3b PaintWall(Side side, std::uint64_t seed, double scale) {
  const NoiseKeys keys(seed, side == Side::kLeft ? "bus/inside_left" : "bus/inside_right");
  Canvas canvas(kInsideCanvas.width, kInsideCanvas.height, 333 * scale, kCream);
  PanelPainter painter(canvas, [side](double x, double z) {
    const double a = x - kInsideCanvas.left;
    return cv::Point2d(side == Side::kLeft ? a : kInsideCanvas.width - a, kInsideCanvas.top - z);
  });
  painter.Field(1.4, -0.7, 10.6, -0.08, kDarkGreen);
  for (const double z : {-0.08, 0.10, kHead + 0.07}) painter.Seam(1.4, z, 10.6, z, 0.09);
  for (int i = 0; i <= kWindows; ++i) {
    const double x = kWindowFirst + i * kWindowPitch - 0.06;
    painter.Seam(x, -0.7, x, 1.0, 0.10);
  }
  for (int i = 0; i < kWindows; ++i) {
    const double x = kWindowFirst + i * kWindowPitch;
    painter.Opening(x, kSill, x + kWindowWidth, kHead, 0.03);
  }
  painter.Text("NO STANDING WHILE BUS IS IN MOTION", 5.0, 0.93, 0.05, 0.16, Rgb(50, 30, 26));
  Weathering weathering;
  weathering.rust = 0.17;
  weathering.algae = 0.07;
  weathering.silt = 0.21;
  Age(canvas, weathering, painter.edges(), keys);
  painter.Ledge(1.4, kSill - 0.01, 10.6, kSill - 0.01, 0.05, keys.Key("sill"));
  cv::Mat1f field = canvas.Noise(0.5, 0.006, 0.66, keys.Key("foot"));
  AddMask(field, DownwardGrade(canvas, kInsideCanvas.top, -0.2, -0.65), 2.8);
  canvas.Blend(Ramp(field, 1.8, 2.4), canvas.Noise(0.03, 0.003, 0.8, keys.Key("foot tone")),
               Rgb(84, 78, 58), Rgb(156, 146, 116), 0.85);
  return canvas.image();
}

cv::Mat3b PaintCeiling(std::uint64_t seed, double scale) {
  const NoiseKeys keys(seed, "bus/ceiling");
  Canvas canvas(kRoofCanvas.width, kRoofCanvas.height, 260 * scale, Rgb(186, 186, 168));
  PanelPainter painter(
      canvas, [](double x, double arc) { return cv::Point2d(x - kRoofCanvas.left, 1.45 - arc); });
  for (int i = 0; i <= kWindows; ++i) {
    const double x = kWindowFirst + i * kWindowPitch - 0.06;
    painter.Seam(x, -1.45, x, 1.45, 0.07);
  }
  for (const double arc : {-0.8, 0.0, 0.8}) painter.Seam(1.4, arc, 10.6, arc, 0.12);
  Weathering weathering;
  weathering.rust = 0.22;
  weathering.silt = 0.02;
  weathering.film = 0.38;
  weathering.algae = 0.07;
  weathering.largest = 0.8;
  weathering.streaks = 0.06;
  Age(canvas, weathering, painter.edges(), keys);
  return canvas.image();
}

void ScatterLitter(Canvas& canvas, std::uint64_t key) {
  RandomStream random(key, "litter");
  const auto x = [&] { return random.Uniform(0.0, canvas.width()); };
  for (int i = 0; i < 1400; ++i) {
    const double a = x();
    const double b = random.Uniform(0.0, canvas.height());
    DrawPebble(canvas, a, b, 0.003 + 0.012 * random.Uniform() * random.Uniform(), random);
  }
  for (int i = 0; i < 110; ++i) {
    const double a = x();
    const double b = random.Uniform(0.0, canvas.height());
    if (i % 3 == 0) DrawShell(canvas, a, b, random.Uniform(0.02, 0.05), random);
    if (i % 3 == 1) DrawLeaf(canvas, a, b, random.Uniform(0.05, 0.13), random);
    if (i % 3 == 2) DrawTwig(canvas, a, b, random.Uniform(0.08, 0.3), random);
  }
}

cv::Mat3b PaintFloor(std::uint64_t seed, double scale) {
  const NoiseKeys keys(seed, "bus/floor");
  Canvas canvas(kFloorCanvas.width, kFloorCanvas.height, 300 * scale, Rgb(62, 62, 58));
  PanelPainter painter(canvas, [](double x, double y) {
    return cv::Point2d(x - kFloorCanvas.left, -y - kFloorCanvas.top);
  });
  painter.Field(1.4, -0.46, 10.6, 0.46, Rgb(46, 46, 44));
  for (int i = -8; i <= 8; ++i) {  // the ribbed mat of the aisle
    painter.Stripe(1.4, 0.052 * i, 10.6, 0.052 * i, 0.010, Rgb(84, 84, 78));
  }
  for (const double y : {-0.47, 0.47}) {
    painter.Stripe(1.4, y, 10.6, y, 0.035, Rgb(150, 148, 138));
    painter.Rivets(1.4, y, 10.6, y, 0.12, 0.007);
  }
  for (int i = 0; i < 8; ++i) painter.Seam(1.9 + 1.15 * i, -1.2, 1.9 + 1.15 * i, 1.2, 0.0);
  Weathering weathering;
  weathering.rust = 0.11;
  weathering.algae = 0.06;
  weathering.silt = 0.4;
  weathering.silt_alpha = 0.92;
  weathering.film = 0.26;
  Age(canvas, weathering, painter.edges(), keys);
  ScatterLitter(canvas, keys.Key("litter"));
  return canvas.image();
}

/// A rip that shows the foam.
void DrawTear(Canvas& canvas, double x, double y, RandomStream& random) {
  const double length = 0.02 + 0.10 * random.Uniform() * random.Uniform();
  const double angle = random.Uniform(0.0, 3.1);
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  std::vector<cv::Point2d> rim;
  std::vector<cv::Point2d> foam;
  constexpr int kCorners = 22;
  for (int i = 0; i < kCorners; ++i) {
    const double turn = 2 * std::numbers::pi * i / kCorners;
    const double a = length * std::cos(turn) * random.Uniform(0.75, 1.15);
    const double b = 0.45 * length * std::sin(turn) * random.Uniform(0.5, 1.3);
    rim.emplace_back(x + 1.18 * (a * c - b * s), y + 1.18 * (a * s + b * c));
    foam.emplace_back(x + a * c - b * s, y + a * s + b * c);
  }
  FillPolygon(canvas, rim, Rgb(20, 16, 12));
  FillPolygon(canvas, foam, random.Uniform() < 0.6 ? Rgb(176, 150, 88) : Rgb(128, 100, 56));
}

cv::Mat3b PaintVinyl(std::uint64_t seed, double scale) {
  const NoiseKeys keys(seed, "bus/vinyl");
  Canvas canvas(2.0, 2.0, 400 * scale, Rgb(66, 46, 36), true);
  RandomStream random(keys.Key("tears"), "tears");
  PanelPainter painter(canvas, [](double a, double b) { return cv::Point2d(a, b); });
  for (int i = 0; i < 18; ++i) {
    painter.Stripe(0, (i + 0.5) / 9.0, 2, (i + 0.5) / 9.0, 0.012, Rgb(38, 24, 18));
    painter.Stripe(0, (i + 0.5) / 9.0 + 0.012, 2, (i + 0.5) / 9.0 + 0.012, 0.006, Rgb(120, 84, 62));
  }
  for (int i = 0; i < 60; ++i) {
    const double x = random.Uniform(0.1, 1.9);
    DrawTear(canvas, x, random.Uniform(0.1, 1.9), random);
  }
  cv::Mat1f mould = canvas.Noise(0.12, 0.004, 0.7, keys.Key("mould"));
  canvas.Blend(Coverage(mould, 0.11, 0.15), Rgb(150, 146, 118), 0.7);
  Weathering weathering;
  weathering.film = 0.2;
  weathering.algae = 0.13;
  weathering.silt = 0.30;
  weathering.silt_alpha = 0.8;
  weathering.mussels = 20;
  Overgrow(canvas, weathering, keys);
  return canvas.image();
}

cv::Mat3b PaintPanel(std::uint64_t seed, double scale) {
  const NoiseKeys keys(seed, "bus/panel");
  Canvas canvas(2.0, 2.0, 400 * scale, kCream, true);
  PanelPainter painter(canvas, [](double a, double b) { return cv::Point2d(a, b); });
  for (int i = 0; i < 4; ++i) painter.Rivets(0.0, 0.25 + 0.5 * i, 2.0, 0.25 + 0.5 * i, 0.1);
  Weathering weathering;
  weathering.rust = 0.26;
  weathering.primer = 0.08;
  Age(canvas, weathering, painter.edges(), keys);
  return canvas.image();
}

}  // namespace

std::vector<TextureTask> InsideTextures() {
  const auto wall = [](Side which) {
    return [which](std::uint64_t seed, double scale) { return PaintWall(which, seed, scale); };
  };
  return {{"inside_left", wall(Side::kLeft)},
          {"inside_right", wall(Side::kRight)},
          {"ceiling", PaintCeiling},
          {"floor", PaintFloor},
          {"vinyl", PaintVinyl},
          {"panel", PaintPanel}};
}

}  // namespace drydock::scenes::bus
