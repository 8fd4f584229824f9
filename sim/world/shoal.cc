#include "sim/world/shoal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "sensors_models/base/check.h"
#include "sensors_models/base/random_stream.h"

namespace drydock::sim {
namespace {

using Eigen::Vector3d;
constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr int kHarmonics = 3;

/// A fish's path before it is known how large it may be, in radii of the shoal.
struct Path {
  Vector3d offset = Vector3d::Zero();
  std::array<ClosedCurve::Harmonic, kHarmonics> harmonics;
};

Vector3d Wobble(RandomStream& random, double level, double upright) {
  return {random.Uniform(-level, level), random.Uniform(-level, level),
          random.Uniform(-upright, upright)};
}

/// A dented oval, nearly level, one way round or the other.
Path MakePath(RandomStream& random) {
  const double heading = random.Uniform(0.0, kTurn);
  const double turn = random.Uniform() < 0.5 ? 1.0 : -1.0;
  const Vector3d ahead(std::cos(heading), std::sin(heading), 0.0);
  const Vector3d aside(-turn * ahead.y(), turn * ahead.x(), 0.0);
  Path path;
  path.harmonics[0].cosine = 0.72 * ahead + Wobble(random, 0.0, 0.08);
  path.harmonics[0].sine = random.Uniform(0.42, 0.62) * aside + Wobble(random, 0.0, 0.08);
  path.harmonics[1] = {Wobble(random, 0.06, 0.04), Wobble(random, 0.06, 0.04)};
  path.harmonics[2] = {Wobble(random, 0.025, 0.02), Wobble(random, 0.025, 0.02)};
  return path;
}

/// The path of one of the shoal: `out` and `up` from -1 to 1 say where in it.
Path Vary(Path path, double out, double up, RandomStream& random) {
  path.offset.z() = 0.17 * up;
  for (Vector3d* axis : {&path.harmonics[0].cosine, &path.harmonics[0].sine})
    axis->head<2>() *= 1.0 + 0.15 * out;
  path.harmonics[1].cosine += Wobble(random, 0.02, 0.02);
  path.harmonics[1].sine += Wobble(random, 0.02, 0.02);
  return path;
}

ClosedCurve ToCurve(const Path& path, const Vector3d& centre, double radius) {
  std::vector<ClosedCurve::Harmonic> harmonics;
  harmonics.reserve(path.harmonics.size());
  for (const ClosedCurve::Harmonic& harmonic : path.harmonics)
    harmonics.push_back({radius * harmonic.cosine, radius * harmonic.sine});
  return {centre + radius * path.offset, std::move(harmonics)};
}

/// The curves of all, spread evenly over the shoal's cross-section and as wide as the ball allows.
std::vector<ClosedCurve> MakeCurves(const ShoalConfig& config, RandomStream& random) {
  const Path common = MakePath(random);
  const double shift_out = random.Uniform();
  const double shift_up = random.Uniform();
  std::vector<Path> paths;
  paths.reserve(static_cast<std::size_t>(config.count));
  for (int i = 0; i < config.count; ++i) {
    // Points of the plane's most even sequence (Roberts 2018).
    const double out = shift_out + 0.7548776662466927 * i;
    const double up = shift_up + 0.5698402909980532 * i;
    paths.push_back(Vary(common, 2.0 * (out - std::floor(out)) - 1.0,
                         2.0 * (up - std::floor(up)) - 1.0, random));
  }
  double farthest = 0.0;
  for (const Path& path : paths)
    farthest = std::max(farthest, ToCurve(path, Vector3d::Zero(), 1.0).FarthestFrom({0, 0, 0}));
  const double radius = config.radius_m * std::min(1.0, 0.99 / farthest);
  std::vector<ClosedCurve> curves;
  curves.reserve(paths.size());
  for (const Path& path : paths) curves.push_back(ToCurve(path, config.centre_m, radius));
  return curves;
}

double YawOf(const Vector3d& direction) { return std::atan2(direction.y(), direction.x()); }

/// How far the joint of a share `back` of the way to the last one swings to either side [rad].
double SwingOf(double back) { return 0.33 * std::pow(back, 1.8); }

}  // namespace

Shoal::Shoal(const ShoalConfig& config, const std::vector<CreaturePart>& parts, std::uint64_t seed,
             const std::string& name) {
  for (const CreaturePart& part : parts) joints_.push_back(part.joint);
  RandomStream random(seed, name);
  std::vector<ClosedCurve> curves = MakeCurves(config, random);
  double length = 0.0;
  for (const ClosedCurve& curve : curves) length += curve.length() / config.count;
  // One behind the other by half a length, yet at most over half of the way round.
  const double column = std::min(0.5 * length, 0.55 * config.size_m * config.count) / length;
  const double first = random.Uniform();
  for (int i = 0; i < config.count; ++i) {
    ClosedCurve& curve = curves[static_cast<std::size_t>(i)];
    const double place = first + column * (i + random.Uniform(-0.4, 0.4)) / config.count;
    const double speed = config.speed_m_s * curve.length() / length;
    const double size = config.size_m * random.Uniform(0.85, 1.15);
    const double beat = kTurn * speed / (0.7 * size) * random.Uniform(0.9, 1.1);
    const double start = place * curve.length();
    fish_.push_back({std::move(curve), start, speed, size, beat, random.Uniform(0.0, kTurn)});
    const auto tint = static_cast<float>(random.Uniform(0.82, 1.08));
    for (std::size_t k = 0; k < parts.size(); ++k) {
      bodies_.push_back({fmt::format("{}/{}_{}/{}", name, config.kind, i, k), parts[k].mesh,
                         parts[k].texture, size, tint});
    }
  }
}

void Shoal::AddPoses(const Fish& fish, double t, std::vector<Pose>& poses) const {
  const double s = fish.start + fish.speed * t;
  const Vector3d ahead = fish.path.Ahead(s);
  double yaw = YawOf(ahead);
  Pose T_WF(FromYawPitchRoll(yaw, -std::asin(std::clamp(ahead.z(), -1.0, 1.0)), 0.0),
            fish.path.At(s));
  poses.push_back(T_WF);
  for (std::size_t k = 1; k < joints_.size(); ++k) {
    const double joint = fish.size * joints_[k];
    const double path_yaw = YawOf(fish.path.Ahead(s + joint));
    const double back = static_cast<double>(k) / static_cast<double>(joints_.size() - 1);
    const double wave =
        SwingOf(back) * std::sin(fish.beat * t + fish.phase - 0.8 * static_cast<double>(k));
    const double bend = std::remainder(path_yaw - yaw, kTurn) + wave;
    const Eigen::Quaterniond turned(Eigen::AngleAxisd(bend, Vector3d::UnitZ()));
    const Vector3d pivot(joint, 0.0, 0.0);
    T_WF = T_WF * Pose(turned, pivot - turned * pivot);
    poses.push_back(T_WF);
    yaw = path_yaw;
  }
}

std::vector<Pose> Shoal::At(double t, const Pose& /*T_WI*/) const {
  std::vector<Pose> poses;
  poses.reserve(bodies_.size());
  for (const Fish& fish : fish_) AddPoses(fish, t, poses);
  return poses;
}

}  // namespace drydock::sim
