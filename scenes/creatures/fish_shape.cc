#include "scenes/creatures/fish_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace drydock::scenes::creatures {
namespace {
using Eigen::Vector2d;
using Eigen::Vector3d;

// The body in three parts and the tail fin; where each begins.
constexpr std::array<double, 4> kBegins = {0.0, 0.50, 0.68, 0.83};
constexpr double kBodyEnd = 0.865;
constexpr int kAround = 14;
constexpr double kRingStep = 0.04;
/// How far a part reaches into the one ahead, so that no gap opens where they bend.
constexpr double kOverlap = 0.04;

double Place(double s) { return kOrigin - s; }

/// The stretch of the body from `begin` to `end`, with what hides in the part ahead.
Mesh BodyPart(const FishShape& shape, double begin, double end) {
  struct Ring {
    double s;
    double scale;
  };
  std::vector<Ring> rings;
  if (begin == 0.0) {
    for (const double s : {0.0, 0.006, 0.018, 0.036, 0.06}) rings.push_back({s, 1.0});
  } else {
    rings = {{begin - kOverlap, 0.82}, {begin - 0.4 * kOverlap, 0.96}, {begin, 1.0}};
  }
  const double first = rings.back().s;
  const int steps = std::max(1, static_cast<int>(std::lround((end - first) / kRingStep)));
  for (int i = 1; i <= steps; ++i) rings.push_back({first + (end - first) * i / steps, 1.0});

  return Loft(static_cast<int>(rings.size()), kAround, [&](int i, double angle) -> SurfacePoint {
    const auto [s, scale] = rings[static_cast<std::size_t>(i)];
    const double up = std::cos(angle);
    const double side = std::sin(angle);
    // Flatter than an ellipse: fish have a keel.
    const double y = shape.width.At(s) * std::copysign(std::pow(std::abs(side), 1.25), side);
    const double z = up * (up > 0 ? shape.back : shape.belly).At(s);
    const double unrolled =
        (std::numbers::pi - std::abs(std::numbers::pi - angle)) / std::numbers::pi;
    return {{Place(s), scale * y, scale * z},
            {s / FishPicture::kWidth, unrolled * FishPicture::kSkin / FishPicture::kHeight}};
  });
}

/// What belongs to the part from `begin` to `end` of a fin along the middle, on the back (up = 1)
/// or under the belly (-1). Its picture is as long as the fin could be.
Mesh MiddleFin(const FishShape& shape, double up, double begin, double end) {
  const Profile& height = up > 0 ? shape.dorsal : shape.anal;
  const Profile& root = up > 0 ? shape.back : shape.belly;
  const UvRect picture = up > 0 ? FishPicture::Dorsal() : FishPicture::Anal();
  const double from = up > 0 ? 0.24 : 0.55;
  const double to = 0.86;
  begin = std::max(begin, from);
  end = std::min(end, to);
  if (end - begin < 0.02) return {};
  const int columns = std::max(2, static_cast<int>(std::lround((end - begin) / 0.02)));
  return Fin(columns, 1, [&](double along, double out) -> SurfacePoint {
    const double s = begin + along * (end - begin);
    const double sunk = 0.12 * root.At(s);
    const double h = std::max(0.0, height.At(s));
    // Spines lean back.
    const double x = Place(s + 0.55 * out * h);
    return {{x, 0.0, up * (root.At(s) - sunk + out * (sunk + h))},
            picture.At((s - from) / (to - from), std::min(1.0, out * (sunk + h) / 0.13))};
  });
}

Mesh TailFin(const FishShape& shape) {
  constexpr double kRoot = 0.80;
  const double half = 0.9 * shape.back.At(kBodyEnd);
  return Fin(4, 10, [&](double out, double across) -> SurfacePoint {
    const double a = 2.0 * across - 1.0;
    const double edge = 1.0 - shape.tail_fork * (1.0 - std::pow(std::abs(a), 1.3)) -
                        0.02 * std::pow(std::abs(a), 6.0);
    const double root = kRoot + 0.02;
    const double s = root + out * (edge - root);
    // The outer rays leave at once and then run straight back.
    const double spread = std::pow(out, 0.8);
    const double z = a * (half + spread * (shape.tail_span - half));
    return {{Place(s), 0.0, z}, FishPicture::Tail().At(across, out)};
  });
}

/// One of a pair of fins at the root (s, y, z), `length` long, pointing back, out and down.
Mesh PairedFin(const Vector3d& root, const Vector3d& back, const Vector3d& across, double length,
               double width) {
  const UvRect picture = FishPicture::Paired();
  return Fin(3, 4, [&](double out, double wide) -> SurfacePoint {
    const double a = 2.0 * wide - 1.0;
    const double half = width * (0.25 + 0.75 * std::sqrt(out));
    const double reach = length * out * (1.0 - 0.22 * a * a);
    return {root + reach * back + a * half * across, picture.At(wide, out)};
  });
}

Mesh PairedFins(const FishShape& shape) {
  Mesh fins;
  const double chest = 0.265;
  const double y = 0.86 * shape.width.At(chest);
  fins.Append(PairedFin({Place(chest), y, -0.30 * shape.belly.At(chest)},
                        Vector3d(-0.82, 0.42, -0.38).normalized(),
                        Vector3d(-0.35, 0.1, 0.93).normalized(), 0.15, 0.035));
  const double hip = 0.34;
  fins.Append(PairedFin({Place(hip), 0.35 * shape.width.At(hip), -0.93 * shape.belly.At(hip)},
                        Vector3d(-0.80, 0.16, -0.58).normalized(),
                        Vector3d(0.58, 0.25, -0.78).normalized(), 0.12, 0.026));
  Mesh right = fins;
  right.MirrorY();
  fins.Append(right);
  return fins;
}

}  // namespace

