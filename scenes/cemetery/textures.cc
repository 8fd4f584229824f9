#include "scenes/cemetery/textures.h"

#include <algorithm>
#include <cmath>

#include "scenes/cemetery/growth.h"
#include "scenes/cemetery/site.h"
#include "scenes/texture/stamps.h"
#include "scenes/texture/weathering.h"

namespace drydock::scenes::cemetery {
namespace {

cv::Mat3b PaintPlainStone(const StoneColors& colors, const char* name, std::uint64_t seed,
                          double scale) {
  const NoiseKeys keys(seed, name);
  Canvas canvas(1.5, 1.5, 480 * scale, Rgb(140, 134, 118), true);
  PaintStone(canvas, keys, colors);
  OvergrowStone(canvas, keys);
  return canvas.image();
}

void StrewLitter(Canvas& canvas, std::uint64_t key) {
  RandomStream random(key, "strewn");
  Strew(canvas, 110, random, [](Canvas& c, double x, double y, double size, RandomStream& look) {
    DrawTwig(c, x, y, 0.1 + 0.3 * size, look);
  });
  Strew(canvas, 3600, random, [](Canvas& c, double x, double y, double size, RandomStream& look) {
    DrawPebble(c, x, y, 0.003 + 0.03 * size * size * size * size, look);
  });
  Strew(canvas, 160, random, [](Canvas& c, double x, double y, double size, RandomStream& look) {
    DrawShell(c, x, y, 0.012 + 0.03 * size, look);
  });
  Strew(canvas, 900, random, [](Canvas& c, double x, double y, double size, RandomStream& look) {
    DrawLeaf(c, x, y, 0.04 + 0.10 * size, look);
  });
}

/// Grey-brown silt with mats of algae and a litter of leaves.
cv::Mat3b PaintSilt(std::uint64_t seed, double scale) {
  const NoiseKeys keys(seed, "cemetery/silt");
  Canvas canvas(kSiltPeriod, kSiltPeriod, 270 * scale, Rgb(120, 110, 88), true);
  const cv::Mat1f fine = canvas.Noise(0.03, 0.004, 0.85, keys.Key("fine"));
  canvas.Blend(Everywhere(canvas), canvas.Noise(1.3, 0.01, 0.64, keys.Key("base")), Rgb(84, 76, 58),
               Rgb(166, 155, 126));
  canvas.Blend(Coverage(canvas.Noise(0.8, 0.006, 0.68, keys.Key("detritus")), 0.20, 0.3), fine,
               Rgb(38, 32, 23), Rgb(78, 68, 50), 0.85);
  canvas.Blend(Coverage(canvas.Noise(0.9, 0.006, 0.66, keys.Key("mats")), 0.12, 0.15), fine,
               Rgb(36, 42, 22), Rgb(84, 90, 50), 0.85);
  canvas.Blend(Coverage(canvas.Noise(0.4, 0.006, 0.66, keys.Key("bright")), 0.06, 0.6), fine,
               Rgb(132, 123, 99), Rgb(182, 173, 146), 0.7);
  canvas.Modulate(fine, 0.10);
  StrewLitter(canvas, keys.Key("things"));
  return canvas.image();
}

void DrawBlade(Canvas& canvas, double left, double width, RandomStream& random) {
  const double tone = random.Uniform(0.6, 1.2);
  const double yellow = random.Uniform(0.0, 22.0);
  const auto shade = [tone](double level) {
    return static_cast<std::uint8_t>(std::clamp(tone * level, 0.0, 255.0));
  };
  FillRectangle(canvas, {left, 0.0}, {left + width, canvas.height()},
                {shade(72 + yellow), shade(96), shade(42)});
  const double middle = left + 0.5 * width;
  DrawLine(canvas, {middle, 0.0}, {middle, canvas.height()}, 0.12 * width,
           {shade(118), shade(126), shade(70)});
  for (int k = 0; k < 4; ++k) {  // fibres
    const double x = left + random.Uniform(0.1, 0.9) * width;
    const double y = random.Uniform(-0.3, 0.8) * canvas.height();
    DrawLine(canvas, {x, y}, {x, y + 0.5 * canvas.height()}, 0.06 * width,
             {shade(54), shade(66), shade(34)});
  }
}

/// A brown leaf with its rib and veins; the mesh has the outline.
void DrawDeadLeaf(Canvas& canvas, double left, double width, RandomStream& random) {
  const double tone = random.Uniform(0.65, 1.25);
  const auto shade = [tone](double level) {
    return static_cast<std::uint8_t>(std::clamp(tone * level, 0.0, 255.0));
  };
  FillRectangle(canvas, {left, 0.0}, {left + width, canvas.height()},
                {shade(128), shade(94), shade(56)});
  const Rgb vein(shade(84), shade(60), shade(36));
  const double middle = left + 0.5 * width;
  DrawLine(canvas, {middle, 0.0}, {middle, canvas.height()}, 0.10 * width, vein);
  for (int k = 1; k < 9; ++k) {
    const double y = canvas.height() * k / 9.0;
    for (const double side : {0.0, width}) {
      DrawLine(canvas, {middle, y}, {left + side, y - 0.09}, 0.03 * width, vein);
    }
  }
}

cv::Mat3b PaintPlants(std::uint64_t seed, double scale) {
  const NoiseKeys keys(seed, "cemetery/plants");
  Canvas canvas(1.0, 1.0, 512 * scale, Rgb(70, 90, 44));
  RandomStream random(keys.Key("columns"), "columns");
  const double width = canvas.width() / kPlantColumns;
  for (int i = 0; i < kPlantColumns; ++i) {
    if (i < kBladeColumns) DrawBlade(canvas, i * width, width, random);
    if (i >= kBladeColumns) DrawDeadLeaf(canvas, i * width, width, random);
  }
  canvas.Modulate(canvas.Noise(0.02, 0.006, 0.8, keys.Key("fibre"), 6.0), 0.14);
  Weathering weathering;
  weathering.algae = 0.06;
  weathering.film = 0.2;
  weathering.silt = 0.18;
  weathering.mussels = 0.0;
  Overgrow(canvas, weathering, keys);
  return canvas.image();
}

cv::Mat3b PaintIron(std::uint64_t seed, double scale) {
  const NoiseKeys keys(seed, "cemetery/iron");
  Canvas canvas(0.8, 0.8, 800 * scale, Rgb(90, 60, 40), true);
  PaintRust(canvas, keys);
  Weathering weathering;
  weathering.algae = 0.16;
  weathering.silt = 0.14;
  weathering.mussels = 40.0;
  Overgrow(canvas, weathering, keys);
  return canvas.image();
}

/// Sodden wood with grooves along it.
cv::Mat3b PaintBark(std::uint64_t seed, double scale) {
  const NoiseKeys keys(seed, "cemetery/bark");
  Canvas canvas(0.5, 0.5, 900 * scale, Rgb(70, 56, 42), true);
  const cv::Mat1f fibre = canvas.Noise(0.04, 0.004, 0.75, keys.Key("fibre"), 5.0);
  canvas.Blend(Everywhere(canvas), fibre, Rgb(40, 32, 25), Rgb(112, 92, 68));
  canvas.Blend(Coverage(canvas.Noise(0.2, 0.005, 0.65, keys.Key("bare")), 0.2, 0.1), fibre,
               Rgb(102, 84, 60), Rgb(166, 146, 112), 0.85);
  Weathering weathering;
  weathering.algae = 0.2;
  weathering.silt = 0.16;
  weathering.mussels = 30.0;
  Overgrow(canvas, weathering, keys);
  return canvas.image();
}

}  // namespace

StoneColors SlateColors() {
  return {{52, 54, 54}, {118, 120, 116}, {26, 27, 27},
          {58, 58, 54}, {120, 122, 104}, {176, 176, 156}};
}

void OvergrowStone(Canvas& canvas, const NoiseKeys& keys) {
  Weathering weathering;
  weathering.film = 0.35;
  weathering.algae = 0.17;
  weathering.silt = 0.12;
  weathering.mussels = 26.0;
  weathering.grain = 0.07;
  weathering.specks = 0.03;
  Overgrow(canvas, weathering, keys);
}

std::vector<TextureTask> TextureTasks() {
  const auto stone = [](const StoneColors& colors, const char* name) {
    return [colors, name](std::uint64_t seed, double scale) {
      return PaintPlainStone(colors, name, seed, scale);
    };
  };
  return {{"silt", PaintSilt},
          {"limestone", stone({}, "cemetery/limestone")},
          {"slate", stone(SlateColors(), "cemetery/slate")},
          {"inscriptions",
           [](std::uint64_t seed, double scale) {
             return PaintInscriptions(Inscriptions(seed), seed, scale);
           }},
          {"plants", PaintPlants},
          {"iron", PaintIron},
          {"bark", PaintBark}};
}

}  // namespace drydock::scenes::cemetery
