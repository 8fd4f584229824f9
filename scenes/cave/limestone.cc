#include "scenes/cave/limestone.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "scenes/texture/materials.h"
#include "scenes/texture/stamps.h"

namespace drydock::scenes::cave {
namespace {

const Rgb kHollowDark(40, 34, 26);
const Rgb kHollowBright(84, 72, 54);
const Rgb kIronDark(112, 66, 32);
const Rgb kIronBright(178, 122, 66);
const Rgb kCrustDark(34, 26, 19);
const Rgb kCrustBright(92, 70, 48);
const Rgb kSiltDark(132, 120, 94);
const Rgb kSiltBright(182, 170, 140);

/// Where both masks are.
cv::Mat1b Within(const cv::Mat1b& a, const cv::Mat1b& b) { return a.mul(b, 1.0 / 255.0); }

/// The round shells of large foraminifers, cut at any angle.
void DrawCoin(Canvas& canvas, double x, double y, double radius, RandomStream& random) {
  const double angle = random.Uniform(0.0, std::numbers::pi);
  const double narrow = random.Uniform(0.12, 1.0);
  FillEllipse(canvas, x, y, 1.3 * radius, 1.3 * narrow * radius + 0.002, angle, Rgb(84, 72, 54));
  FillEllipse(canvas, x, y, radius, narrow * radius, angle, Rgb(226, 218, 196));
  FillEllipse(canvas, x, y, 0.45 * radius, 0.4 * narrow * radius, angle, Rgb(176, 162, 132));
}

/// A crust that covers what is there, dark at its rim, with flaked spots.
void Cover(Canvas& canvas, const cv::Mat1f& field, double fraction, const cv::Mat1f& fine,
           const Rgb& low, const Rgb& high, double alpha) {
  if (fraction <= 0.0) return;
  canvas.Blend(Coverage(field, std::min(1.25 * fraction + 0.02, 1.0), 0.25), low, 0.45 * alpha);
  canvas.Blend(Coverage(field, fraction, 0.10), fine, low, high, alpha);
}

void AddBeds(Canvas& canvas, const Limestone& look, const NoiseKeys& keys) {
  const cv::Mat1f tone = canvas.Noise(1.6, 0.05, 0.7, keys.Key("bed tone"), 0.10);
  canvas.Blend(Everywhere(canvas), tone, look.dark, look.bright, 0.30 * look.beds);
  const cv::Mat1f lines = canvas.Noise(1.9, 0.06, 0.55, keys.Key("bed lines"), 0.12);
  const cv::Mat1b where =
      Coverage(canvas.Noise(1.1, 0.03, 0.6, keys.Key("beds where")), 0.5 * look.beds + 0.2, 0.7);
  canvas.Blend(Within(ZeroLines(lines, 0.05), where), kHollowDark, std::min(0.8, 1.2 * look.beds));
  canvas.Blend(Within(ZeroLines(lines + 0.45F, 0.03), where), kHollowBright, 0.7);
}

void AddCracks(Canvas& canvas, const Limestone& look, const NoiseKeys& keys) {
  const cv::Mat1f coarse = canvas.Noise(1.3, 0.015, 0.52, keys.Key("cracks"));
  const cv::Mat1f fine = canvas.Noise(0.30, 0.01, 0.55, keys.Key("fine cracks"));
  const cv::Mat1b where =
      Coverage(canvas.Noise(0.9, 0.05, 0.6, keys.Key("cracks where")), look.cracks, 0.6);
  // Worn edges, then the gap.
  canvas.Blend(Within(ZeroLines(coarse, 0.07), where), look.bright, 0.35);
  canvas.Blend(Within(ZeroLines(coarse, 0.032), where), Rgb(26, 22, 17), 0.9);
  canvas.Blend(Within(ZeroLines(fine, 0.05), where), kHollowDark, 0.55);
}

void AddHollows(Canvas& canvas, const Limestone& look, const cv::Mat1f& fine,
                const NoiseKeys& keys) {
  const cv::Mat1f pits = canvas.Noise(0.10, 0.005, 0.62, keys.Key("pits"));
  canvas.Blend(Coverage(pits, 1.7 * look.pits, 0.06), look.bright, 0.5);
  canvas.Blend(Coverage(pits, look.pits, 0.10), fine, kHollowDark, kHollowBright, 0.9);
  // Larger ones: a worn rim that catches light, and the darker the deeper.
  const cv::Mat1f holes = canvas.Noise(0.22, 0.02, 0.42, keys.Key("holes")) +
                          0.8F * canvas.Noise(1.4, 0.2, 0.5, keys.Key("holes where"));
  const auto deeper = [&](double share) {
    return Coverage(0.78F * holes, share * look.holes, 0.10);
  };
  canvas.Blend(deeper(1.5), look.bright, 0.55);
  canvas.Blend(deeper(1.0), fine, kHollowDark, look.dark, 0.8);
  canvas.Blend(deeper(0.65), fine, kHollowDark, kHollowBright, 0.8);
  canvas.Blend(deeper(0.35), Rgb(30, 25, 19), 0.85);
}

void AddStains(Canvas& canvas, const Limestone& look, const cv::Mat1f& fine,
               const NoiseKeys& keys) {
  const cv::Mat1f iron = canvas.Noise(1.3, 0.006, 0.64, keys.Key("iron"));
  if (look.iron > 0.0)
    canvas.Blend(Coverage(iron, look.iron, 0.8), fine, kIronDark, kIronBright, 0.62);
  const cv::Mat1f thin = canvas.Noise(0.05, 0.008, 0.75, keys.Key("streaks"), 16.0);
  const cv::Mat1f where = canvas.Noise(0.9, 0.08, 0.6, keys.Key("streaks where"));
  canvas.Blend(Coverage(0.75F * thin + 0.65F * where, look.streaks, 0.7), kCrustBright, 0.55);
  canvas.Blend(Coverage(0.75F * thin - 0.65F * where, 0.6 * look.streaks, 0.7), look.bright, 0.4);
  const cv::Mat1f crust = canvas.Noise(1.1, 0.005, 0.66, keys.Key("crust"));
  Cover(canvas, crust, look.manganese, fine, kCrustDark, kCrustBright, 0.9);
  const cv::Mat1f dots = canvas.Noise(0.14, 0.006, 0.6, keys.Key("dots")) + 0.7F * iron;
  Cover(canvas, 0.8F * dots, 0.02 + 0.2 * look.manganese, fine, kCrustDark, kCrustBright, 0.8);
}

void AddFossils(Canvas& canvas, const Limestone& look, const NoiseKeys& keys) {
  RandomStream random(keys.Key("fossils"), "fossils");
  const double area = canvas.width() * canvas.height();
  const auto count = [&](double share) { return static_cast<int>(share * look.fossils * area); };
  Strew(canvas, count(0.7), random,
        [](Canvas& c, double x, double y, double size, RandomStream& r) {
          DrawCoin(c, x, y, 0.005 + 0.012 * size * size, r);
        });
  Strew(canvas, count(0.3), random,
        [](Canvas& c, double x, double y, double size, RandomStream& r) {
          DrawShell(c, x, y, 0.012 + 0.038 * size, r);
        });
}

}  // namespace

void AddGrain(Canvas& canvas, double grain, double specks, const NoiseKeys& keys) {
  canvas.Modulate(canvas.Noise(0.05, 0.004, 0.9, keys.Key("grain")), grain);
  const cv::Mat1f dots = canvas.Noise(0.016, 0.007, 0.8, keys.Key("specks"));
  canvas.Blend(Coverage(dots, specks, 0.4), Rgb(34, 29, 22), 0.7);
  canvas.Blend(Coverage(-dots, 0.7 * specks, 0.4), Rgb(214, 202, 174), 0.4);
}

void PaintLimestone(Canvas& canvas, const Limestone& look, const NoiseKeys& keys) {
  const cv::Mat1f fine = canvas.Noise(0.04, 0.003, 0.82, keys.Key("fine"));
  canvas.Blend(Everywhere(canvas), canvas.Noise(1.2, 0.006, 0.68, keys.Key("base")), look.dark,
               look.bright);
  AddBeds(canvas, look, keys);
  AddFossils(canvas, look, keys);
  AddHollows(canvas, look, fine, keys);
  AddStains(canvas, look, fine, keys);
  AddCracks(canvas, look, keys);
  canvas.Blend(Coverage(canvas.Noise(0.8, 0.006, 0.64, keys.Key("silt")), look.silt, 0.5), fine,
               kSiltDark, kSiltBright, 0.8);
  AddGrain(canvas, 0.10, 0.035, keys);
}

}  // namespace drydock::scenes::cave
