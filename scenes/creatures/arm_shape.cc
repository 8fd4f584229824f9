#include "scenes/creatures/arm_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "scenes/mesh/lattice_noise.h"

namespace drydock::scenes::creatures {
namespace {
using Eigen::Vector2d;
using Eigen::Vector3d;
constexpr double kPi = std::numbers::pi;
constexpr std::uint64_t kFolds = 3;  // Of the shape alone: the same on every arm.

/// A ring of a limb: its middle, half its width and half its height.
struct Ring {
  Vector3d middle;
  double width;
  double height;
};

/// From the top (0) down either side to the underside (1).
double Unrolled(double angle) { return (kPi - std::abs(kPi - angle)) / kPi; }

/// A limb along rings. `at(along, unrolled)` is the place in the picture [m], `along` the way from
/// the first ring; `dent(p)` moves a point outwards [m].
template <typename PictureFunction, typename DentFunction>
Mesh Limb(const std::vector<Ring>& rings, int around, const PictureFunction& at,
          const DentFunction& dent) {
  std::vector<double> along(rings.size(), 0.0);
  for (std::size_t i = 1; i < rings.size(); ++i)
    along[i] = along[i - 1] + (rings[i].middle - rings[i - 1].middle).norm();
  return Loft(static_cast<int>(rings.size()), around, [&](int i, double angle) -> SurfacePoint {
    const auto ring = static_cast<std::size_t>(i);
    const std::size_t before = ring == 0 ? 0 : ring - 1;
    const std::size_t after = std::min(ring + 1, rings.size() - 1);
    const Vector3d ahead = (rings[after].middle - rings[before].middle).normalized();
    const Vector3d up = (Vector3d::UnitZ() - ahead.z() * ahead).normalized();
    const Vector3d side = ahead.cross(up);
    const Vector3d out = std::cos(angle) * up + std::sin(angle) * side;
    const Vector3d p = rings[ring].middle + std::cos(angle) * rings[ring].height * up +
                       std::sin(angle) * rings[ring].width * side;
    const Vector2d place = at(along[ring], Unrolled(angle));
    return {p + dent(p) * out, {place.x() / ArmPicture::kWidth, place.y() / ArmPicture::kHeight}};
  });
}

/// Rings between the given ones, `step` apart at most.
std::vector<Ring> Refined(const std::vector<Ring>& coarse, double step) {
  std::vector<Ring> rings = {coarse.front()};
  for (std::size_t i = 1; i < coarse.size(); ++i) {
    const Ring& a = coarse[i - 1];
    const Ring& b = coarse[i];
    const int pieces =
        std::max(1, static_cast<int>(std::ceil((b.middle - a.middle).norm() / step)));
    for (int k = 1; k <= pieces; ++k) {
      const double t = static_cast<double>(k) / pieces;
      rings.push_back({a.middle + t * (b.middle - a.middle), a.width + t * (b.width - a.width),
                       a.height + t * (b.height - a.height)});
    }
  }
  return rings;
}

Mesh Sleeve() {
  const std::vector<Ring> rings = Refined({{{-0.235, -0.030, -0.145}, 0.062, 0.062},
                                           {{-0.130, -0.014, -0.072}, 0.061, 0.061},
                                           {{-0.050, -0.004, -0.022}, 0.060, 0.058},
                                           {{0.000, 0.000, -0.004}, 0.058, 0.054},
                                           {{0.040, 0.000, 0.000}, 0.057, 0.052},
                                           {{0.090, 0.000, 0.000}, 0.054, 0.049},
                                           {{0.150, 0.000, 0.000}, 0.046, 0.042},
                                           {{0.205, 0.000, 0.000}, 0.039, 0.034},
                                           {{0.235, 0.000, 0.000}, 0.035, 0.030}},
                                          0.012);
  return Limb(
      rings, 28,
      [](double along, double unrolled) {
        return Vector2d(unrolled * ArmPicture::kSleeveWidth, along);
      },
      [](const Vector3d& p) {
        // Creases across the arm, deep in the bend of the elbow, shallow elsewhere.
        const double bend = std::exp(-std::pow((p.x() + 0.01) / 0.055, 2.0));
        const double lower = std::clamp(0.5 + 8.0 * p.z(), 0.15, 1.0);
        const Vector3d q(p.x() / 0.020, p.y() / 0.075, p.z() / 0.075);
        return (0.0022 + 0.0055 * bend * lower) * Fbm3(q, 2, kFolds);
      });
}

Mesh Palm() {
  const std::vector<Ring> rings = Refined({{{0.195, 0.000, 0.000}, 0.0435, 0.0385},
                                           {{0.199, 0.000, 0.000}, 0.0465, 0.0415},
                                           {{0.208, 0.000, 0.000}, 0.0455, 0.0405},
                                           {{0.228, 0.000, 0.000}, 0.0390, 0.0340},
                                           {{0.250, 0.001, 0.000}, 0.0350, 0.0285},
                                           {{0.272, 0.002, 0.000}, 0.0375, 0.0250},
                                           {{0.300, 0.003, 0.001}, 0.0430, 0.0225},
                                           {{0.335, 0.002, 0.001}, 0.0460, 0.0195},
                                           {{0.358, 0.001, 0.000}, 0.0450, 0.0165},
                                           {{0.370, 0.001, -0.001}, 0.0410, 0.0115}},
                                          0.010);
  return Limb(
      rings, 26,
      [](double along, double unrolled) {
        return Vector2d(ArmPicture::kGloveLeft + unrolled * ArmPicture::kGloveWidth, along);
      },
      [](const Vector3d& p) { return 0.0022 * Fbm3(p / 0.022, 2, kFolds + 1); });
}

/// A finger from its root: three bones that bend by `curl` more each [rad], about `axis`.
Mesh Finger(const Vector3d& root, Vector3d direction, const Vector3d& axis, double length,
            double radius, double curl) {
  constexpr std::array<double, 3> kBones = {0.42, 0.32, 0.26};
  std::vector<Ring> coarse = {{root - 0.018 * direction, radius, radius}};
  Vector3d p = root;
  for (std::size_t bone = 0; bone < kBones.size(); ++bone) {
    const double r = radius * (1.0 - 0.10 * static_cast<double>(bone));
    coarse.push_back({p, 1.06 * r, 1.06 * r});  // A knuckle.
    coarse.push_back({p + 0.5 * kBones[bone] * length * direction, 0.96 * r, 0.96 * r});
    p += kBones[bone] * length * direction;
    direction = Eigen::AngleAxisd(curl, axis) * direction;
  }
  // Half a ball at the tip.
  const double r = 0.75 * radius;
  const Vector3d tip = Eigen::AngleAxisd(-curl, axis) * direction;
  for (const double t : {-0.25, 0.3, 0.6, 0.85, 0.97}) {
    const double across = t < 0 ? 1.0 : std::sqrt(1.0 - t * t);
    coarse.push_back({p + t * r * tip, across * r, across * r});
  }
  return Limb(
      coarse, 12,
      [](double along, double unrolled) {
        return Vector2d(ArmPicture::kGloveLeft + unrolled * ArmPicture::kFingerWidth,
                        ArmPicture::kFingers + along);
      },
      [](const Vector3d& q) { return 0.0010 * Fbm3(q / 0.012, 1, kFolds + 2); });
}

Mesh Fingers() {
  Mesh fingers;
  const Vector3d down = Vector3d::UnitY();  // Bends x downwards.
  const auto ahead = [](double aside) { return Vector3d(1.0, aside, -0.12).normalized(); };
  fingers.Append(Finger({0.355, 0.0315, -0.001}, ahead(0.10), down, 0.082, 0.0108, 0.34));
  fingers.Append(Finger({0.362, 0.0105, 0.001}, ahead(0.02), down, 0.090, 0.0110, 0.40));
  fingers.Append(Finger({0.359, -0.0110, 0.000}, ahead(-0.05), down, 0.085, 0.0106, 0.48));
  fingers.Append(Finger({0.350, -0.0305, -0.002}, ahead(-0.13), down, 0.068, 0.0096, 0.52));
  fingers.Append(Finger({0.290, 0.0345, -0.008}, Vector3d(0.72, 0.62, -0.30).normalized(),
                        Vector3d(0.25, 0.15, -1.0).normalized(), 0.075, 0.0130, 0.26));
  return fingers;
}

/// A strap round the forearm with a round dive computer on top.
Mesh Computer(bool left) {
  constexpr double kAt = 0.150;
  constexpr double kRadius = 0.028;
  const UvRect face = ArmPicture::Face();
  const std::vector<Ring> strap = {{{kAt - 0.013, 0.0, 0.0}, 0.0470, 0.0430},
                                   {{kAt - 0.012, 0.0, 0.0}, 0.0505, 0.0465},
                                   {{kAt + 0.012, 0.0, 0.0}, 0.0480, 0.0440},
                                   {{kAt + 0.013, 0.0, 0.0}, 0.0445, 0.0405}};
  Mesh mesh = Limb(
      strap, 28,
      [&](double, double unrolled) {
        return Vector2d((face.low.x() + 0.01 + 0.02 * unrolled) * ArmPicture::kWidth,
                        (face.high.y() - 0.02) * ArmPicture::kHeight);
      },
      [](const Vector3d&) { return 0.0; });
  // Sits a little inwards of the top, where its wearer looks at it.
  const Eigen::Isometry3d seat =
      Eigen::AngleAxisd(-0.25, Vector3d::UnitX()) * Eigen::Translation3d(kAt, 0.0, 0.036);
  const std::array<Vector2d, 4> side_line = {Vector2d(0.92, 0.0), Vector2d(1.0, 0.006),
                                             Vector2d(1.0, 0.018), Vector2d(0.88, 0.022)};
  Mesh puck =
      Loft(static_cast<int>(side_line.size()), 24, [&](int ring, double angle) -> SurfacePoint {
        const Vector2d& side = side_line[static_cast<std::size_t>(ring)];
        const double x = side.x() * std::cos(angle);
        const double y = side.x() * std::sin(angle);
        // Its top is where the little finger is. On the left arm, which is mirrored, it reads
        // towards
        // the hand, on the right one away from it.
        return {{kRadius * x, kRadius * y, side.y()},
                face.At(0.5 + (left ? 0.5 : -0.5) * x, 0.5 + 0.5 * y)};
      });
  puck.Transform(seat);
  mesh.Append(puck);
  return mesh;
}

}  // namespace

Mesh MakeArm(Side side) {
  Mesh arm = Sleeve();
  arm.Append(Palm());
  arm.Append(Fingers());
  arm.Append(Computer(side == Side::kLeft));
  if (side == Side::kLeft) arm.MirrorY();
  return arm;
}

}  // namespace drydock::scenes::creatures
