// Points around the synthetic motion, as a perfect front end would follow them.
#pragma once

#include <algorithm>
#include <set>
#include <vector>

#include "estimator/svin2/frontend/stereo_geometry.h"
#include "estimator/svin2/frontend/tracked_frame.h"
#include "sensors_models/base/random_stream.h"
#include "tests/estimator/svin2/synthetic_stereo.h"

namespace drydock::svin2::testing {

/// Landmarks in a box, seen from wherever the body is.
class SyntheticTracks {
 public:
  /// `landmarks` points; keypoints have white noise of `sigma_px` (of 1 where that is 0).
  SyntheticTracks(int landmarks, double sigma_px, std::uint64_t seed = 1)
      : geometry_(SyntheticStereo()), sigma_px_(sigma_px), noise_(seed, "keypoints") {
    RandomStream random(seed, "landmarks");
    for (int k = 0; k < landmarks; ++k) {
      const double x = random.Uniform(1.5, 7.0);
      const double y = random.Uniform(-4.0, 4.0);
      const double z = random.Uniform(-2.0, 2.0);
      landmarks_.emplace_back(x, y, z);
    }
  }

  const std::vector<Eigen::Vector3d>& landmarks() const { return landmarks_; }

  /// What a body at `T_WI` sees; a keyframe where less than 60 % was seen by the last one.
  TrackedFrame See(Time t, const Pose& T_WI) {
    TrackedFrame frame;
    frame.t = t;
    std::set<LandmarkId> seen;
    for (std::size_t k = 0; k < landmarks_.size(); ++k) {
      const auto left = Pixel(T_WI, landmarks_[k], 0);
      if (!left) continue;
      const LandmarkId id = k + 1;
      const double sigma_px = sigma_px_ > 0.0 ? sigma_px_ : 1.0;
      frame.points.push_back({id, *left, Pixel(T_WI, landmarks_[k], 1), sigma_px});
      seen.insert(id);
    }
    frame.tracked = static_cast<int>(std::count_if(
        seen.begin(), seen.end(), [&](LandmarkId id) { return in_keyframe_.contains(id); }));
    frame.is_keyframe = 10 * frame.tracked <= 6 * static_cast<int>(seen.size());
    if (frame.is_keyframe) in_keyframe_ = seen;
    return frame;
  }

 private:
  std::optional<Eigen::Vector2d> Pixel(const Pose& T_WI, const Eigen::Vector3d& p_W, int camera) {
    const Eigen::Vector3d p_C = (T_WI * geometry_.T_IC(camera)).Inverse() * p_W;
    if (p_C.z() < 0.3 || p_C.head<2>().norm() > p_C.z()) return std::nullopt;
    const auto pixel = geometry_.camera(camera).Project(p_C);
    if (!pixel || !geometry_.camera(camera).IsInside(*pixel)) return std::nullopt;
    const double u = noise_.Gaussian();
    const double v = noise_.Gaussian();
    return *pixel + sigma_px_ * Eigen::Vector2d(u, v);
  }

  StereoGeometry geometry_;
  double sigma_px_;
  RandomStream noise_;
  std::vector<Eigen::Vector3d> landmarks_;
  std::set<LandmarkId> in_keyframe_;
};

}  // namespace drydock::svin2::testing
