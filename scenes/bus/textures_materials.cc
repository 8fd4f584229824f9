// Repeating materials: stone, bark, planks, rust, paints, rubber, glass.
#include <algorithm>
#include <cmath>

#include "scenes/bus/panel_painter.h"
#include "scenes/bus/textures.h"
#include "scenes/texture/materials.h"
#include "scenes/texture/weathering.h"

namespace drydock::scenes::bus {
namespace {

cv::Mat3b PaintStone(std::uint64_t seed, double scale) {
  const NoiseKeys keys(seed, "bus/stone");
  Canvas canvas(1.6, 1.6, 640 * scale, Rgb(120, 116, 106), true);
  const cv::Mat1f fine = canvas.Noise(0.02, 0.003, 0.85, keys.Key("fine"));
  canvas.Blend(Everywhere(canvas), canvas.Noise(0.5, 0.004, 0.68, keys.Key("base")),
               Rgb(60, 57, 50), Rgb(170, 164, 148));
  canvas.Blend(Coverage(canvas.Noise(0.3, 0.004, 0.7, keys.Key("dark")), 0.17, 0.15), fine,
               Rgb(38, 36, 32), Rgb(82, 76, 66), 0.85);
  canvas.Blend(ZeroLines(canvas.Noise(0.5, 0.02, 0.55, keys.Key("cracks")), 0.05), Rgb(30, 28, 24),
               0.85);
  canvas.Blend(Coverage(canvas.Noise(0.12, 0.004, 0.7, keys.Key("lichen")), 0.06, 0.08), fine,
               Rgb(150, 146, 120), Rgb(206, 200, 178), 0.85);
  Weathering weathering;
  weathering.film = 0.2;
  weathering.algae = 0.15;
  weathering.silt = 0.15;
  weathering.mussels = 80;
  weathering.grain = 0.08;
  weathering.specks = 0.04;
  Overgrow(canvas, weathering, keys);
  return canvas.image();
}

cv::Mat3b PaintBark(std::uint64_t seed, double scale) {
  const NoiseKeys keys(seed, "bus/bark");
  Canvas canvas(1.0, 1.0, 800 * scale, Rgb(78, 62, 46), true);
  const cv::Mat1f fibre = canvas.Noise(0.05, 0.004, 0.75, keys.Key("fibre"), 5.0);
  canvas.Blend(Everywhere(canvas), fibre, Rgb(44, 34, 26), Rgb(126, 104, 78));
  canvas.Blend(ZeroLines(canvas.Noise(0.06, 0.006, 0.6, keys.Key("grooves"), 4.0), 0.22),
               Rgb(22, 18, 14), 0.85);
  canvas.Blend(Coverage(canvas.Noise(0.3, 0.005, 0.65, keys.Key("bare")), 0.17, 0.1), fibre,
               Rgb(112, 92, 66), Rgb(182, 160, 122), 0.9);
  Weathering weathering;
  weathering.algae = 0.21;
  weathering.silt = 0.15;
  weathering.mussels = 40;
  Overgrow(canvas, weathering, keys);
  return canvas.image();
}

cv::Mat3b PaintPlanks(std::uint64_t seed, double scale) {
  const NoiseKeys keys(seed, "bus/planks");
  Canvas canvas(1.0, 1.0, 768 * scale, Rgb(110, 92, 68), true);
  // Grain runs along u: stretch < 1 makes features wider than high.
  const cv::Mat1f grain = canvas.Noise(0.25, 0.02, 0.8, keys.Key("grain"), 0.08);
  canvas.Blend(Everywhere(canvas), grain, Rgb(58, 46, 34), Rgb(154, 134, 102));
  canvas.Blend(ZeroLines(canvas.Noise(0.5, 0.1, 0.6, keys.Key("splits"), 0.08), 0.08),
               Rgb(26, 20, 16), 0.8);
  PanelPainter painter(canvas, [](double a, double b) { return cv::Point2d(a, b); });
  for (int i = 0; i < 6; ++i)
    painter.Stripe(0, (i + 0.5) / 6, 1, (i + 0.5) / 6, 0.008, Rgb(24, 20, 16));
  for (int i = 0; i < 6; ++i) painter.Rivets(0, (i + 0.2) / 6, 1, (i + 0.2) / 6, 0.33, 0.006);
  Weathering weathering;
  weathering.algae = 0.15;
  weathering.silt = 0.17;
  weathering.mussels = 40;
  Overgrow(canvas, weathering, keys);
  return canvas.image();
}

cv::Mat3b PaintBareRust(std::uint64_t seed, double scale) {
  const NoiseKeys keys(seed, "bus/bare_rust");
  Canvas canvas(1.0, 1.0, 1024 * scale, Rgb(90, 60, 40), true);
  PaintRust(canvas, keys);
  Weathering weathering;
  weathering.mussels = 50;
  Overgrow(canvas, weathering, keys);
  return canvas.image();
}

cv::Mat3b PaintPaint(const Rgb& color, const char* name, std::uint64_t seed, double scale) {
  const NoiseKeys keys(seed, name);
  Canvas canvas(1.0, 1.0, 768 * scale, color, true);
  Weathering weathering;
  weathering.rust = 0.19;
  weathering.primer = 0.07;
  weathering.largest = 0.3;
  weathering.mussels = 30;
  Age(canvas, weathering, cv::Mat1b(), keys);
  return canvas.image();
}

cv::Mat3b PaintRubber(std::uint64_t seed, double scale) {
  const NoiseKeys keys(seed, "bus/rubber");
  Canvas canvas(1.0, 1.0, 640 * scale, Rgb(40, 40, 38), true);
  PanelPainter painter(canvas, [](double a, double b) { return cv::Point2d(a, b); });
  for (int i = 0; i < 10; ++i) {  // tread blocks in the middle, moulded rings on the flanks
    const double a = i / 10.0;
    for (const double b : {0.36, 0.46, 0.56})
      painter.Field(a + 0.012, b, a + 0.08, b + 0.085, Rgb(62, 61, 57));
  }
  for (const double b : {0.08, 0.14, 0.27, 0.72, 0.85, 0.91})
    painter.Stripe(0, b, 1, b, 0.008, Rgb(76, 75, 70));
  Weathering weathering;
  weathering.film = 0.26;
  weathering.algae = 0.17;
  weathering.silt = 0.30;
  weathering.silt_alpha = 0.8;
  weathering.mussels = 70;
  Overgrow(canvas, weathering, keys);
  return canvas.image();
}

cv::Mat3b PaintGlass(std::uint64_t seed, double scale) {
  const NoiseKeys keys(seed, "bus/glass");
  Canvas canvas(1.0, 1.0, 640 * scale, Rgb(44, 62, 56), true);
  Weathering weathering;
  weathering.film = 0.5;
  weathering.algae = 0.26;
  weathering.silt = 0.38;
  weathering.mussels = 60;
  canvas.Modulate(canvas.Noise(0.5, 0.03, 0.6, keys.Key("tint")), 0.2);
  canvas.Blend(ZeroLines(canvas.Noise(0.5, 0.25, 0.4, keys.Key("cracks")), 0.025),
               Rgb(170, 186, 176), 0.8);
  Overgrow(canvas, weathering, keys);
  return canvas.image();
}

cv::Mat3b PaintWeeds(std::uint64_t seed, double scale) {
  // Eight blades side by side, roots at the bottom.
  const NoiseKeys keys(seed, "bus/weeds");
  Canvas canvas(1.0, 1.0, 512 * scale, Rgb(60, 84, 34), false);
  RandomStream random(keys.Key("blades"), "blades");
  PanelPainter painter(canvas, [](double a, double b) { return cv::Point2d(a, b); });
  for (int i = 0; i < 8; ++i) {
    const double tone = random.Uniform(0.55, 1.15);
    const Rgb color(static_cast<std::uint8_t>(70 * tone), static_cast<std::uint8_t>(92 * tone),
                    static_cast<std::uint8_t>(40 * tone));
    painter.Field(i / 8.0, 0.0, (i + 1) / 8.0, 1.0, color);
    painter.Stripe((i + 0.5) / 8.0, 0.0, (i + 0.5) / 8.0, 1.0, 0.014, Rgb(112, 116, 62));
    for (int k = 0; k < 5; ++k) {
      const double b = random.Uniform();
      painter.Stripe(i / 8.0, b, (i + 1) / 8.0, b + random.Uniform(-0.02, 0.02), 0.01,
                     Rgb(52, 60, 30));
    }
  }
  canvas.Modulate(canvas.Noise(0.02, 0.006, 0.8, keys.Key("fibre"), 8.0), 0.12);
  Weathering weathering;
  weathering.algae = 0.07;
  weathering.film = 0.2;
  weathering.silt = 0.15;
  weathering.mussels = 0;
  Overgrow(canvas, weathering, keys);
  return canvas.image();
}

}  // namespace

std::vector<TextureTask> MaterialTextures() {
  const auto paint = [](const Rgb& color, const char* name) {
    return [color, name](std::uint64_t seed, double scale) {
      return PaintPaint(color, name, seed, scale);
    };
  };
  return {{"stone", PaintStone},
          {"bark", PaintBark},
          {"planks", PaintPlanks},
          {"bare_rust", PaintBareRust},
          {"black_paint", paint(Rgb(40, 40, 38), "bus/black_paint")},
          {"yellow_paint", paint(Rgb(214, 158, 38), "bus/yellow_paint")},
          {"rubber", PaintRubber},
          {"glass", PaintGlass},
          {"weeds", PaintWeeds}};
}

}  // namespace drydock::scenes::bus
