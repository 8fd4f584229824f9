#include "scenes/creatures/arm_texture.h"

#include <cmath>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "scenes/creatures/arm_shape.h"
#include "scenes/texture/stamps.h"

namespace drydock::scenes::creatures {
namespace {

constexpr double kPixelsPerMetre = 1600.0;
const Rgb kThread(118, 120, 120);

/// Everything dark cloth with a fine weave, worn and a little salty.
void PaintCloth(Canvas& canvas, const NoiseKeys& keys) {
  const cv::Mat1b all(canvas.size(), std::uint8_t{255});
  const cv::Mat1f fine = canvas.Noise(0.006, 0.0015, 0.85, keys.Key("weave"));
  canvas.Blend(all, canvas.Noise(0.10, 0.004, 0.65, keys.Key("cloth")), Rgb(26, 28, 33),
               Rgb(62, 64, 70));
  canvas.Blend(Coverage(canvas.Noise(0.03, 0.002, 0.75, keys.Key("lint")), 0.05, 0.2), fine,
               Rgb(84, 84, 80), Rgb(150, 148, 138), 0.6);
  canvas.Blend(Coverage(canvas.Noise(0.14, 0.003, 0.7, keys.Key("worn")), 0.22, 0.5), fine,
               Rgb(66, 68, 72), Rgb(96, 98, 100), 0.6);
  canvas.Modulate(fine, 0.12);
}

/// A flat seam: a dark joint between two rows of zigzag stitches.
void Sew(Canvas& canvas, cv::Point2d from, cv::Point2d to) {
  const cv::Point2d d = to - from;
  const double length = std::hypot(d.x, d.y);
  const cv::Point2d ahead = d * (1.0 / length);
  const cv::Point2d aside(-ahead.y, ahead.x);
  DrawLine(canvas, from, to, 0.0022, Rgb(12, 12, 14));
  constexpr double kStitch = 0.0035;
  const int count = static_cast<int>(length / kStitch);
  for (int i = 0; i < count; ++i) {
    const cv::Point2d a = from + ahead * (kStitch * i) + aside * (i % 2 == 0 ? 0.0032 : -0.0032);
    const cv::Point2d b =
        from + ahead * (kStitch * (i + 1)) + aside * (i % 2 == 0 ? -0.0032 : 0.0032);
    DrawLine(canvas, a, b, 0.0010, kThread);
  }
}

void PaintSleeve(Canvas& canvas) {
  constexpr double kWide = ArmPicture::kSleeveWidth;
  constexpr double kElbow = ArmPicture::kElbow;
  // A coloured panel down the side, between seams.
  FillPolygon(canvas, {{0.072, 0.0}, {0.102, 0.0}, {0.096, kElbow + 0.26}, {0.080, kElbow + 0.26}},
              Rgb(146, 34, 30));
  Sew(canvas, {0.072, 0.0}, {0.080, kElbow + 0.26});
  Sew(canvas, {0.102, 0.0}, {0.096, kElbow + 0.26});
  Sew(canvas, {0.0, kElbow - 0.055}, {kWide, kElbow - 0.055});
  // Retro-reflective tape round the forearm, its glass beads in a honeycomb.
  for (const double y : {kElbow + 0.062, kElbow + 0.098}) {
    FillRectangle(canvas, {0.0, y}, {kWide, y + 0.020}, Rgb(206, 208, 204));
    for (int i = 0; i * 0.004 < kWide; ++i) {
      const double x = 0.004 * i;
      DrawLine(canvas, {x, y}, {x + 0.008, y + 0.020}, 0.0007, Rgb(150, 152, 150));
      DrawLine(canvas, {x + 0.008, y}, {x, y + 0.020}, 0.0007, Rgb(150, 152, 150));
    }
    DrawLine(canvas, {0.0, y}, {kWide, y}, 0.0015, Rgb(24, 24, 26));
    DrawLine(canvas, {0.0, y + 0.020}, {kWide, y + 0.020}, 0.0015, Rgb(24, 24, 26));
  }
  // A pad of rubber dots on the elbow's outside.
  for (int row = 0; row < 12; ++row) {
    for (int i = 0; i < 7; ++i) {
      const cv::Point2d p(0.004 + 0.009 * i + (row % 2) * 0.0045, kElbow - 0.045 + 0.008 * row);
      FillRectangle(canvas, p - cv::Point2d(0.0026, 0.0026), p + cv::Point2d(0.0026, 0.0026),
                    Rgb(96, 98, 98));
    }
  }
}

void PaintGlove(Canvas& canvas, const NoiseKeys& keys) {
  constexpr double kLeft = ArmPicture::kGloveLeft;
  constexpr double kRight = kLeft + ArmPicture::kGloveWidth;
  const cv::Mat1f fine = canvas.Noise(0.008, 0.0015, 0.8, keys.Key("suede"));
  // The palm is of another stuff than the back of the hand.
  cv::Mat1b palm = canvas.Mask();
  const double edge = kLeft + 0.62 * ArmPicture::kGloveWidth;
  cv::rectangle(palm, canvas.Fixed(edge, 0.035) / 16, canvas.Fixed(kRight + 0.01, 0.19) / 16, 255,
                cv::FILLED);
  cv::rectangle(palm,
                canvas.Fixed(kLeft + 0.6 * ArmPicture::kFingerWidth, ArmPicture::kFingers) / 16,
                canvas.Fixed(kLeft + ArmPicture::kFingerWidth + 0.005, 0.38) / 16, 255, cv::FILLED);
  canvas.Blend(palm, fine, Rgb(88, 86, 80), Rgb(136, 132, 122), 0.9);
  Sew(canvas, {edge, 0.035}, {edge, 0.19});
  // The cuff: a bright rim and a strap.
  FillRectangle(canvas, {kLeft, 0.0}, {kRight, 0.007}, Rgb(170, 138, 40));
  FillRectangle(canvas, {kLeft, 0.050}, {kRight, 0.066}, Rgb(20, 20, 22));
  FillRectangle(canvas, {kLeft + 0.010, 0.051}, {kLeft + 0.048, 0.065}, Rgb(70, 72, 76));
  Sew(canvas, {kLeft, 0.030}, {kRight, 0.030});
  // Ribs of rubber on the back of the hand.
  for (int i = 0; i < 6; ++i) {
    const double y = 0.086 + 0.014 * i;
    const std::vector<cv::Point2d> rib = {{kLeft, y},
                                          {kLeft + 0.034, y + 0.010},
                                          {kLeft + 0.052, y},
                                          {kLeft + 0.052, y + 0.005},
                                          {kLeft + 0.034, y + 0.015},
                                          {kLeft, y + 0.005}};
    FillPolygon(canvas, rib, Rgb(92, 96, 98));
  }
  // Fingers: seams across the joints and worn tips.
  for (const double y : {0.022, 0.052, 0.078}) {
    DrawLine(canvas, {kLeft, ArmPicture::kFingers + y},
             {kLeft + ArmPicture::kFingerWidth, ArmPicture::kFingers + y}, 0.0016, kThread);
  }
  FillRectangle(canvas, {kLeft, ArmPicture::kFingers + 0.030},
                {kLeft + 0.4 * ArmPicture::kFingerWidth, ArmPicture::kFingers + 0.046},
                Rgb(92, 96, 98));
  canvas.Modulate(fine, 0.06);
}

void PaintComputer(Canvas& canvas) {
  const UvRect face = ArmPicture::Face();
  const auto at = [&](double s, double t) {
    const Eigen::Vector2d uv = face.At(s, t);
    return cv::Point2d(uv.x() * ArmPicture::kWidth, uv.y() * ArmPicture::kHeight);
  };
  FillRectangle(canvas, at(-0.05, -0.05), at(1.05, 1.05), Rgb(18, 18, 20));
  const auto disc = [&](double radius, const Rgb& color) {
    const cv::Point2d c = at(0.5, 0.5);
    cv::circle(canvas.image(), canvas.Fixed(c.x, c.y), canvas.FixedLength(radius * 0.12),
               {double(color[0]), double(color[1]), double(color[2])}, cv::FILLED, cv::LINE_AA,
               Canvas::kShift);
  };
  disc(0.49, Rgb(34, 34, 38));
  disc(0.43, Rgb(150, 150, 148));
  disc(0.39, Rgb(16, 22, 20));
  FillRectangle(canvas, at(0.24, 0.30), at(0.76, 0.72), Rgb(150, 176, 150));
  const cv::Point2d c = at(0.5, 0.43);
  DrawText(canvas, "18.4", c.x, c.y, 0.018, 0.14, Rgb(20, 28, 22));
  const cv::Point2d below = at(0.5, 0.62);
  DrawText(canvas, "42 MIN", below.x, below.y, 0.010, 0.14, Rgb(20, 28, 22));
}

cv::Mat3b PaintArm(std::uint64_t seed, double scale) {
  const NoiseKeys keys(seed, "creatures/arm");
  Canvas canvas(ArmPicture::kWidth, ArmPicture::kHeight, kPixelsPerMetre * scale, Rgb(34, 36, 40));
  PaintCloth(canvas, keys);
  PaintSleeve(canvas);
  PaintGlove(canvas, keys);
  PaintComputer(canvas);
  return canvas.image();
}

}  // namespace

TextureTask ArmTexture() { return {"arm", PaintArm}; }

}  // namespace drydock::scenes::creatures
