// Lamps, signs, the grille.
#include <opencv2/imgproc.hpp>

#include "scenes/bus/panel_painter.h"
#include "scenes/bus/textures.h"
#include "scenes/texture/weathering.h"

namespace drydock::scenes::bus {
namespace {

const Rgb kLetter(22, 22, 22);

/// A moulded lens: rings and spokes.
void DrawLens(Canvas& canvas, double x, double y, const Rgb& color, const Rgb& line) {
  for (int ring = 0; ring < 9; ++ring) {
    const double r = 0.5 * (1.0 - ring / 9.0);
    const Rgb shade = ring % 2 == 0 ? color : line;
    cv::circle(canvas.image(), canvas.Fixed(x, y), canvas.FixedLength(r),
               cv::Scalar(shade[0], shade[1], shade[2]), cv::FILLED, cv::LINE_AA, Canvas::kShift);
  }
  for (int i = -3; i <= 3; ++i) {
    DrawLine(canvas, {x + 0.12 * i, y - 0.45}, {x + 0.12 * i, y + 0.45}, 0.02, line);
  }
}

void DrawStopSign(PanelPainter& painter) {
  painter.Field(0, 0, 1, 1, Rgb(206, 200, 190));
  painter.Field(0.05, 0.05, 0.95, 0.95, Rgb(164, 30, 26));
  for (const double a : {0.0, 1.0}) {  // the octagon's slanted sides, in white
    for (const double b : {0.0, 1.0}) {
      const double da = a > 0.5 ? -0.29 : 0.29;
      const double db = b > 0.5 ? -0.29 : 0.29;
      painter.Stripe(a + da, b, a, b + db, 0.10, Rgb(206, 200, 190));
    }
  }
  painter.Text("STOP", 0.5, 0.5, 0.30, 0.2, Rgb(214, 208, 198), 0.62);
}

void DrawGrille(PanelPainter& painter) {
  painter.Field(0.0, 1.0, 2.0, 2.0, Rgb(34, 32, 28));
  for (int i = 0; i < 14; ++i)
    painter.Stripe(0.0, 1.03 + 0.07 * i, 2.0, 1.03 + 0.07 * i, 0.022, Rgb(112, 106, 94));
  for (int i = 0; i < 24; ++i)
    painter.Stripe(0.04 + 0.083 * i, 1.0, 0.04 + 0.083 * i, 2.0, 0.008, Rgb(80, 74, 64));
  painter.Field(0.0, 1.0, 2.0, 1.07, Rgb(206, 152, 40));
  painter.Field(0.0, 1.9, 2.0, 2.0, Rgb(196, 146, 40));
  for (const double a : {0.02, 1.92}) painter.Field(a, 1.0, a + 0.06, 2.0, Rgb(200, 148, 40));
}

/// One unit a cell: see details_atlas.h.
cv::Mat3b PaintDetails(std::uint64_t seed, double scale) {
  const NoiseKeys keys(seed, "bus/details");
  Canvas canvas(4.0, 2.0, 256 * scale, Rgb(60, 58, 54));
  PanelPainter painter(canvas, [](double a, double b) { return cv::Point2d(a, b); });
  DrawStopSign(painter);
  DrawLens(canvas, 1.5, 0.5, Rgb(150, 28, 20), Rgb(88, 14, 12));
  DrawLens(canvas, 2.5, 0.5, Rgb(206, 116, 26), Rgb(130, 66, 16));
  DrawLens(canvas, 3.5, 0.5, Rgb(186, 186, 172), Rgb(112, 114, 106));
  DrawGrille(painter);
  painter.Field(2.02, 1.02, 2.98, 1.98, Rgb(210, 206, 190));
  painter.Text("SCHOOL", 2.5, 1.22, 0.12, 0.16, Rgb(40, 60, 120), 1.2);
  painter.Text("LK 0473", 2.5, 1.62, 0.30, 0.16, Rgb(40, 60, 120), 0.55);
  painter.Field(3.02, 1.02, 3.98, 1.98, Rgb(110, 124, 120));
  // Growth in the scale of the things themselves: a cell is about 0.3 m.
  Weathering weathering;
  weathering.rust = 0.06;
  weathering.largest = 1.2;
  weathering.algae = 0.03;
  weathering.silt = 0.07;
  weathering.mussels = 0;
  weathering.grain = 0.09;
  Age(canvas, weathering, painter.edges(), keys);
  canvas.Modulate(canvas.Noise(0.08, 0.02, 0.8, keys.Key("speckle")), 0.10);
  return canvas.image();
}

cv::Mat3b PaintSigns(std::uint64_t seed, double scale) {
  const NoiseKeys keys(seed, "bus/signs");
  Canvas canvas(1.24, 0.52, 600 * scale, Rgb(218, 164, 38));
  PanelPainter painter(canvas, [](double a, double b) { return cv::Point2d(a, b); });
  for (const double b : {0.0, 0.26}) {
    painter.Text("SCHOOL BUS", 0.62, b + 0.13, 0.165, 0.20, kLetter, 0.82);
    painter.MarkEdge(0, b, 1.24, b, 0.02);
  }
  Weathering weathering;
  weathering.rust = 0.09;
  weathering.silt = 0.05;
  weathering.algae = 0.03;
  Age(canvas, weathering, painter.edges(), keys);
  return canvas.image();
}

}  // namespace

std::vector<TextureTask> DetailTextures() {
  return {{"details", PaintDetails}, {"signs", PaintSigns}};
}

}  // namespace drydock::scenes::bus
