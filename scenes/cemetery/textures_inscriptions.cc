// The atlas of inscriptions: each cell a stone's face with an ornament and lines of cut letters.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "scenes/cemetery/textures.h"
#include "scenes/texture/stamps.h"

namespace drydock::scenes::cemetery {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

/// Cuts lines into one cell: dark, with a bright lower edge where light falls into the cut.
class Chisel {
 public:
  Chisel(Canvas& canvas, const cv::Point2d& corner, bool pale)
      : canvas_(canvas),
        corner_(corner),
        dark_(pale ? Rgb(40, 37, 31) : Rgb(22, 22, 21)),
        bright_(pale ? Rgb(206, 200, 180) : Rgb(148, 150, 144)) {}

  void Line(const cv::Point2d& from, const cv::Point2d& to, double width) const {
    DrawLine(canvas_, corner_ + from + kEdge, corner_ + to + kEdge, width, bright_);
    DrawLine(canvas_, corner_ + from, corner_ + to, width, dark_);
  }

  void Polyline(const std::vector<cv::Point2d>& points, double width) const {
    for (std::size_t i = 0; i + 1 < points.size(); ++i) Line(points[i], points[i + 1], width);
  }

  /// Centred on the cell, as high as its width allows.
  void Text(const std::string& text, double y, double height) const {
    if (text.empty()) return;
    const double room = 0.84 * kCellWidth;
    const double squeeze = 0.85;
    const double fits = room / (0.92 * squeeze * static_cast<double>(text.size()));
    const double h = std::min(height, fits);
    const double x = corner_.x + 0.5 * kCellWidth;
    const double at = corner_.y + y;
    DrawText(canvas_, text, x + kEdge.x, at + kEdge.y, h, 0.17, bright_, squeeze);
    DrawText(canvas_, text, x, at, h, 0.17, dark_, squeeze);
  }

 private:
  static inline const cv::Point2d kEdge{0.003, 0.004};

