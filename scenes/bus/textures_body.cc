// The bus from outside.
#include <cmath>
#include <string>

#include "scenes/bus/bus_shape.h"
#include "scenes/bus/panel_painter.h"
#include "scenes/bus/textures.h"
#include "scenes/texture/weathering.h"

namespace drydock::scenes::bus {
namespace {

const Rgb kYellow(206, 153, 42);
const Rgb kWhite(206, 202, 190);
const Rgb kBlack(30, 30, 28);
const Rgb kLetter(22, 22, 22);

/// Soft growth that is denser towards the ground.
void GrowFromBelow(Canvas& canvas, const cv::Mat1b& grade, std::uint64_t key) {
  cv::Mat1f field = canvas.Noise(0.5, 0.006, 0.66, key);
  AddMask(field, grade, 2.6);
  const cv::Mat1f tone = canvas.Noise(0.03, 0.003, 0.8, key + 1);
  canvas.Blend(Ramp(field, 1.7, 2.2), tone, Rgb(34, 40, 24), Rgb(90, 96, 56), 0.75);
  canvas.Blend(Ramp(field, 2.7, 3.4), tone, Rgb(104, 96, 72), Rgb(160, 148, 116), 0.8);
}

void PaintSidePanels(PanelPainter& painter, Side side) {
  const double first = kSideRear;
  const double last = kFront + 0.1;
  painter.Field(first - 0.2, kEave - 0.03, last + 0.1, kEave + 0.2, kWhite);
  painter.Stripe(first - 0.2, kEave - 0.03, last + 0.1, kEave - 0.03, 0.03, kBlack);
  for (const double z : {kRail, -0.12, kSill - 0.05})
    painter.Stripe(first - 0.2, z, last + 0.1, z, 0.13, kBlack);
  for (const double z : {kRail + 0.10, kHead + 0.05, -0.62})
    painter.Seam(first - 0.2, z, last + 0.1, z, 0.07);
  for (int i = 0; i <= kWindows; ++i) {
    const double x = kWindowFirst + i * kWindowPitch - 0.06;
    painter.Seam(x, kSkirt, x, kEave, i % 2 == 0 ? 0.08 : 0.11);
  }
  for (int i = 0; i < kWindows; ++i) {
    const double x = kWindowFirst + i * kWindowPitch;
    painter.Opening(x, kSill, x + kWindowWidth, kHead);
  }
  if (side == Side::kLeft) {
    painter.Opening(kDriverWindow[0], kSill, kDriverWindow[1], kHead);
    painter.Flap(7.2, -1.02, 8.7, -0.66);
    painter.Flap(5.2, -1.0, 5.9, -0.68);
  } else {
    painter.Opening(kEntryDoor[0], kSkirt, kEntryDoor[1], kEntryDoorTop, 0.04);
    painter.Flap(5.7, -1.0, 6.6, -0.68);
    painter.Flap(2.2, -1.02, 3.0, -0.66);
  }
  painter.MarkEdge(first, kSkirt + 0.02, last, kSkirt + 0.02, 0.10);
}

cv::Mat3b PaintSide(Side side, std::uint64_t seed, double scale) {
  const NoiseKeys keys(seed, side == Side::kLeft ? "bus/side_left" : "bus/side_right");
  Canvas canvas(kSideCanvas.width, kSideCanvas.height, 450 * scale, kYellow);
  PanelPainter painter(canvas, [side](double x, double z) {
    const double a = x - kSideCanvas.left;
    return cv::Point2d(side == Side::kLeft ? kSideCanvas.width - a : a, kSideCanvas.top - z);
  });
  PaintSidePanels(painter, side);
  painter.Text("LAKESIDE COUNTY SCHOOLS", side == Side::kLeft ? 6.1 : 5.6, -0.265, 0.165, 0.20,
               kLetter, 1.08);
  painter.Text("47", side == Side::kLeft ? 9.75 : 8.9, -0.83, 0.20, 0.22, kLetter);
  painter.Text(side == Side::kLeft ? "47" : "STOP  WHEN  LIGHTS  FLASH",
               side == Side::kLeft ? 2.3 : 3.0, -0.02, side == Side::kLeft ? 0.13 : 0.08, 0.2,
               kLetter);
  Weathering weathering;
  weathering.rust = side == Side::kLeft ? 0.12 : 0.18;
  weathering.algae = side == Side::kLeft ? 0.08 : 0.14;
  Age(canvas, weathering, painter.edges(), keys);
  GrowFromBelow(canvas, DownwardGrade(canvas, kSideCanvas.top, -0.35, kSkirt - 0.1),
                keys.Key("from below"));
  for (const double z : {kRail + 0.05, -0.08, kSill - 0.01}) {
    painter.Ledge(1.4, z, 10.6, z, 0.05, keys.Key("ledge" + std::to_string(z)));
  }
  return canvas.image();
}

cv::Mat3b PaintRoof(std::uint64_t seed, double scale) {
  const NoiseKeys keys(seed, "bus/roof");
  Canvas canvas(kRoofCanvas.width, kRoofCanvas.height, 300 * scale, kWhite);
  PanelPainter painter(
      canvas, [](double x, double arc) { return cv::Point2d(x - kRoofCanvas.left, 1.45 - arc); });
  for (const double end : {-1.45, 1.32}) painter.Field(1.4, end, 10.6, end + 0.14, kYellow);
  for (int i = 0; i <= 9; ++i) painter.Seam(1.9 + i * 0.93, -1.45, 1.9 + i * 0.93, 1.45, 0.06);
  for (const double arc : {-0.75, 0.75}) painter.Seam(1.4, arc, 10.6, arc, 0.10);
  painter.Text("47", 6.0, 0.05, 0.75, 0.2, kLetter);
  Weathering weathering;
  weathering.rust = 0.15;
  weathering.streaks = 0.12;
  weathering.silt = 0.47;
  weathering.silt_alpha = 0.88;
  weathering.algae = 0.19;
  weathering.mussels = 30;
  Age(canvas, weathering, painter.edges(), keys);
  return canvas.image();
}

PanelPainter::Place EndPlace() {
  return [](double a, double z) { return cv::Point2d(a - kEndCanvas.left, kEndCanvas.top - z); };
}

cv::Mat3b PaintRear(std::uint64_t seed, double scale) {
  const NoiseKeys keys(seed, "bus/rear");
  Canvas canvas(kEndCanvas.width, kEndCanvas.height, 480 * scale, kYellow);
  PanelPainter painter(canvas, EndPlace());
  for (const double z : {-0.06, kRail}) painter.Stripe(-1.3, z, 1.3, z, 0.09, kBlack);
  for (const double a : {-1.06, 1.06, -0.6, 0.6}) painter.Seam(a, kSkirt, a, 1.2, 0.08);
  painter.Seam(-1.3, 0.78, 1.3, 0.78, 0.07);
  painter.Seam(-1.3, -0.62, 1.3, -0.62, 0.07);
  painter.Opening(-0.98, kSill, -0.66, 0.72);
  painter.Opening(0.66, kSill, 0.98, 0.72);
  painter.Opening(-kBackDoorHalfWidth, kFloor, kBackDoorHalfWidth, kBackDoorTop, 0.03);
  painter.Text("47", 0.82, 0.06, 0.13, 0.2, kLetter);
  painter.Text("STOP", -0.82, 0.075, 0.09, 0.2, kLetter);
  painter.Text("LAKESIDE", -0.82, -0.53, 0.07, 0.2, kLetter);
  Weathering weathering;
  weathering.rust = 0.19;
  Age(canvas, weathering, painter.edges(), keys);
  GrowFromBelow(canvas, DownwardGrade(canvas, kEndCanvas.top, -0.3, kSkirt - 0.1),
                keys.Key("from below"));
  return canvas.image();
}

cv::Mat3b PaintFront(std::uint64_t seed, double scale) {
  const NoiseKeys keys(seed, "bus/front");
  Canvas canvas(kEndCanvas.width, kEndCanvas.height, 320 * scale, kYellow);
  PanelPainter painter(canvas, EndPlace());
  painter.Opening(-kScreenHalfWidth, kScreenFoot, kScreenHalfWidth, kScreenTop, 0.035);
  for (const double a : {-1.08, 1.08}) painter.Seam(a, kSkirt, a, 1.2, 0.08);
  painter.Seam(-1.3, 0.12, 1.3, 0.12, 0.07);
  Weathering weathering;
  weathering.rust = 0.21;
  Age(canvas, weathering, painter.edges(), keys);
  return canvas.image();
}

cv::Mat3b PaintHood(std::uint64_t seed, double scale) {
  const NoiseKeys keys(seed, "bus/hood");
  Canvas canvas(kHoodCanvas.width, kHoodCanvas.height, 400 * scale, kYellow);
  PanelPainter painter(canvas, [](double a, double b) { return cv::Point2d(a, b); });
  painter.Seam(1.65, 0.0, 1.65, 1.58, 0.0);                                 // the hood's ridge
  for (const double a : {0.62, 2.68}) painter.Seam(a, 0.0, a, 1.58, 0.12);  // where it opens
  painter.Seam(0.0, 0.03, 3.3, 0.03, 0.06);
  for (int i = 0; i < 6; ++i) {  // louvres on both flanks
    for (const double a : {0.22, 2.86})
      painter.Stripe(a, 0.5 + 0.07 * i, a + 0.22, 0.5 + 0.07 * i, 0.018, kBlack);
  }
  painter.Field(1.15, 0.25, 2.15, 1.30, Rgb(44, 42, 38));  // matt black against glare
  for (const double a : {0.02, 1.67}) {
    painter.Seam(a, 2.25, a + 1.6, 2.25, 0.1);
    painter.MarkEdge(a, 3.0, a + 1.6, 3.0, 0.08);
    painter.Stripe(a, 2.95, a + 1.6, 2.95, 0.05, kBlack);
  }
  Weathering weathering;
  weathering.rust = 0.22;
  weathering.streaks = 0.12;
  weathering.silt = 0.38;
  weathering.silt_alpha = 0.8;
  weathering.mussels = 26;
  Age(canvas, weathering, painter.edges(), keys);
  return canvas.image();
}

cv::Mat3b PaintDoor(std::uint64_t seed, double scale) {
  const NoiseKeys keys(seed, "bus/door");
  Canvas canvas(kDoorCanvas.width, kDoorCanvas.height, 500 * scale, kYellow);
  PanelPainter painter(canvas, [](double a, double z) { return cv::Point2d(a, 1.2 - z); });
  painter.Field(1.2, -0.65, 2.4, 1.2, Rgb(150, 156, 132));
  for (const double a : {0.6, 1.8}) {
    painter.Opening(a - 0.42, -0.30, a + 0.42, 0.10);
    painter.Opening(a - 0.42, 0.32, a + 0.42, 0.95);
    for (const double z : {-0.4, 0.2, 1.05}) painter.Rivets(a - 0.54, z, a + 0.54, z, 0.09);
    painter.MarkEdge(a - 0.56, -0.57, a + 0.56, -0.57, 0.1);
  }
  painter.Text("EMERGENCY DOOR", 0.6, 1.04, 0.085, 0.2, kLetter, 0.95);
  painter.Text("EMERGENCY DOOR", 1.8, 1.04, 0.075, 0.2, Rgb(150, 30, 24), 0.95);
  painter.Text("LIFT TO OPEN", 1.8, 0.21, 0.05, 0.18, Rgb(150, 30, 24));
  painter.Stripe(0.05, 0.21, 1.15, 0.21, 0.06, kBlack);
  Weathering weathering;
  weathering.rust = 0.17;
  Age(canvas, weathering, painter.edges(), keys);
  GrowFromBelow(canvas, DownwardGrade(canvas, 1.2, 0.0, -0.8), keys.Key("from below"));
  return canvas.image();
}

}  // namespace

std::vector<TextureTask> BodyTextures() {
  const auto side = [](Side which) {
    return [which](std::uint64_t seed, double scale) { return PaintSide(which, seed, scale); };
  };
  return {{"side_left", side(Side::kLeft)},
          {"side_right", side(Side::kRight)},
          {"roof", PaintRoof},
          {"rear", PaintRear},
          {"front", PaintFront},
          {"hood", PaintHood},
          {"door", PaintDoor}};
}

}  // namespace drydock::scenes::bus
