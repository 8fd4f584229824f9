// The bus' nose: hood, fenders, grille, headlights, bumper.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "scenes/bus/bus_shape.h"
#include "scenes/bus/details_atlas.h"
#include "scenes/bus/parts.h"
#include "scenes/mesh/shapes.h"

namespace drydock::scenes::bus {
namespace {
using Eigen::Vector2d;
using Eigen::Vector3d;
constexpr double kPi = std::numbers::pi;

constexpr double kHoodRear = 10.47;
constexpr double kHoodFront = 12.0;
constexpr double kHoodFoot = -0.55;
constexpr int kHoodRows = 20;     // across, from the right foot to the left one
constexpr int kHoodSideRows = 3;  // of these, on each upright side

/// A point of the hood's section at s (0 at the windscreen, 1 at the grille).
Vector3d HoodPoint(double s, int row) {
  const double half_width = 0.82 - 0.17 * std::pow(s, 1.5);
  const double top = 0.27 - 0.09 * s - 0.11 * std::pow(s, 7.0);
  const double shoulder = -0.12;
  const double x = kHoodRear + (kHoodFront - kHoodRear) * s;
  const int arc_rows = kHoodRows - 2 * kHoodSideRows;
  if (row < kHoodSideRows || row > kHoodRows - kHoodSideRows) {
    const int up = std::min(row, kHoodRows - row);
    const double y = row < kHoodSideRows ? -half_width : half_width;
    return {x, y, kHoodFoot + (shoulder - kHoodFoot) * up / kHoodSideRows};
  }
  const double angle = kPi * (row - kHoodSideRows) / arc_rows;
  const double c = -std::cos(angle);
  const double y = half_width * std::copysign(std::pow(std::abs(c), 0.55), c);
  return {x, y, shoulder + (top - shoulder) * std::pow(std::abs(std::sin(angle)), 0.55)};
}

void AddHood(SceneModel& model) {
  const double length = kHoodFront - kHoodRear;
  std::vector<Vector3d> section;
  for (int row = 0; row <= kHoodRows; ++row) section.push_back(HoodPoint(0.4, row));
  const std::vector<double> arc = ArcFractions(section);
  model.Add("bus_hood", "hood", GridSheet(12, kHoodRows, [&](double s, double t) -> SurfacePoint {
              const int row = static_cast<int>(std::lround(t * kHoodRows));
              return {HoodPoint(s, row),
                      {(0.1 + 3.1 * arc[row]) / kHoodCanvas.width,
                       (0.03 + s * length) / kHoodCanvas.height}};
            }));
  // The grille closes the front, a strip between the two flanks at each height.
  Mesh grille;
  const auto uv = [](const Vector3d& p) {
    return GrilleCell().At(0.5 + p.y() / 1.4, (0.2 - p.z()) / 0.8);
  };
  for (int row = 0; row < kHoodRows / 2; ++row) {
    const Vector3d a = HoodPoint(1.0, row);
    const Vector3d b = HoodPoint(1.0, kHoodRows - row);
    const Vector3d c = HoodPoint(1.0, kHoodRows - row - 1);
    const Vector3d d = HoodPoint(1.0, row + 1);
    grille.AddQuad({a, b, c, d}, {uv(a), uv(b), uv(c), uv(d)});
  }
  model.Add("bus_grille", "details", std::move(grille));
  // Bars in front of the grille, and an emblem.
  Mesh bars;
  for (int i = 0; i < 5; ++i) {
    bars.Append(Box({12.01, 0, -0.44 + 0.1 * i}, {0.05, 1.06, 0.028}, {1.0, {0.2 * i, 0.37 * i}}));
  }
  for (const double y : {-0.55, 0.0, 0.55}) {
    bars.Append(Box({12.015, y, -0.24}, {0.06, 0.03, 0.46}, {1.0, {0.7, y}}));
  }
  model.Add("bus_grille_bars", "bare_rust", std::move(bars));
}

double FenderTop(double x) {
  const double down = std::clamp((x - 11.68) / 0.40, 0.0, 1.0);
  return -0.20 - 0.02 * std::cos(2 * (x - kFrontAxle)) -
         0.55 * (1.0 - std::sqrt(1.0 - down * down));
}

double FenderFoot(double x) {
  const double d = x - kFrontAxle;
  const double under = 0.60 * 0.60 - d * d;
  const double arch = under <= 0 ? -1.0 : std::max(-1.0, kAxleHeight + std::sqrt(under));
  return std::min(arch, FenderTop(x) - 0.2);
}

Mesh LeftFender() {
  // Across: from under the hood, out, round the edge, down to the arch.
  const std::vector<double> across = {0.50, 0.80, 1.02, 1.13, 1.18, 1.20, 1.20, 1.20};
  const std::vector<double> drop = {0.0, 0.0, 0.01, 0.05, 0.12, 0.2, -1.0, -2.0};
  const int rows = static_cast<int>(across.size()) - 1;
  const double rear = 10.50;
  const double length = 12.08 - rear;
  constexpr int kColumns = 17;
  std::vector<Vector3d> section;
  for (std::size_t i = 0; i < across.size(); ++i) {
    section.emplace_back(0.0, across[i], drop[i] >= 0 ? -drop[i] : 0.35 * drop[i] - 0.2);
  }
  // Columns denser at the front, where the fender bends down.
  const auto column_x = [&](double s) {
    return rear + length * std::sin(0.5 * kPi * (0.35 * s * s + 0.65 * s));
  };
  std::vector<Vector3d> crest;
  for (int i = 0; i <= kColumns; ++i) {
    const double x = column_x(static_cast<double>(i) / kColumns);
    crest.emplace_back(x, 0.0, FenderTop(x));
  }
  const std::vector<double> out = ArcFractions(section);
  const std::vector<double> ahead = ArcFractions(crest);
  return GridSheet(kColumns, rows, [&](double s, double t) -> SurfacePoint {
    const auto row = static_cast<std::size_t>(std::lround(t * rows));
    const auto column = static_cast<std::size_t>(std::lround(s * kColumns));
    const double x = column_x(s);
    double z = FenderTop(x) - std::max(0.0, drop[row]);
    if (drop[row] < 0) z += (FenderFoot(x) - (FenderTop(x) - 0.2)) * -0.5 * drop[row] - 0.2;
    return {{x, across[row], z},
            {(0.02 + 1.6 * ahead[column]) / kHoodCanvas.width,
             (1.65 + 1.35 * out[row]) / kHoodCanvas.height}};
  });
}

void AddFenders(SceneModel& model) {
  for (const bool left : {true, false}) {
    Mesh fender = LeftFender();
    if (!left) {
      for (Vector2d& uv : fender.uvs) uv.x() += 1.65 / kHoodCanvas.width;
      fender.MirrorY();
    }
    fender.AddBackFaces();
    model.Add(left ? "bus_fender_left" : "bus_fender_right", "hood", std::move(fender));
  }
}

/// Moves what was turned about z so that z points along `axis` from `position`.
void Place(Mesh& mesh, const Vector3d& position, const Vector3d& axis) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), axis).toRotationMatrix();
  pose.translation() = position;
  mesh.Transform(pose);
}

