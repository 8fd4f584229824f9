#include "estimator/svin2/frontend/unfollowed_corners.h"

#include <optional>

#include "sensors_models/base/check.h"

namespace drydock::svin2 {
namespace {

PatchTracker PatchTrackerFor(PatchTracker::Config config, double min_correlation) {
  config.min_correlation = min_correlation;
  return PatchTracker(config);
}

}  // namespace

UnfollowedCorners::UnfollowedCorners(const Config& config, const StereoGeometry& geometry,
                                     const StereoMatcher::Config& stereo,
                                     PatchTracker::Config patches)
    : config_(config),
      camera_(geometry.camera(0)),
      detector_(config.detector),
      stereo_(stereo, geometry, PatchTrackerFor(patches, config.min_correlation)) {
  RequireInput(config.octave >= 0 && config.enough_points >= 0,
               "octave is {} and enough_points {}; neither may be negative", config.octave,
               config.enough_points);
}

std::vector<TrackedPoint> UnfollowedCorners::Find(const ImagePyramid& left,
                                                  const ImagePyramid& right,
                                                  const std::vector<FeatureTrack>& tracks,
                                                  const Eigen::Vector3d& gravity_C,
                                                  const DescriptorExtractor& extractor,
                                                  const KeypointSigma& sigma) {
  const int octave = config_.octave;
  if (SeenByBoth(tracks) >= config_.enough_points || octave >= static_cast<int>(left.size()))
    return {};
  const double scale = OctaveScale(octave);
  std::vector<Eigen::Vector2d> occupied, pixels;
  for (const FeatureTrack& track : tracks)
    if (track.octave == octave) occupied.emplace_back(track.left / scale);
  std::vector<SoughtInRight> sought;
  for (const Corner& corner : detector_.Detect(left[octave], occupied)) {
    pixels.emplace_back(scale * corner.pixel);
    sought.push_back({pixels.back(), std::nullopt, octave});
  }
  const auto descriptors = extractor.Describe(left[octave], pixels, camera_, gravity_C, scale);
  const auto matches = stereo_.Match(left, right, sought);
  std::vector<TrackedPoint> points;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (!descriptors[i].has_value() || !matches[i].IsTracked()) continue;
    points.push_back({next_id_++, pixels[i], matches[i].pixel,
                      sigma.Of(octave, matches[i].correlation), descriptors[i]});
  }
  return points;
}

}  // namespace drydock::svin2
