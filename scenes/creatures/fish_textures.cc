#include "scenes/creatures/fish_textures.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "scenes/creatures/fish_shape.h"
#include "scenes/mesh/smooth_step.h"
#include "scenes/texture/stamps.h"

namespace drydock::scenes::creatures {
namespace {

constexpr double kPixelsPerMetre = 1024.0;

/// Colours of one kind and what marks it.
struct Coat {
  Rgb back, flank, belly;
  Rgb fin;        ///< On the back and the tail.
  Rgb lower_fin;  ///< Under the belly.
  Rgb eye;
  double scale = 0.017;  ///< Length of a scale [of the fish].
  double bars = 0.0;     ///< Darkness of bars across the flank.
  double stripes = 0.0;  ///< Darkness of lines along the rows of scales.
  double spots = 0.0;    ///< Share of the back that dark spots cover.
};

Coat CoatOf(const std::string& kind) {
  Coat coat;
  if (kind == "bass") {
    coat.back = {52, 60, 48};
    coat.flank = {158, 162, 140};
    coat.belly = {226, 224, 210};
    coat.fin = {116, 118, 98};
    coat.lower_fin = {166, 162, 140};
    coat.eye = {196, 176, 92};
    coat.scale = 0.015;
    coat.spots = 0.16;
  } else if (kind == "perch") {
    coat.back = {54, 62, 30};
    coat.flank = {150, 142, 66};
    coat.belly = {222, 212, 176};
    coat.fin = {108, 110, 72};
    coat.lower_fin = {190, 84, 40};
    coat.eye = {206, 150, 52};
    coat.scale = 0.014;
    coat.bars = 0.78;
  } else {  // bream
    coat.back = {66, 76, 80};
    coat.flank = {188, 192, 188};
    coat.belly = {232, 232, 226};
    coat.fin = {112, 116, 116};
    coat.lower_fin = {150, 148, 140};
    coat.eye = {212, 196, 130};
    coat.scale = 0.019;
    coat.stripes = 0.22;
  }
  return coat;
}

/// The canvas' pixels in a rectangle [m] set by `shade(x, y, colour)`.
void ForPixels(Canvas& canvas, const cv::Rect2d& area,
               const std::function<cv::Vec3f(double x, double y, const cv::Vec3f&)>& shade) {
  const double metres = 1.0 / canvas.scale();
  for (int row = 0; row < canvas.size().height; ++row) {
    const double y = (row + 0.5) * metres;
    if (y < area.y || y > area.y + area.height) continue;
    for (int column = 0; column < canvas.size().width; ++column) {
      const double x = (column + 0.5) * metres;
      if (x < area.x || x > area.x + area.width) continue;
      Rgb& pixel = canvas.image()(row, column);
      const cv::Vec3f shaded = shade(x, y, cv::Vec3f(pixel[0], pixel[1], pixel[2]));
      for (int c = 0; c < 3; ++c)
        pixel[c] = static_cast<std::uint8_t>(std::clamp(shaded[c], 0.0F, 255.0F));
    }
  }
}

float Step(double low, double high, double x) {
  return static_cast<float>(SmoothStep(low, high, x));
}

cv::Vec3f Float(const Rgb& c) { return {float(c[0]), float(c[1]), float(c[2])}; }

/// How dark the net between the scales is at a place, from 0 to 1.
double Net(double x, double y, double scale) {
  const double a = std::numbers::pi * x / scale;
  const double b = std::numbers::pi * y / (1.15 * scale);
  const double line = std::min(std::abs(std::sin(a + b)), std::abs(std::sin(a - b)));
  return 1.0 - Step(0.08, 0.45, line);
}

/// Bars of a perch: six, uneven, fading towards the belly.
double Bars(double x, double y, double warp) {
  const double phase = (x + 0.012 * warp - 0.23) / 0.108;
  if (phase < -0.4 || phase > 5.6) return 0.0;
  const double across = std::abs(phase - std::round(phase));
  const double width = 0.27 - 0.30 * (y / FishPicture::kSkin);
  return (1.0 - Step(width - 0.09, width + 0.06, across)) *
         (1.0 - Step(0.50, 0.74, y / FishPicture::kSkin));
}

void PaintSkin(Canvas& canvas, const Coat& coat, const NoiseKeys& keys) {
  const cv::Mat1f warp = canvas.Noise(0.12, 0.008, 0.6, keys.Key("warp"));
  const cv::Mat1f fine = canvas.Noise(0.012, 0.002, 0.8, keys.Key("fine"));
  const cv::Mat1f spots = canvas.Noise(0.035, 0.008, 0.5, keys.Key("spots"));
  const cv::Mat1b spotted = Coverage(spots, coat.spots, 0.35);
  const cv::Rect2d skin(0.0, 0.0, FishPicture::kWidth, FishPicture::kSkin + 0.01);
  ForPixels(canvas, skin, [&](double x, double y, const cv::Vec3f&) {
    const int row = static_cast<int>(y * canvas.scale());
    const int column = static_cast<int>(x * canvas.scale());
    const float w = warp(row, column);
    const double v = y / FishPicture::kSkin + 0.02 * w;  // 0 at the back, 1 at the belly.
    cv::Vec3f color = Float(coat.back) * (1.0F - Step(0.16, 0.44, v)) +
                      Float(coat.flank) * (Step(0.16, 0.44, v) - Step(0.52, 0.80, v)) +
                      Float(coat.belly) * Step(0.52, 0.80, v);
    const float scaled = Step(0.19, 0.24, x) * (1.0F - Step(0.84, 0.87, x));
    const auto net = static_cast<float>(Net(x, y, coat.scale));
    color *= 1.0F - scaled * net * (0.33F - 0.18F * Step(0.45, 0.9, v));
    const double rows = std::abs(std::sin(std::numbers::pi * y / (2.3 * coat.scale)));
    color *= 1.0F - static_cast<float>(coat.stripes) * scaled * (1.0F - Step(0.1, 0.5, rows)) *
                        (1.0F - Step(0.6, 0.8, v));
    color *= 1.0F - static_cast<float>(coat.bars * Bars(x, y, w));
    const float spot = static_cast<float>(spotted(row, column)) / 255.0F;
    color *= 1.0F - 0.6F * spot * (1.0F - Step(0.35, 0.55, v));
    // The root of the tail takes on the fin's colour.
    const float tail = Step(0.79, 0.86, x);
    color = color * (1.0F - tail) + Float(coat.fin) * 1.12F * tail;
    return color * (1.0F + 0.07F * fine(row, column) + 0.06F * w);
  });
}

/// Lips, gill cover, lateral line and eye.
void DrawHead(Canvas& canvas, const Coat& coat) {
  const Rgb dark(34, 34, 30);
  const double h = FishPicture::kSkin;
  cv::Mat1b lines = canvas.Mask();
  for (int i = 0; i < 26; ++i) {  // The gill cover bulges backwards.
    const auto at = [&](int k) {
      const double t = k / 26.0;
      return cv::Point2d(0.165 + 0.055 * std::sin(std::numbers::pi * t), h * (0.20 + 0.64 * t));
    };
    DrawLine(canvas, lines, at(i), at(i + 1), 0.007);
  }
  DrawLine(canvas, lines, {0.0, 0.52 * h}, {0.030, 0.55 * h}, 0.007);
  DrawLine(canvas, lines, {0.030, 0.55 * h}, {0.052, 0.64 * h}, 0.005);
  canvas.Blend(lines, dark, 0.75);
  cv::Mat1b lateral = canvas.Mask();
  for (double s = 0.215; s < 0.85; s += 0.014) {
    const auto y = [&](double x) { return h * (0.34 + 0.15 * Step(0.2, 0.75, x)); };
    DrawLine(canvas, lateral, {s, y(s)}, {s + 0.009, y(s + 0.009)}, 0.004);
  }
  canvas.Blend(lateral, dark, 0.6);
  const cv::Point2d eye(0.088, 0.36 * h);
  const auto disc = [&](double radius, const Rgb& color, double dx) {
    // The picture is as high as the fish is round: a circle on the head is an ellipse here.
    FillEllipse(canvas, eye.x + dx, eye.y, radius, 1.5 * radius, 0.0, color);
  };
  disc(0.027, dark, 0.0);
  disc(0.024, coat.eye, 0.0);
  disc(0.014, {8, 8, 8}, 0.001);
  disc(0.004, {236, 236, 236}, -0.005);
}

/// Rays from the root of a fin (top) to its edge.
void PaintFin(Canvas& canvas, const UvRect& uv, const Rgb& color, double rays, bool spread) {
  const double w = FishPicture::kWidth;
  const double h = FishPicture::kHeight;
  const cv::Rect2d area(uv.low.x() * w - 0.01, uv.low.y() * h - 0.01,
                        (uv.high.x() - uv.low.x()) * w + 0.02,
                        (uv.high.y() - uv.low.y()) * h + 0.02);
  ForPixels(canvas, area, [&](double x, double y, const cv::Vec3f&) {
    const double s = (x / w - uv.low.x()) / (uv.high.x() - uv.low.x());
    const double t = std::clamp((y / h - uv.low.y()) / (uv.high.y() - uv.low.y()), 0.0, 1.0);
    const double ray = std::abs(std::sin(std::numbers::pi * rays * s));
    const double split = spread && t > 0.45 ? std::abs(std::cos(std::numbers::pi * rays * s)) : 1.0;
    const float line = 1.0F - Step(0.12, 0.55, std::min(ray, split));
    cv::Vec3f shade = Float(color) * (1.12F - 0.35F * static_cast<float>(t));
    shade = shade * (1.0F - 0.42F * line);
    const double edge = spread ? std::max(t, 2.0 * std::abs(s - 0.5)) : t;
    return shade * (1.0F - 0.45F * Step(0.86, 0.99, edge));
  });
}

cv::Mat3b PaintFish(const std::string& kind, std::uint64_t seed, double scale) {
  const Coat coat = CoatOf(kind);
  const NoiseKeys keys(seed, "creatures/" + kind);
  Canvas canvas(FishPicture::kWidth, FishPicture::kHeight, kPixelsPerMetre * scale, coat.fin);
  PaintSkin(canvas, coat, keys);
  DrawHead(canvas, coat);
  PaintFin(canvas, FishPicture::Tail(), coat.fin, 17.0, true);
  PaintFin(canvas, FishPicture::Dorsal(), coat.fin, 34.0, false);
  PaintFin(canvas, FishPicture::Anal(), coat.lower_fin, 16.0, false);
  PaintFin(canvas, FishPicture::Paired(), coat.lower_fin, 9.0, true);
  return canvas.image();
}

}  // namespace

std::vector<TextureTask> FishTextures() {
  std::vector<TextureTask> tasks;
  for (const FishShape& shape : FishShapes()) {
    const std::string kind = shape.kind;
    tasks.push_back(
        {kind, [kind](std::uint64_t seed, double scale) { return PaintFish(kind, seed, scale); }});
  }
  return tasks;
}

}  // namespace drydock::scenes::creatures
