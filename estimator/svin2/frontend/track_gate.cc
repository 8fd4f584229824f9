#include "estimator/svin2/frontend/track_gate.h"

#include "estimator/svin2/frontend/image_pyramid.h"

namespace drydock::svin2 {

TrackGate::Verdict TrackGate::Judge(const StereoGeometry& geometry,
                                    const std::vector<FeatureTrack>& tracks,
                                    const std::optional<MotionPrediction>& motion,
                                    const LandmarkLookup& landmarks, std::uint64_t seed) const {
  Verdict verdict;
  verdict.left.assign(tracks.size(), true);
  verdict.right.assign(tracks.size(), true);
  std::vector<LandmarkObservation> seen;
  std::vector<std::size_t> track_of;
  std::vector<bool> has_landmark(tracks.size(), false);
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    const auto p_W = landmarks ? landmarks(tracks[i].id) : std::nullopt;
    if (!p_W.has_value()) continue;
    has_landmark[i] = true;
    const double scale = OctaveScale(tracks[i].octave);
    seen.push_back({*p_W, 0, tracks[i].left, scale});
    track_of.push_back(i);
    if (!tracks[i].right.has_value()) continue;
    seen.push_back({*p_W, 1, *tracks[i].right, scale});
    track_of.push_back(i);
  }
  const auto prior = motion.has_value() ? std::optional(motion->T_WI_now) : std::nullopt;
  if (const auto pose = EstimateRigPose(geometry, seen, prior, seed, config_.ransac)) {
    verdict.T_WI = pose->T_WI;
    std::vector<bool> agrees(seen.size(), false);
    for (const std::size_t i : pose->inliers) agrees[i] = true;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      if (agrees[i]) continue;
      (seen[i].camera == 0 ? verdict.left : verdict.right)[track_of[i]] = false;
    }
  }
  if (!motion.has_value()) return verdict;
  const Pose T_WC_now = verdict.T_WI.value_or(motion->T_WI_now) * geometry.T_IC(0);
  const Pose T_now_before = T_WC_now.Inverse() * motion->T_WI_before * geometry.T_IC(0);
  if (T_now_before.p().norm() < config_.min_baseline_m) return verdict;
  const CameraModel& camera = geometry.camera(0);
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    if (has_landmark[i]) continue;
    const auto distance =
        EpipolarDistance(camera, tracks[i].left_before, camera, tracks[i].left, T_now_before);
    const double largest = OctaveScale(tracks[i].octave) * config_.max_epipolar_px;
    if (distance.has_value() && *distance > largest) verdict.left[i] = false;
  }
  return verdict;
}

}  // namespace drydock::svin2