std::vector<FishShape> FishShapes() {
  using Points = std::vector<Vector2d>;
  std::vector<FishShape> shapes;
  shapes.push_back(
      {"bream",
       Profile(Points{{0.0, 0.016},
                      {0.04, 0.045},
                      {0.10, 0.095},
                      {0.18, 0.145},
                      {0.28, 0.172},
                      {0.40, 0.172},
                      {0.55, 0.130},
                      {0.70, 0.068},
                      {0.80, 0.039},
                      {0.87, 0.040}}),
       Profile(Points{{0.0, 0.016},
                      {0.04, 0.035},
                      {0.12, 0.078},
                      {0.22, 0.122},
                      {0.34, 0.148},
                      {0.46, 0.142},
                      {0.58, 0.112},
                      {0.70, 0.062},
                      {0.80, 0.037},
                      {0.87, 0.040}}),
       Profile(Points{{0.0, 0.016},
                      {0.06, 0.034},
                      {0.15, 0.055},
                      {0.28, 0.066},
                      {0.45, 0.060},
                      {0.62, 0.038},
                      {0.78, 0.017},
                      {0.87, 0.008}}),
       Profile(Points{{0.29, 0.0},
                      {0.33, 0.062},
                      {0.40, 0.080},
                      {0.50, 0.062},
                      {0.58, 0.050},
                      {0.64, 0.048},
                      {0.70, 0.030},
                      {0.73, 0.0}}),
       Profile(Points{{0.57, 0.0}, {0.60, 0.055}, {0.64, 0.052}, {0.70, 0.030}, {0.74, 0.0}}),
       0.150, 0.075});
  shapes.push_back(
      {"bass",
       Profile(Points{{0.0, 0.016},
                      {0.05, 0.036},
                      {0.12, 0.064},
                      {0.22, 0.092},
                      {0.34, 0.106},
                      {0.48, 0.100},
                      {0.62, 0.076},
                      {0.74, 0.050},
                      {0.82, 0.038},
                      {0.87, 0.040}}),
       Profile(Points{{0.0, 0.016},
                      {0.05, 0.036},
                      {0.12, 0.062},
                      {0.22, 0.090},
                      {0.34, 0.106},
                      {0.48, 0.102},
                      {0.62, 0.078},
                      {0.74, 0.050},
                      {0.82, 0.037},
                      {0.87, 0.039}}),
       Profile(Points{{0.0, 0.016},
                      {0.06, 0.036},
                      {0.15, 0.058},
                      {0.28, 0.070},
                      {0.45, 0.066},
                      {0.62, 0.046},
                      {0.78, 0.020},
                      {0.87, 0.009}}),
       Profile(Points{{0.30, 0.0},
                      {0.34, 0.060},
                      {0.38, 0.074},
                      {0.46, 0.046},
                      {0.52, 0.010},
                      {0.54, 0.048},
                      {0.58, 0.056},
                      {0.66, 0.030},
                      {0.70, 0.0}}),
       Profile(Points{{0.60, 0.0}, {0.63, 0.052}, {0.67, 0.048}, {0.72, 0.022}, {0.75, 0.0}}),
       0.125, 0.050});
  shapes.push_back(
      {"perch",
       Profile(Points{{0.0, 0.016},
                      {0.05, 0.036},
                      {0.12, 0.068},
                      {0.20, 0.112},
                      {0.29, 0.136},
                      {0.42, 0.128},
                      {0.58, 0.090},
                      {0.72, 0.053},
                      {0.81, 0.036},
                      {0.87, 0.039}}),
       Profile(Points{{0.0, 0.016},
                      {0.05, 0.034},
                      {0.12, 0.066},
                      {0.22, 0.098},
                      {0.36, 0.118},
                      {0.50, 0.108},
                      {0.62, 0.080},
                      {0.73, 0.050},
                      {0.81, 0.035},
                      {0.87, 0.038}}),
       Profile(Points{{0.0, 0.016},
                      {0.06, 0.036},
                      {0.15, 0.060},
                      {0.28, 0.072},
                      {0.45, 0.065},
                      {0.62, 0.043},
                      {0.78, 0.019},
                      {0.87, 0.009}}),
       Profile(Points{{0.26, 0.0},
                      {0.29, 0.066},
                      {0.36, 0.090},
                      {0.44, 0.066},
                      {0.51, 0.012},
                      {0.53, 0.050},
                      {0.57, 0.060},
                      {0.66, 0.034},
                      {0.71, 0.0}}),
       Profile(Points{{0.60, 0.0}, {0.63, 0.060}, {0.67, 0.054}, {0.72, 0.024}, {0.75, 0.0}}),
       0.120, 0.035});
  return shapes;
}

std::vector<FishPart> MakeFish(const FishShape& shape) {
  std::vector<FishPart> parts;
  for (std::size_t i = 0; i < kBegins.size(); ++i) {
    const bool last = i + 1 == kBegins.size();
    const double end = last ? kBodyEnd : kBegins[i + 1];
    FishPart part{BodyPart(shape, kBegins[i], end), Place(kBegins[i])};
    part.mesh.Append(MiddleFin(shape, 1.0, kBegins[i], end));
    part.mesh.Append(MiddleFin(shape, -1.0, kBegins[i], end));
    if (i == 0) part.mesh.Append(PairedFins(shape));
    if (last) part.mesh.Append(TailFin(shape));
    parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace drydock::scenes::creatures
