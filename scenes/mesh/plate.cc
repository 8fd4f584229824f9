#include "scenes/mesh/plate.h"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace drydock::scenes {
namespace {
using Eigen::Vector2d;
using Eigen::Vector3d;

/// Outwards from an edge of an outline.
Vector2d EdgeNormal(const Vector2d& from, const Vector2d& to) {
  return Vector2d(to.y() - from.y(), from.x() - to.x()).normalized();
}

/// One band of a rim: between the outlines `a` at y = low and `b` at y = high. `across` is how far
/// round the plate's thickness the band begins and ends, for the texture.
struct Band {
  const Outline& a;
  const Outline& b;
  double low;
  double high;
  double across_low;
  double across_high;
};

void AddBand(Mesh& rim, const Outline& outline, const Band& band, const TileUv& uv) {
  double along = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const std::size_t j = (i + 1) % outline.size();
    const double next = along + (outline[j] - outline[i]).norm();
    const auto at = [](const Vector2d& p, double y) { return Vector3d(p.x(), y, p.y()); };
    const auto place = [&](double across, double length) -> Vector2d {
      return uv.offset + Vector2d(across, length) / uv.period;
    };
    rim.AddQuad({at(band.a[i], band.low), at(band.b[i], band.high), at(band.b[j], band.high),
                 at(band.a[j], band.low)},
                {place(band.across_low, along), place(band.across_high, along),
                 place(band.across_high, next), place(band.across_low, next)});
    along = next;
  }
}

}  // namespace

Outline RoundTopOutline(double half_width, double foot, double shoulder, double rise, int arc) {
  Outline outline = {{-half_width, foot}, {half_width, foot}};
  for (int i = 0; i <= arc; ++i) {
    const double angle = std::numbers::pi * i / arc;
    outline.emplace_back(half_width * std::cos(angle), shoulder + rise * std::sin(angle));
  }
  return outline;
}

Outline Inset(const Outline& outline, double distance) {
  Outline inset;
  inset.reserve(outline.size());
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vector2d before = EdgeNormal(outline[(i + n - 1) % n], outline[i]);
    const Vector2d after = EdgeNormal(outline[i], outline[(i + 1) % n]);
    // The corner stays `distance` away from both edges.
    const Vector2d sum = before + after;
    inset.push_back(outline[i] - sum * (2.0 * distance / sum.squaredNorm()));
  }
  return inset;
}

Outline Clip(const Outline& outline, const Vector2d& point, const Vector2d& normal) {
  Outline kept;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector2d& p = outline[i];
    const Vector2d& q = outline[(i + 1) % outline.size()];
    const double a = (p - point).dot(normal);
    const double b = (q - point).dot(normal);
    if (a <= 0.0) kept.push_back(p);
    if ((a < 0.0 && b > 0.0) || (a > 0.0 && b < 0.0)) kept.push_back(p + (q - p) * (a / (a - b)));
  }
  return kept;
}

Mesh PlateFace(const Outline& outline, const Vector2d& middle, double y,
               const std::function<Vector2d(const Vector2d&)>& uv) {
  const bool front = y < 0.0;
  const double side = front ? -1.0 : 1.0;
  Mesh face;
  const auto add = [&](const Vector2d& p) {
    return face.AddVertex({p.x(), y, p.y()}, side * Vector3d::UnitY(), uv(p));
  };
  const int center = add(middle);
  for (const Vector2d& p : outline) add(p);
  const int count = static_cast<int>(outline.size());
  for (int i = 0; i < count; ++i) {
    const int a = 1 + i;
    const int b = 1 + (i + 1) % count;
    face.AddTriangle(center, front ? a : b, front ? b : a);
  }
  return face;
}

Mesh PlateRim(const Outline& outline, double thickness, const TileUv& uv, double bevel) {
  const double half = 0.5 * thickness;
  Mesh rim;
  if (bevel <= 0.0) {
    AddBand(rim, outline, {outline, outline, -half, half, 0.0, thickness}, uv);
    return rim;
  }
  const Outline inner = Inset(outline, bevel);
  const double cut = std::numbers::sqrt2 * bevel;
  const double flat = thickness - 2.0 * bevel;
  AddBand(rim, outline, {inner, outline, -half, -half + bevel, 0.0, cut}, uv);
  AddBand(rim, outline, {outline, outline, -half + bevel, half - bevel, cut, cut + flat}, uv);
  AddBand(rim, outline, {outline, inner, half - bevel, half, cut + flat, 2.0 * cut + flat}, uv);
  return rim;
}

}  // namespace drydock::scenes
