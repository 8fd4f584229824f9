// Two keyframes of one place, with the truth.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "estimator/svin2/frontend/stereo_geometry.h"
#include "estimator/svin2/loop/keyframe.h"
#include "estimator/svin2/loop/keyframe_landmarks.h"
#include "estimator/svin2/loop/loop_matcher.h"
#include "sensors_models/base/random_stream.h"
#include "tests/estimator/svin2/synthetic_stereo.h"
#include "tests/estimator/svin2/vocabulary/synthetic_descriptors.h"

namespace drydock::svin2::testing {

struct LoopOptions {
  std::uint64_t seed = 1;
  int landmarks = 80;
  double sigma_px = 0.15;    ///< Believed; and the noise, if `noisy`.
  bool noisy = false;        ///< Pixels have noise.
  double offset_px = 0.0;    ///< Of now's corners beside then's, the same in both eyes (sigma).
  double window_sigma = -1;  ///< Noise of p_I: that of stereo with so many times sigma_px;
                             ///< negative: p_I is by stereo.
  int changed_bits = 30;     ///< Of each descriptor, from `then` to `now`.
  double half_width = 0.5;   ///< Of the view, as a slope: 0.5 fills most of the image.
  Pose T_then_now = Pose(FromYawPitchRoll(0.2, -0.05, 0.03), {0.3, 0.8, -0.2});
};

struct SyntheticLoop {
  StereoGeometry rig = StereoGeometry(SyntheticStereo());
  Pose T_then_now;
  Keyframe now, then;
  std::vector<Eigen::Vector3d> landmarks;  ///< Of the points [m, in then's body frame].
  std::vector<LoopMatch> matches;          ///< All of them, and right.
};

inline Descriptor Changed(const Descriptor& descriptor, int bits, RandomStream& random) {
  Descriptor changed = descriptor;
  while (HammingDistance(changed, descriptor) < bits) {
    const std::uint64_t at = random.Bits() % 512;
    changed[at / 64] ^= std::uint64_t{1} << (at % 64);
  }
  return changed;
}

/// Which points lie below which node.
using NodeMap = std::map<NodeId, std::vector<std::uint32_t>>;

inline DirectIndex IndexOf(const NodeMap& nodes) {
  DirectIndex index;
  for (const auto& [node, points] : nodes) index.push_back({node, points});
  return index;
}

/// The pixel of a point of the body's frame; nothing outside the image.
inline std::optional<Eigen::Vector2d> PixelOf(const StereoGeometry& rig, int camera,
                                              const Eigen::Vector3d& p_I) {
  const auto pixel = rig.camera(camera).Project(rig.T_IC(camera).Inverse() * p_I);
  if (!pixel.has_value() || !rig.camera(camera).IsInside(*pixel)) return std::nullopt;
  return pixel;
}

/// A landmark with the noise of one stereo pair of window_sigma sigma_px.
inline Eigen::Vector3d AsWindowHasIt(const Eigen::Vector3d& p_I, const LoopOptions& options,
                                     RandomStream& noise) {
  const double x = p_I.x();
  const double across = options.window_sigma * options.sigma_px * x / 575.0 / std::sqrt(2.0);
  const double along = across * x * 2.0 / 0.142;
  const double e_x = noise.Gaussian();
  const double e_y = noise.Gaussian();
  const double e_z = noise.Gaussian();
  return p_I + e_x * along * p_I.normalized() + across * Eigen::Vector3d(0.0, e_y, e_z);
}

/// Landmarks 1.5 to 5 m ahead of `then`, all of them seen in all four images. The k-th point of
/// either keyframe is the k-th landmark, in another order in `now`.
inline SyntheticLoop MakeLoop(const LoopOptions& options = {}) {
  SyntheticLoop loop;
  loop.T_then_now = options.T_then_now;
  RandomStream places(options.seed, "landmarks"), noise(options.seed, "keypoints");
  const auto jitter = [&noise](double sigma) -> Eigen::Vector2d {
    const double u = noise.Gaussian();
    const double v = noise.Gaussian();
    return sigma * Eigen::Vector2d(u, v);
  };
  const double sigma = options.noisy ? options.sigma_px : 0.0;
  while (static_cast<int>(loop.landmarks.size()) < options.landmarks) {
    const double x = places.Uniform(1.5, 5.0);
    const double y = places.Uniform(-options.half_width, options.half_width) * x;
    const double z = places.Uniform(-options.half_width, options.half_width) * x;
    const Eigen::Vector3d p_then(x, y, z), p_now = options.T_then_now.Inverse() * p_then;
    std::array<std::optional<Eigen::Vector2d>, 4> seen;
    for (int camera = 0; camera < 2; ++camera) {
      seen[camera] = PixelOf(loop.rig, camera, p_then);
      seen[2 + camera] = PixelOf(loop.rig, camera, p_now);
    }
    if (!std::ranges::all_of(seen, [](const auto& pixel) { return pixel.has_value(); })) continue;
    const LandmarkId id = loop.landmarks.size() + 1;
    const Eigen::Vector2d beside = jitter(options.offset_px);
    KeyframePoint then{.id = id, .sigma_px = options.sigma_px};
    then.left = *seen[0] + jitter(sigma);
    then.right = *seen[1] + jitter(sigma);
    then.descriptor = RandomDescriptor(places);
    KeyframePoint now{.id = id + 1000, .sigma_px = options.sigma_px};
    now.left = *seen[2] + beside + jitter(sigma);
    now.right = *seen[3] + beside + jitter(sigma);
    now.descriptor = Changed(then.descriptor, options.changed_bits, places);
    if (options.window_sigma >= 0.0) {
      then.p_I = AsWindowHasIt(p_then, options, noise);
      now.p_I = AsWindowHasIt(p_now, options, noise);
    }
    loop.landmarks.push_back(p_then);
    loop.then.points.push_back(then);
    loop.now.points.push_back(now);
  }
  const std::size_t count = loop.landmarks.size();
  std::ranges::reverse(loop.now.points);
  for (std::size_t k = 0; k < count; ++k) loop.matches.push_back({k, count - 1 - k, 0});
  loop.then.index = 3;
  loop.now.index = 70;
  loop.then.T_WI = Pose(FromYawPitchRoll(1.0, 0.1, -0.05), {4, 5, -2});
  loop.now.T_WI = loop.then.T_WI * loop.T_then_now;
  for (Keyframe* keyframe : {&loop.then, &loop.now}) TriangulateByStereo(loop.rig, *keyframe);
  return loop;
}

/// As if the left eye alone had seen what the keyframe sees.
inline void CloseRightEye(Keyframe& keyframe) {
  for (KeyframePoint& point : keyframe.points) {
    point.right.reset();
    point.p_I.reset();
  }
}

/// The first of the matches, `share` of all, each with a wrong partner.
inline std::vector<LoopMatch> WithOutliers(std::vector<LoopMatch> matches, double share) {
  const auto wrong =
      static_cast<std::size_t>(std::lround(share * static_cast<double>(matches.size())));
  for (std::size_t k = 0; k + 1 < wrong; ++k) std::swap(matches[k].then, matches[k + 1].then);
  return matches;
}

/// How far a pose is off: position [m] and angle [rad] together.
inline double ErrorOf(const Pose& T, const Pose& truth) { return T.BoxMinus(truth).norm(); }

}  // namespace drydock::svin2::testing
