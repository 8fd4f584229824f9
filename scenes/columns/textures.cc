#include "scenes/columns/textures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenes/columns/sand.h"
#include "scenes/texture/materials.h"
#include "scenes/texture/stamps.h"
#include "scenes/texture/weathering.h"

namespace drydock::scenes::columns {
namespace {

void Overgrow(Canvas& canvas, const NoiseKeys& keys) {
  Weathering weathering;
  weathering.film = 0.25;
  weathering.algae = 0.14;
  weathering.silt = 0.12;
  weathering.mussels = 40.0;
  weathering.grain = 0.07;
  weathering.specks = 0.03;
  scenes::Overgrow(canvas, weathering, keys);
}

cv::Mat3b PaintStone(std::uint64_t seed, double scale) {
  const NoiseKeys keys(seed, "columns/stone");
  Canvas canvas(1.7, 1.7, 480 * scale, Rgb(140, 134, 118), true);
  scenes::PaintStone(canvas, keys);
  Overgrow(canvas, keys);
  return canvas.image();
}

/// As large as a stele's face: a frame and cut lines of letters, half grown over.
cv::Mat3b PaintInscription(std::uint64_t seed, double scale) {
  const NoiseKeys keys(seed, "columns/inscription");
  Canvas canvas(0.76, 1.32, 560 * scale, Rgb(140, 134, 118));
  scenes::PaintStone(canvas, keys);
  const Rgb cut(44, 41, 34);
  const double x = 0.5 * canvas.width();
  const char* lines[] = {"AQUIS", "SUB VNDIS", "LAPIDES", "STANT ORDINE", "MDCCCLIX"};
  double y = 0.40;
  for (const char* line : lines) {
    DrawText(canvas, line, x, y, 0.065, 0.16, cut, 0.8);
    y += 0.125;
  }
  for (const double inset : {0.045, 0.065}) {
    DrawLine(canvas, {inset, 0.40}, {inset, 1.25}, 0.008, cut);
    DrawLine(canvas, {canvas.width() - inset, 0.40}, {canvas.width() - inset, 1.25}, 0.008, cut);
    DrawLine(canvas, {inset, 1.29 - inset}, {canvas.width() - inset, 1.29 - inset}, 0.008, cut);
  }
  Overgrow(canvas, keys);
  return canvas.image();
}

void StrewPebblesAndShells(Canvas& canvas, std::uint64_t key) {
  RandomStream random(key, "strewn");
  Strew(canvas, 2600, random, [](Canvas& c, double x, double y, double size, RandomStream& look) {
    DrawPebble(c, x, y, 0.004 + 0.03 * size * size, look);
  });
  Strew(canvas, 150, random, [](Canvas& c, double x, double y, double size, RandomStream& look) {
    DrawShell(c, x, y, 0.015 + 0.04 * size, look);
  });
}

cv::Mat3b PaintSand(std::uint64_t seed, double scale) {
  const NoiseKeys keys(seed, "columns/sand");
  Canvas canvas(kSandTile, kSandTile, 250 * scale, Rgb(160, 148, 118), true);
  const cv::Mat1f fine = canvas.Noise(0.03, 0.004, 0.85, keys.Key("fine"));
  canvas.Blend(Everywhere(canvas), canvas.Noise(1.4, 0.01, 0.62, keys.Key("base")),
               Rgb(112, 102, 78), Rgb(204, 194, 160));
  const cv::Mat1f ripples = Ripples(canvas, keys, {.across = 34, .down = 9});
  canvas.Blend(Ramp(ripples, 0.5, 1.3), Rgb(206, 194, 160), 0.5);
  canvas.Blend(Ramp(-ripples, 0.5, 1.3), Rgb(92, 82, 60), 0.5);
  canvas.Blend(Coverage(canvas.Noise(0.7, 0.006, 0.68, keys.Key("detritus")), 0.12, 0.3), fine,
               Rgb(48, 41, 29), Rgb(92, 82, 60), 0.8);
  canvas.Modulate(fine, 0.10);
  StrewPebblesAndShells(canvas, keys.Key("things"));
  return canvas.image();
}

}  // namespace

std::vector<TextureTask> TextureTasks() {
  return {{"stone", PaintStone}, {"inscription", PaintInscription}, {"sand", PaintSand}};
}

}  // namespace drydock::scenes::columns
