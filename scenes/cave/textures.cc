#include "scenes/cave/textures.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "scenes/cave/blocks.h"
#include "scenes/cave/ground.h"
#include "scenes/cave/limestone.h"
#include "scenes/cave/walls.h"
#include "scenes/texture/materials.h"
#include "scenes/texture/stamps.h"

namespace drydock::scenes::cave {
namespace {

constexpr double kRockScale = 300.0;  // [pixels/m]

/// As wide and as high as one repetition.
TextureTask RockTask(const std::string& name, const Limestone& look, double tile, double pixels) {
  return {name, [=](std::uint64_t seed, double scale) {
            const NoiseKeys keys(seed, "cave/" + name);
            Canvas canvas(tile, tile, pixels * scale, look.dark, true);
            PaintLimestone(canvas, look, keys);
            return canvas.image();
          }};
}

TextureTask WallTask(const std::string& name, const Limestone& look) {
  return RockTask(name, look, kRockTile, kRockScale);
}

Limestone Pale() {
  Limestone look;
  look.bright = Rgb(226, 214, 188);
  return look;
}

Limestone Stained() {
  Limestone look;
  look.dark = Rgb(98, 78, 54);
  look.bright = Rgb(196, 170, 128);
  look.iron = 0.42;
  look.manganese = 0.06;
  look.streaks = 0.22;
  look.fossils = 7.0;
  return look;
}

Limestone Bedded() {
  Limestone look;
  look.beds = 1.0;
  look.cracks = 0.25;
  look.holes = 0.03;
  look.streaks = 0.06;
  look.manganese = 0.02;
  return look;
}

Limestone Sponge() {
  Limestone look;
  look.beds = 0.15;
  look.pits = 0.16;
  look.holes = 0.24;
  look.iron = 0.08;
  look.cracks = 0.2;
  return look;
}

Limestone Crust() {
  Limestone look;
  look.iron = 0.3;
  look.manganese = 0.42;
  look.streaks = 0.05;
  look.cracks = 0.5;
  look.holes = 0.05;
  return look;
}

Limestone Ceiling() {
  Limestone look;
  look.dark = Rgb(128, 116, 92);
  look.bright = Rgb(222, 212, 188);
  look.beds = 0.1;
  look.cracks = 0.55;
  look.holes = 0.10;
  look.streaks = 0.0;
  look.silt = 0.0;
  look.manganese = 0.06;
  return look;
}

Limestone Dusted() {
  Limestone look;
  look.silt = 0.5;
  look.streaks = 0.0;
  look.holes = 0.03;
  look.beds = 0.1;
  return look;
}

Limestone Broken() {
  Limestone look;
  look.dark = Rgb(124, 112, 90);
  look.bright = Rgb(224, 216, 194);
  look.beds = 0.5;
  look.cracks = 0.35;
  look.holes = 0.03;
  look.iron = 0.10;
  look.manganese = 0.03;
  look.streaks = 0.0;
  look.silt = 0.14;
  look.fossils = 18.0;
  return look;
}

cv::Mat3b PaintDripstone(std::uint64_t seed, double scale) {
  const NoiseKeys keys(seed, "cave/dripstone");
  Canvas canvas(0.8, kDripstoneTile, 500 * scale, Rgb(176, 150, 112), true);
  canvas.Blend(Everywhere(canvas), canvas.Noise(0.25, 0.005, 0.7, keys.Key("base")),
               Rgb(122, 96, 64), Rgb(220, 202, 168));
  // Rings of growth, and what ran down over them.
  const cv::Mat1f rings = canvas.Noise(0.8, 0.02, 0.7, keys.Key("rings"), 0.06);
  canvas.Blend(Coverage(rings, 0.3, 0.5), Rgb(84, 60, 38), 0.55);
  canvas.Blend(ZeroLines(rings, 0.10), Rgb(48, 36, 26), 0.5);
  const cv::Mat1f runs = canvas.Noise(0.04, 0.006, 0.75, keys.Key("runs"), 8.0);
  canvas.Blend(Coverage(runs, 0.2, 0.5), Rgb(232, 218, 188), 0.6);
  canvas.Blend(Coverage(-runs, 0.15, 0.5), Rgb(70, 52, 36), 0.6);
  canvas.Blend(Coverage(canvas.Noise(0.12, 0.005, 0.7, keys.Key("spots")), 0.08, 0.1),
               Rgb(36, 28, 22), 0.8);
  AddGrain(canvas, 0.10, 0.05, keys);
  return canvas.image();
}

void StrewSand(Canvas& canvas, const NoiseKeys& keys) {
  RandomStream random(keys.Key("things"), "strewn");
  const auto pebble = [](double low, double high) -> DrawThing {
    return [low, high](Canvas& c, double x, double y, double size, RandomStream& r) {
      DrawPebble(c, x, y, low + (high - low) * size * size * size, r);
    };
  };
  Strew(canvas, 6500, random, pebble(0.003, 0.018));
  Strew(canvas, 700, random, pebble(0.01, 0.07));
  Strew(canvas, 420, random, [](Canvas& c, double x, double y, double size, RandomStream& r) {
    DrawShell(c, x, y, 0.01 + 0.035 * size, r);
  });
  Strew(canvas, 46, random, [](Canvas& c, double x, double y, double size, RandomStream& r) {
    DrawTwig(c, x, y, 0.08 + 0.27 * size, r);
  });
}

cv::Mat3b PaintSand(std::uint64_t seed, double scale) {
  const NoiseKeys keys(seed, "cave/sand");
  Canvas canvas(kSandTile, kSandTile, 240 * scale, Rgb(170, 158, 130), true);
  const cv::Mat1f fine = canvas.Noise(0.03, 0.004, 0.85, keys.Key("fine"));
  canvas.Blend(Everywhere(canvas), canvas.Noise(1.4, 0.01, 0.64, keys.Key("base")),
               Rgb(112, 100, 76), Rgb(208, 198, 168));
  const cv::Mat1f ripples = Ripples(canvas, keys, {22, 31, 3.2, 1.9, 0.4F, 1.2F});
  canvas.Blend(Ramp(ripples, 0.4, 1.2), Rgb(214, 204, 174), 0.5);
  canvas.Blend(Ramp(-ripples, 0.4, 1.2), Rgb(88, 76, 56), 0.55);
  canvas.Blend(Coverage(canvas.Noise(0.9, 0.006, 0.68, keys.Key("silt")), 0.16, 0.3), fine,
               Rgb(58, 49, 36), Rgb(104, 90, 66), 0.85);
  canvas.Blend(Coverage(canvas.Noise(0.7, 0.006, 0.66, keys.Key("bright")), 0.10, 0.3), fine,
               Rgb(176, 166, 138), Rgb(228, 220, 196), 0.8);
  StrewSand(canvas, keys);
  AddGrain(canvas, 0.09, 0.03, keys);
  return canvas.image();
}

}  // namespace

std::vector<TextureTask> TextureTasks() {
  return {WallTask("rock_pale", Pale()),     WallTask("rock_stained", Stained()),
          WallTask("rock_bedded", Bedded()), WallTask("rock_sponge", Sponge()),
          WallTask("rock_crust", Crust()),   WallTask("rock_ceiling", Ceiling()),
          WallTask("rock_dusted", Dusted()), RockTask("rock_broken", Broken(), kBlockTile, 420.0),
          {"dripstone", PaintDripstone},     {"sand", PaintSand}};
}

}  // namespace drydock::scenes::cave