  Canvas& canvas_;
  cv::Point2d corner_;
  Rgb dark_;
  Rgb bright_;
};

std::vector<cv::Point2d> Circle(const cv::Point2d& middle, double radius, double from = 0.0,
                                double to = kTurn) {
  std::vector<cv::Point2d> points;
  for (int i = 0; i <= 24; ++i) {
    const double angle = from + (to - from) * i / 24.0;
    points.emplace_back(middle.x + radius * std::cos(angle), middle.y + radius * std::sin(angle));
  }
  return points;
}

void CutStar(const Chisel& chisel, const cv::Point2d& m, double r) {
  std::vector<cv::Point2d> points;
  for (int i = 0; i <= 10; ++i) {
    const double angle = kTurn * i / 10.0 - 0.25 * kTurn;
    const double radius = i % 2 == 0 ? r : 0.42 * r;
    points.emplace_back(m.x + radius * std::cos(angle), m.y + radius * std::sin(angle));
  }
  chisel.Polyline(points, 0.010);
}

void CutWreath(const Chisel& chisel, const cv::Point2d& m, double r) {
  chisel.Polyline(Circle(m, 0.8 * r), 0.008);
  for (int i = 0; i < 18; ++i) {
    const double angle = kTurn * i / 18.0;
    const cv::Point2d at(m.x + 0.8 * r * std::cos(angle), m.y + 0.8 * r * std::sin(angle));
    for (const double turn : {0.9, 2.2}) {
      const cv::Point2d leaf(std::cos(angle + turn), std::sin(angle + turn));
      chisel.Line(at, at + 0.25 * r * leaf, 0.010);
    }
  }
}

void CutAnchor(const Chisel& chisel, const cv::Point2d& m, double r) {
  chisel.Polyline(Circle({m.x, m.y - 0.85 * r}, 0.15 * r), 0.010);
  chisel.Line({m.x, m.y - 0.7 * r}, {m.x, m.y + r}, 0.014);
  chisel.Line({m.x - 0.4 * r, m.y - 0.45 * r}, {m.x + 0.4 * r, m.y - 0.45 * r}, 0.012);
  chisel.Polyline(Circle({m.x, m.y + 0.2 * r}, 0.8 * r, 0.0, 0.5 * kTurn), 0.013);
}

void CutRays(const Chisel& chisel, const cv::Point2d& m, double r) {
  const cv::Point2d sun(m.x, m.y + 0.8 * r);
  chisel.Polyline(Circle(sun, 0.5 * r, 0.5 * kTurn, kTurn), 0.010);
  for (int i = 1; i < 10; ++i) {
    const double angle = 0.5 * kTurn * (1.0 + i / 10.0);
    const cv::Point2d out(std::cos(angle), std::sin(angle));
    chisel.Line(sun + 0.65 * r * out, sun + (i % 2 == 0 ? 1.3 : 1.7) * r * out, 0.009);
  }
}

void CutLeaf(const Chisel& chisel, const cv::Point2d& m, double r) {
  chisel.Line({m.x, m.y - r}, {m.x, m.y + r}, 0.010);
  for (int i = 0; i < 5; ++i) {
    const double y = m.y + r * (0.8 - 0.38 * i);
    const double reach = r * (0.75 - 0.1 * i);
    for (const double side : {-1.0, 1.0}) {
      chisel.Polyline(
          {{m.x, y}, {m.x + 0.5 * side * reach, y - 0.1 * r}, {m.x + side * reach, y - 0.38 * r}},
          0.011);
    }
  }
}

void CutOrnament(const Chisel& chisel, Ornament ornament) {
  const cv::Point2d m(0.5 * kCellWidth, 0.56 * kOrnamentShare * kCellHeight);
  const double r = 0.082;
  switch (ornament) {
    case Ornament::kNone:
      chisel.Line({0.2, m.y}, {kCellWidth - 0.2, m.y}, 0.010);
      break;
    case Ornament::kCross:
      chisel.Line({m.x, m.y - r}, {m.x, m.y + r}, 0.018);
      chisel.Line({m.x - 0.6 * r, m.y - 0.35 * r}, {m.x + 0.6 * r, m.y - 0.35 * r}, 0.018);
      break;
    case Ornament::kStar:
      CutStar(chisel, m, r);
      break;
    case Ornament::kWreath:
      CutWreath(chisel, m, r);
      break;
    case Ornament::kAnchor:
      CutAnchor(chisel, m, 0.9 * r);
      break;
    case Ornament::kRays:
      CutRays(chisel, m, 0.7 * r);
      break;
    case Ornament::kLeaf:
      CutLeaf(chisel, m, r);
      break;
  }
}

void CutFrame(const Chisel& chisel) {
  const double low = 0.035;
  const double right = kCellWidth - low;
  const double bottom = kCellHeight - low;
  const double top = 0.92 * kOrnamentShare * kCellHeight;
  chisel.Polyline({{low, top}, {low, bottom}, {right, bottom}, {right, top}}, 0.007);
}

void CutInscription(const Chisel& chisel, const Inscription& inscription, bool framed) {
  CutOrnament(chisel, inscription.ornament);
  if (framed) CutFrame(chisel);
  const double y = kOrnamentShare * kCellHeight;
  chisel.Text(inscription.first_name, y + 0.060, 0.075);
  chisel.Text(inscription.surname, y + 0.165, 0.085);
  chisel.Text(inscription.dates, y + 0.268, 0.058);
  chisel.Text(inscription.epitaph, y + 0.362, 0.046);
}

/// Some stones are brighter, some darker; the growth comes from below.
void Tint(Canvas& canvas, const cv::Rect& cell, double tone) {
  for (int y = cell.y; y < cell.y + cell.height; ++y) {
    const double down = static_cast<double>(y - cell.y) / cell.height;
    const double shade = tone * (1.0 - 0.28 * down * down);
    Rgb* row = canvas.image()[y];
    for (int x = cell.x; x < cell.x + cell.width; ++x) {
      for (int c = 0; c < 3; ++c) {
        row[x][c] = static_cast<std::uint8_t>(std::clamp(shade * row[x][c], 0.0, 255.0));
      }
    }
  }
}

cv::Rect CellPixels(const Canvas& canvas, int inscription) {
  const int column = inscription % kAtlasColumns;
  const int row = inscription / kAtlasColumns;
  const int width = canvas.size().width;
  const int height = canvas.size().height;
  const cv::Point low(width * column / kAtlasColumns, height * row / kAtlasRows);
  return {low, cv::Point(width * (column + 1) / kAtlasColumns, height * (row + 1) / kAtlasRows)};
}

/// The bare stone of the atlas: the upper rows pale, the lower ones dark.
void PaintBackground(Canvas& canvas, const NoiseKeys& keys, double pixels_per_metre) {
  const double height = canvas.height() * (kAtlasRows - kPaleRows) / kAtlasRows;
  Canvas dark(canvas.width(), height, pixels_per_metre, Rgb(90, 90, 88));
  PaintStone(canvas, keys);
  PaintStone(dark, keys, SlateColors());
  const cv::Size size(std::min(dark.size().width, canvas.size().width),
                      std::min(dark.size().height, canvas.size().height));
  const cv::Rect below({0, canvas.size().height - size.height}, size);
  dark.image()(cv::Rect({0, 0}, size)).copyTo(canvas.image()(below));
}

}  // namespace

cv::Mat3b PaintInscriptions(const std::vector<Inscription>& inscriptions, std::uint64_t seed,
                            double scale) {
  const NoiseKeys keys(seed, "cemetery/inscriptions");
  const double pixels_per_metre = 450 * scale;
  Canvas canvas(kAtlasColumns * kCellWidth, kAtlasRows * kCellHeight, pixels_per_metre,
                Rgb(140, 134, 118));
  PaintBackground(canvas, keys, pixels_per_metre);
  RandomStream random(keys.Key("stones"), "stones");
  for (int i = 0; i < kInscriptions; ++i) {
    const int row = i / kAtlasColumns;
    const cv::Point2d corner(kCellWidth * (i % kAtlasColumns), kCellHeight * row);
    Tint(canvas, CellPixels(canvas, i), random.Uniform(0.82, 1.15));
    CutInscription(Chisel(canvas, corner, IsPale(i)), inscriptions[i], random.Uniform() < 0.5);
  }
  OvergrowStone(canvas, keys);
  return canvas.image();
}

}  // namespace drydock::scenes::cemetery
