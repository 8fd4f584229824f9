#include "scenes/texture/materials.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace drydock::scenes {

cv::Mat1b Everywhere(const Canvas& canvas) { return cv::Mat1b(canvas.size(), std::uint8_t{255}); }

void PaintStone(Canvas& canvas, const NoiseKeys& keys, const StoneColors& colors) {
  const cv::Mat1f fine = canvas.Noise(0.02, 0.003, 0.85, keys.Key("fine"));
  canvas.Blend(Everywhere(canvas), canvas.Noise(0.4, 0.004, 0.68, keys.Key("base")), colors.low,
               colors.high);
  canvas.Blend(Coverage(canvas.Noise(0.10, 0.005, 0.7, keys.Key("pits")), 0.13, 0.15), fine,
               colors.pit_low, colors.pit_high, 0.8);
  canvas.Blend(Coverage(canvas.Noise(0.14, 0.004, 0.7, keys.Key("lichen")), 0.07, 0.08), fine,
               colors.lichen_low, colors.lichen_high, 0.85);
}

cv::Mat1f Ripples(const Canvas& canvas, const NoiseKeys& keys, const RippleShape& shape) {
  const cv::Mat1f warp = canvas.Noise(1.5, 0.1, 0.5, keys.Key("warp"));
  const cv::Mat1f where = canvas.Noise(shape.where_m, 0.1, 0.55, keys.Key("ripples where"));
  cv::Mat1f ripples(canvas.size());
  const double turn = 2 * std::numbers::pi / canvas.size().width;
  for (int y = 0; y < ripples.rows; ++y) {
    for (int x = 0; x < ripples.cols; ++x) {
      const double phase =
          turn * (double(shape.down) * y + double(shape.across) * x) + shape.warp * warp(y, x);
      const float strength = std::clamp(shape.strength + 0.7F * where(y, x), 0.0F, shape.strongest);
      ripples(y, x) = strength * static_cast<float>(std::sin(phase));
    }
  }
  return ripples;
}

void Strew(Canvas& canvas, int count, RandomStream& random, const DrawThing& draw) {
  for (int i = 0; i < count; ++i) {
    const double x = random.Uniform(0.0, canvas.width());
    const double y = random.Uniform(0.0, canvas.height());
    const double size = random.Uniform();
    const RandomStream look(random.Bits(), "look");
    for (const double dx : {-canvas.width(), 0.0, canvas.width()}) {
      for (const double dy : {-canvas.height(), 0.0, canvas.height()}) {
        RandomStream same = look;
        draw(canvas, x + dx, y + dy, size, same);
      }
    }
  }
}

}  // namespace drydock::scenes
