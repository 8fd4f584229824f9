#include "scenes/columns/textures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenes/columns/sand.h"
#include "scenes/texture/stamps.h"
#include "scenes/texture/weathering.h"

namespace drydock::scenes::columns {
namespace {

cv::Mat1b Everywhere(const Canvas& canvas) { return cv::Mat1b(canvas.size(), std::uint8_t{255}); }

/// Pale limestone with pits and lichen.
void PaintLimestone(Canvas& canvas, const NoiseKeys& keys) {
  const cv::Mat1f fine = canvas.Noise(0.02, 0.003, 0.85, keys.Key("fine"));
  canvas.Blend(Everywhere(canvas), canvas.Noise(0.4, 0.004, 0.68, keys.Key("base")),
               Rgb(92, 88, 76), Rgb(190, 184, 162));
  canvas.Blend(Coverage(canvas.Noise(0.10, 0.005, 0.7, keys.Key("pits")), 0.13, 0.15), fine,
               Rgb(40, 38, 32), Rgb(92, 86, 72), 0.8);
  canvas.Blend(Coverage(canvas.Noise(0.14, 0.004, 0.7, keys.Key("lichen")), 0.07, 0.08), fine,
               Rgb(160, 154, 126), Rgb(214, 208, 184), 0.85);
}

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
  PaintLimestone(canvas, keys);
  Overgrow(canvas, keys);
  return canvas.image();
}

/// As large as a stele's face: a frame and cut lines of letters, half grown over.
cv::Mat3b PaintInscription(std::uint64_t seed, double scale) {
  const NoiseKeys keys(seed, "columns/inscription");
  Canvas canvas(0.76, 1.32, 560 * scale, Rgb(140, 134, 118));
  PaintLimestone(canvas, keys);
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

/// Ripples that meet themselves at the picture's rim.
cv::Mat1f Ripples(const Canvas& canvas, const NoiseKeys& keys) {
  const cv::Mat1f warp = canvas.Noise(1.5, 0.1, 0.5, keys.Key("warp"));
  const cv::Mat1f where = canvas.Noise(2.0, 0.1, 0.55, keys.Key("ripples where"));
  cv::Mat1f ripples(canvas.size());
  const double turn = 2 * std::numbers::pi / canvas.size().width;
  for (int y = 0; y < ripples.rows; ++y) {
    for (int x = 0; x < ripples.cols; ++x) {
      const double phase = turn * (9.0 * y + 34.0 * x) + 3.0 * warp(y, x);
      const float strength = std::clamp(0.6F + 0.7F * where(y, x), 0.0F, 1.3F);
      ripples(y, x) = strength * static_cast<float>(std::sin(phase));
    }
  }
  return ripples;
}

/// Pebbles and shells; those at the rim are drawn again at the opposite side.
void Strew(Canvas& canvas, std::uint64_t key) {
  constexpr int kPebbles = 2600;
  constexpr int kShells = 150;
  RandomStream random(key, "strewn");
  for (int i = 0; i < kPebbles + kShells; ++i) {
    const double x = random.Uniform(0.0, canvas.width());
    const double y = random.Uniform(0.0, canvas.height());
    const double size = random.Uniform();
    const RandomStream look(random.Bits(), "look");
    for (const double dx : {-canvas.width(), 0.0, canvas.width()}) {
      for (const double dy : {-canvas.height(), 0.0, canvas.height()}) {
        RandomStream same = look;
        if (i < kPebbles) DrawPebble(canvas, x + dx, y + dy, 0.004 + 0.03 * size * size, same);
        if (i >= kPebbles) DrawShell(canvas, x + dx, y + dy, 0.015 + 0.04 * size, same);
      }
    }
  }
}

cv::Mat3b PaintSand(std::uint64_t seed, double scale) {
  const NoiseKeys keys(seed, "columns/sand");
  Canvas canvas(kSandTile, kSandTile, 250 * scale, Rgb(160, 148, 118), true);
  const cv::Mat1f fine = canvas.Noise(0.03, 0.004, 0.85, keys.Key("fine"));
  canvas.Blend(Everywhere(canvas), canvas.Noise(1.4, 0.01, 0.62, keys.Key("base")),
               Rgb(112, 102, 78), Rgb(204, 194, 160));
  const cv::Mat1f ripples = Ripples(canvas, keys);
  canvas.Blend(Ramp(ripples, 0.5, 1.3), Rgb(206, 194, 160), 0.5);
  canvas.Blend(Ramp(-ripples, 0.5, 1.3), Rgb(92, 82, 60), 0.5);
  canvas.Blend(Coverage(canvas.Noise(0.7, 0.006, 0.68, keys.Key("detritus")), 0.12, 0.3), fine,
               Rgb(48, 41, 29), Rgb(92, 82, 60), 0.8);
  canvas.Modulate(fine, 0.10);
  Strew(canvas, keys.Key("things"));
  return canvas.image();
}

}  // namespace

std::vector<TextureTask> TextureTasks() {
  return {{"stone", PaintStone}, {"inscription", PaintInscription}, {"sand", PaintSand}};
}

}  // namespace drydock::scenes::columns