void AddHeadlights(SceneModel& model) {
  Mesh bezels;
  Mesh lenses;
  for (const double y : {-0.88, 0.88}) {
    Mesh bezel =
        Lathe({{0.155, -0.2}, {0.155, 0.0}, {0.14, 0.025}, {0.115, 0.02}, {0.11, -0.02}}, 15, 2);
    Place(bezel, {12.03, y, -0.46}, Vector3d::UnitX());
    bezels.Append(bezel);
    Mesh lens = Disc(0.115, 15, HeadlightCell());
    Place(lens, {12.02, y, -0.46}, Vector3d::UnitX());
    lenses.Append(lens);
    Mesh signal = Lathe({{0.07, -0.1}, {0.07, 0.0}, {0.05, 0.03}, {0.0, 0.035}}, 14, 1);
    Place(signal, {11.62, y, -0.17}, Vector3d::UnitZ());
    bezels.Append(signal);
  }
  model.Add("bus_headlight_bezels", "bare_rust", std::move(bezels));
  model.Add("bus_headlights", "details", std::move(lenses));
}

}  // namespace

void AddNose(SceneModel& model) {
  AddHood(model);
  AddFenders(model);
  AddHeadlights(model);
  Mesh front;
  front.Append(Box({12.13, 0, -0.84}, {0.09, 2.36, 0.26}, {1.0, {0.3, 0.1}}, 0.03, 1));
  for (const double y : {-0.45, 0.45}) {
    front.Append(Box({12.0, y, -0.84}, {0.3, 0.08, 0.14}, {1.0, {0.1, 0.6}}));
  }
  model.Add("bus_front_bumper", "black_paint", std::move(front));
  // What is behind the grille and the fenders: radiator and engine as one dark block.
  Mesh engine;
  engine.Append(Box({11.9, 0, -0.72}, {0.12, 2.0, 0.5}, {1.0, {0.2, 0.2}}));
  engine.Append(Box({11.1, 0, -0.62}, {1.2, 0.95, 0.5}, {1.0, {0.5, 0.3}}, 0.1, 0));
  model.Add("bus_engine", "bare_rust", std::move(engine));
}

}  // namespace drydock::scenes::bus
