#include "scenarios/report/canvas.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "sensors_models/base/check.h"
#include "sensors_models/base/files.h"

namespace drydock::report {
namespace {

constexpr double kSupersampling = 2.0;
constexpr int kShift = 4;  ///< OpenCV draws at 1/16 px.
constexpr int kFont = cv::FONT_HERSHEY_DUPLEX;
constexpr double kCapitalHeight = 21.0;  ///< Of the font at scale 1 [px].

cv::Point Fixed(cv::Point2d p) {
  const double scale = kSupersampling * (1 << kShift);
  // OpenCV's pixel (0, 0) has its centre at 0, ours at 0.5.
  const double half = 0.5 * (1 << kShift);
  return {static_cast<int>(std::lround(p.x * scale - half)),
          static_cast<int>(std::lround(p.y * scale - half))};
}

int Thickness(double thickness) {
  return std::max(1, static_cast<int>(std::lround(thickness * kSupersampling)));
}

cv::Rect Pixels(const cv::Rect2d& box) {
  const auto left = static_cast<int>(std::lround(box.x * kSupersampling));
  const auto top = static_cast<int>(std::lround(box.y * kSupersampling));
  const auto right = static_cast<int>(std::lround((box.x + box.width) * kSupersampling));
  const auto bottom = static_cast<int>(std::lround((box.y + box.height) * kSupersampling));
  return {left, top, right - left, bottom - top};
}

/// The font has ASCII only; each letter of several bytes becomes one '?'.
std::string Printable(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80 && byte < 0xc0) continue;
    out += byte >= 0x20 && byte < 0x7f ? c : '?';
  }
  return out;
}

double FontScale(double size) { return size / kCapitalHeight; }

}  // namespace

Color PaletteColor(std::size_t i) {
  // After Okabe and Ito, darkened where lines on white would be faint.
  static const std::array<Color, 7> kPalette = {
      Color{178, 114, 0}, Color{0, 94, 213},   Color{115, 158, 0}, Color{150, 70, 175},
      Color{0, 140, 200}, Color{200, 150, 40}, Color{60, 90, 120}};
  return kPalette[i % kPalette.size()];
}

Canvas::Canvas(int width, int height, const Color& background)
    : width_(width),
      height_(height),
      image_(static_cast<int>(height * kSupersampling), static_cast<int>(width * kSupersampling),
             CV_8UC3, background) {}

void Canvas::Line(cv::Point2d a, cv::Point2d b, const Color& color, double thickness) {
  cv::line(image_, Fixed(a), Fixed(b), color, Thickness(thickness), cv::LINE_AA, kShift);
}

void Canvas::Polyline(const std::vector<cv::Point2d>& points, const Color& color,
                      double thickness) {
  std::vector<cv::Point> fixed;
  for (const cv::Point2d& point : points) {
    const cv::Point next = Fixed(point);
    if (fixed.empty() || next != fixed.back()) fixed.push_back(next);
  }
  if (fixed.size() < 2) return;
  cv::polylines(image_, fixed, false, color, Thickness(thickness), cv::LINE_AA, kShift);
}

void Canvas::Rectangle(const cv::Rect2d& box, const Color& color, double thickness) {
  cv::rectangle(image_, Pixels(box), color, Thickness(thickness), cv::LINE_8);
}

void Canvas::FillRectangle(const cv::Rect2d& box, const Color& color) {
  cv::rectangle(image_, Pixels(box), color, cv::FILLED, cv::LINE_8);
}

void Canvas::FillCircle(cv::Point2d centre, double radius, const Color& color) {
  const auto fixed_radius = static_cast<int>(std::lround(radius * kSupersampling * (1 << kShift)));
  cv::circle(image_, Fixed(centre), fixed_radius, color, cv::FILLED, cv::LINE_AA, kShift);
}

void Canvas::Text(const std::string& text, cv::Point2d at, double size, const Color& color,
                  TextAnchor anchor) {
  const double width = TextWidth(text, size);
  if (anchor == TextAnchor::kCentre) at.x -= 0.5 * width;
  if (anchor == TextAnchor::kRight) at.x -= width;
  const cv::Point corner(static_cast<int>(std::lround(at.x * kSupersampling)),
                         static_cast<int>(std::lround(at.y * kSupersampling)));
  cv::putText(image_, Printable(text), corner, kFont, FontScale(size) * kSupersampling, color,
              Thickness(size / 16.0), cv::LINE_AA);
}

void Canvas::Picture(const cv::Mat& image, const cv::Rect2d& box) {
  Check(image.type() == CV_8UC1 || image.type() == CV_8UC3,
        "a picture of OpenCV type {}, must be 8-bit grey or BGR", image.type());
  const cv::Rect pixels = Pixels(box) & cv::Rect(0, 0, image_.cols, image_.rows);
  if (pixels.empty()) return;
  cv::Mat scaled;
  const bool shrinks = pixels.width < image.cols;
  cv::resize(image, scaled, pixels.size(), 0, 0, shrinks ? cv::INTER_AREA : cv::INTER_LINEAR);
  if (scaled.channels() == 1) cv::cvtColor(scaled, scaled, cv::COLOR_GRAY2BGR);
  scaled.copyTo(image_(pixels));
}

double Canvas::TextWidth(const std::string& text, double size) {
  int baseline = 0;
  const double scale = FontScale(size) * kSupersampling;
  const cv::Size box =
      cv::getTextSize(Printable(text), kFont, scale, Thickness(size / 16.0), &baseline);
  return box.width / kSupersampling;
}

cv::Mat Canvas::Finish() const {
  cv::Mat out;
  cv::resize(image_, out, cv::Size(width_, height_), 0, 0, cv::INTER_AREA);
  return out;
}

std::string EncodePng(const cv::Mat& image) {
  std::vector<unsigned char> bytes;
  Check(cv::imencode(".png", image, bytes), "a picture cannot be encoded");
  return {bytes.begin(), bytes.end()};
}

void WritePng(const std::filesystem::path& path, const cv::Mat& image) {
  WriteFileAtomically(path, EncodePng(image));
}

}  // namespace drydock::report
