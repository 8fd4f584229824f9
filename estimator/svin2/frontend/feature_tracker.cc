#include "estimator/svin2/frontend/feature_tracker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "sensors_models/base/check.h"

namespace drydock::svin2 {
namespace {

// Lucas-Kanade alone: the anchors do the rest.
PatchTracker::Config FlowOnly(PatchTracker::Config config) {
  config.patch_radius_px = 0;
  config.max_forward_backward_px = 0.0;
  return config;
}

Preprocessor::Config PreprocessorOr(bool on, Preprocessor::Config config) {
  if (on) return config;
  config.denoise_sigma_px = config.background_sigma_px = 0.0;
  config.adjust_contrast = config.clahe = false;
  return config;
}

int EmptyQuadrants(const std::vector<FeatureTrack>& tracks, const CameraIntrinsics& camera) {
  std::array<bool, 4> seen{};
  for (const FeatureTrack& track : tracks) {
    const int column = track.left.x() < 0.5 * camera.width ? 0 : 1;
    const int row = track.left.y() < 0.5 * camera.height ? 0 : 1;
    seen[2 * row + column] = true;
  }
  return static_cast<int>(std::ranges::count(seen, false));
}

}  // namespace

FeatureTracker::FeatureTracker(const Config& config, const StereoSheet& sheet)
    : config_(config),
      geometry_(sheet),
      preprocessor_(PreprocessorOr(config.preprocess, config.preprocessor)),
      detector_(config.detector),
      coarse_detector_(config.coarse_detector),
      extractor_(config.descriptor),
      matcher_(config.descriptor_matcher),
      flow_(FlowOnly(config.patches)),
      anchors_(config.anchors),
      stereo_(config.stereo, geometry_, PatchTracker(config.patches)),
      unfollowed_(config.unfollowed, geometry_, config.stereo, config.patches),
      gate_(config.gate),
      keyframes_(config.keyframes),
      memory_(config.memory_keyframes) {
  const KeypointSigma& sigma = config.sigma;
  RequireInput(sigma.recognised_px > 0.0 && sigma.coarse_px > 0.0 && sigma.per_unlikeness_px >= 0.0,
               "of a keypoint's sigmas, recognised_px is {}, coarse_px {} and per_unlikeness_px "
               "{}; the first two must be positive, the third not negative",
               sigma.recognised_px, sigma.coarse_px, sigma.per_unlikeness_px);
  RequireInput(config.octaves >= 1 && config.enough_points >= 0,
               "octaves is {} and enough_points {}; at least 1 and not negative", config.octaves,
               config.enough_points);
}

bool FeatureTracker::IsUsable(const StereoFrame& images) const {
  for (int i = 0; i < 2; ++i) {
    const cv::Mat& image = images.images[i];
    const CameraIntrinsics& camera = geometry_.camera(i).intrinsics();
    if (image.cols != camera.width || image.rows != camera.height || image.empty()) return false;
    if (image.type() != CV_8UC1 && image.type() != CV_8UC3) return false;
  }
  return true;
}

FeatureTracker::Pyramids FeatureTracker::MakePyramids(const StereoFrame& images) {
  const auto make = [this](const cv::Mat& image) {
    ImagePyramid pyramid = flow_.MakePyramid(preprocessor_.Process(image), 1);
    const int coarser = config_.patches.levels - 1;
    if (coarser == 0) return pyramid;
    const ImagePyramid coarse = flow_.MakePyramid(preprocessor_.Process(image, 1), coarser);
    pyramid.insert(pyramid.end(), coarse.begin(), coarse.end());
    return pyramid;
  };
  return {make(images.images[0]), make(images.images[1])};
}

TrackedFrame FeatureTracker::Track(Time t, const StereoFrame& images,
                                   const std::optional<MotionPrediction>& prediction,
                                   const LandmarkLookup& landmarks) {
  TrackedFrame frame;
  frame.t = t;
  if (!IsUsable(images)) {
    if (prediction && !T_WI_used_) T_WI_used_ = prediction->T_WI_before;
    return frame;
  }
  std::optional<MotionPrediction> motion = prediction;
  if (motion && T_WI_used_) motion->T_WI_before = *T_WI_used_;
  T_WI_used_.reset();
  const Pyramids now = MakePyramids(images);
  // Without a pose, cameras are taken to look ahead.
  const Eigen::Vector3d down =
      motion.has_value() ? Eigen::Vector3d((motion->T_WI_now * geometry_.T_IC(0)).q().conjugate() *
                                           -Eigen::Vector3d::UnitZ())
                         : Eigen::Vector3d(Eigen::Vector3d::UnitY());
  const Context context{now, motion, landmarks, down};
  if (before_.has_value()) {
    tracks_ = Follow(context, TrackPredictor(geometry_, motion, landmarks));
  }
  MatchStereo(now, false, tracks_);
  const auto T_WI = RemoveOutliers(context, t, tracks_);
  const int tracked = static_cast<int>(tracks_.size());
  const bool is_due = keyframes_.Decide(Report(t).points);
  if (is_due) AddCorners(context, T_WI);
  before_ = now;

  frame = Report(t);
  frame.tracked = tracked;
  frame.is_keyframe = is_due && keyframes_.Keep(frame.points);
  if (config_.matching == Matching::kPatches) return frame;
  if (frame.is_keyframe) {
    memory_.Keep(tracks_);
    ReportDescriptors(context, tracks_, frame);
  } else if (IsToBeDescribed(t)) {
    std::vector<FeatureTrack> described = tracks_;
    Describe(context, described);
    ReportDescriptors(context, described, frame);
  }
  return frame;
}

std::vector<FeatureTrack> FeatureTracker::Follow(const Context& context,
                                                 const TrackPredictor& predictor) const {
  std::vector<TrackPredictor::Point> points;
  points.reserve(tracks_.size());
  for (const FeatureTrack& track : tracks_) points.push_back(predictor.Predict(track));
  return config_.matching == Matching::kDescriptors ? FollowDescriptors(context, points)
                                                    : FollowPatches(context, points);
}

std::vector<FeatureTrack> FeatureTracker::FollowPatches(
    const Context& context, const std::vector<TrackPredictor::Point>& points) const {
  std::vector<Eigen::Vector2d> from, predicted;
  std::vector<int> octaves;
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    from.push_back(tracks_[i].left);
    predicted.push_back(points[i].left);
    octaves.push_back(tracks_[i].octave);
  }
  const auto flow = flow_.Track(before_->left, context.now.left, from, predicted, octaves);
  std::vector<FeatureTrack> followed;
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    if (!flow[i].IsTracked()) continue;
    FeatureTrack track = tracks_[i];
    if (!anchors_.Follow(before_->left, context.now.left, flow[i].pixel, track)) continue;
    track.inverse_depth = points[i].inverse_depth;
    track.left_before = tracks_[i].left;
    ++track.age;
    followed.push_back(std::move(track));
  }
  return followed;
}

std::vector<FeatureTrack> FeatureTracker::FollowDescriptors(
    const Context& context, const std::vector<TrackPredictor::Point>& points) const {
  const cv::Mat& image = context.now.left[0];
  std::vector<Eigen::Vector2d> pixels;
  for (const Corner& corner : detector_.Detect(image)) pixels.push_back(corner.pixel);
  const auto descriptors =
      extractor_.Describe(image, pixels, geometry_.camera(0), context.gravity_C);
  std::vector<DescribedPoint> corners, expected;
  for (std::size_t i = 0; i < pixels.size(); ++i) corners.push_back({pixels[i], descriptors[i]});
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    expected.push_back({points[i].left, tracks_[i].descriptor});
  }
  const auto matches = matcher_.Match(expected, corners);
  std::vector<FeatureTrack> followed;
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    if (!matches[i].has_value()) continue;
    FeatureTrack track = tracks_[i];
    const Eigen::Vector2d& corner = corners[*matches[i]].pixel;
    if (!anchors_.Follow(before_->left, context.now.left, corner, track)) continue;
    track.inverse_depth = points[i].inverse_depth;
    track.left_before = tracks_[i].left;
    ++track.age;
    followed.push_back(std::move(track));
  }
  return followed;
}

bool FeatureTracker::AcceptRight(const Eigen::Vector2d& right, FeatureTrack& track) const {
  const auto inverse_depth = geometry_.InverseDepth(track.left, right);
  if (!inverse_depth.has_value() || !stereo_.IsOnCurve(track.left, right, track.octave))
    return false;
  track.right = right;
  track.inverse_depth = std::max(*inverse_depth, 0.0);
  return true;
}

bool FeatureTracker::FollowInRight(const ImagePyramid& right, FeatureTrack& track) const {
  if (!track.inverse_depth.has_value()) return false;
  const auto start = geometry_.Transfer(track.left, *track.inverse_depth);
  const auto found = start.has_value() ? anchors_.FindInRight(right, *start, track) : std::nullopt;
  return found.has_value() && AcceptRight(*found, track);
}

// Where a depth is known the anchor is looked for at once; else, or if it is not there, the patch
// of the left image is tracked into the right one. Without a depth only if `search`.
void FeatureTracker::MatchStereo(const Pyramids& now, bool search,
                                 std::vector<FeatureTrack>& tracks) const {
  std::vector<SoughtInRight> sought;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    tracks[i].right.reset();
    if (!search && !tracks[i].inverse_depth.has_value()) continue;
    if (FollowInRight(now.right, tracks[i])) continue;
    sought.push_back({tracks[i].left, tracks[i].inverse_depth, tracks[i].octave});
    places.push_back(i);
  }
  const auto matches = stereo_.Match(now.left, now.right, sought);
  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (!matches[i].IsTracked()) continue;
    FeatureTrack& track = tracks[places[i]];
    const auto finer = anchors_.FindInRight(now.right, matches[i].pixel, track);
    if (!finer.has_value() || !AcceptRight(*finer, track)) AcceptRight(matches[i].pixel, track);
  }
}

std::optional<Pose> FeatureTracker::RemoveOutliers(const Context& context, Time t,
                                                   std::vector<FeatureTrack>& tracks) const {
  const auto verdict = gate_.Judge(geometry_, tracks, context.motion, context.landmarks,
                                   static_cast<std::uint64_t>(t.ns));
  std::vector<FeatureTrack> kept;
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    if (!verdict.left[i]) continue;
    if (!verdict.right[i]) tracks[i].right.reset();
    kept.push_back(std::move(tracks[i]));
  }
  tracks = std::move(kept);
  return verdict.T_WI;
}

void FeatureTracker::Describe(const Context& context, std::vector<FeatureTrack>& tracks) const {
  for (int octave = 0; octave < static_cast<int>(context.now.left.size()); ++octave) {
    std::vector<Eigen::Vector2d> pixels;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < tracks.size(); ++i) {
      if (tracks[i].octave != octave) continue;
      pixels.push_back(tracks[i].left);
      places.push_back(i);
    }
    if (pixels.empty()) continue;
    const auto descriptors =
        extractor_.Describe(context.now.left[octave], pixels, geometry_.camera(0),
                            context.gravity_C, OctaveScale(octave));
    for (std::size_t k = 0; k < places.size(); ++k) tracks[places[k]].descriptor = descriptors[k];
  }
}

// Corners of an octave; without ids yet. Fine ones are looked for as if there were no coarse ones;
// coarse ones where both eyes see nothing finer, for of what one eye sees much is noise.
std::vector<FeatureTrack> FeatureTracker::NewTracks(int octave, const ImagePyramid& image) const {
  const double scale = OctaveScale(octave);
  const CornerDetector& detector = octave == 0 ? detector_ : coarse_detector_;
  std::vector<Eigen::Vector2d> occupied;
  occupied.reserve(tracks_.size());
  for (const FeatureTrack& track : tracks_) {
    const bool is_finer = track.octave < octave && track.right.has_value();
    if (track.octave == octave || is_finer) occupied.emplace_back(track.left / scale);
  }
  std::vector<FeatureTrack> fresh;
  for (const Corner& corner : detector.Detect(image[octave], occupied)) {
    FeatureTrack track;
    track.octave = octave;
    track.left = track.left_before = scale * corner.pixel;
    if (anchors_.Anchor(image, track)) fresh.push_back(std::move(track));
  }
  return fresh;
}

void FeatureTracker::AddCorners(const Context& context, const std::optional<Pose>& T_WI) {
  std::optional<Pose> pose = T_WI;
  if (!pose.has_value() && context.motion.has_value()) pose = context.motion->T_WI_now;
  const bool describe = config_.matching != Matching::kPatches;
  if (describe) Describe(context, tracks_);
  const int octaves = config_.matching == Matching::kDescriptors ? 1 : config_.octaves;
  for (int octave = 0; octave < std::min(octaves, static_cast<int>(context.now.left.size()));
       ++octave) {
    if (octave > 0 && octave * SeenByBoth(tracks_) >= config_.enough_points) break;
    std::vector<FeatureTrack> fresh = NewTracks(octave, context.now.left);
    if (describe) Describe(context, fresh);
    if (describe && pose.has_value()) {
      std::vector<FeatureTrack> regained = Regain(octave, context, *pose, fresh);
      MatchStereo(context.now, false, regained);
      std::ranges::move(regained, std::back_inserter(tracks_));
    }
    MatchStereo(context.now, true, fresh);
    for (FeatureTrack& track : fresh) {
      if (octave > 0 && !track.right.has_value()) continue;
      track.id = next_id_++;
      tracks_.push_back(std::move(track));
    }
  }
  std::ranges::sort(tracks_, {}, &FeatureTrack::id);
}

// Lost points that are among the new corners; these corners are taken out.
std::vector<FeatureTrack> FeatureTracker::Regain(int octave, const Context& context,
                                                 const Pose& T_WI,
                                                 std::vector<FeatureTrack>& corners) const {
  const Pose T_CW = (T_WI * geometry_.T_IC(0)).Inverse();
  std::vector<FeatureTrack> lost;
  std::vector<DescribedPoint> expected, found;
  for (FeatureTrack& track : memory_.Lost(tracks_)) {
    if (track.octave != octave) continue;
    const auto p_W = context.landmarks ? context.landmarks(track.id) : std::nullopt;
    if (!p_W.has_value()) continue;
    const Eigen::Vector3d p_C = T_CW * *p_W;
    const auto pixel = geometry_.camera(0).Project(p_C);
    if (!pixel.has_value() || !geometry_.camera(0).IsInside(*pixel)) continue;
    expected.push_back({*pixel, track.descriptor});
    track.inverse_depth = 1.0 / p_C.z();
    lost.push_back(std::move(track));
  }
  for (const FeatureTrack& corner : corners) found.push_back({corner.left, corner.descriptor});
  const auto matches = matcher_.Match(expected, found);
  std::vector<FeatureTrack> regained;
  std::vector<bool> is_taken(corners.size(), false);
  for (std::size_t i = 0; i < lost.size(); ++i) {
    if (!matches[i].has_value()) continue;
    const FeatureTrack& corner = corners[*matches[i]];
    if (!anchors_.Regain(context.now.left, corner.left, lost[i])) continue;
    lost[i].left_before = lost[i].left;
    lost[i].descriptor = corner.descriptor;
    ++lost[i].age;
    is_taken[*matches[i]] = true;
    regained.push_back(std::move(lost[i]));
  }
  std::vector<FeatureTrack> left_over;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (!is_taken[i]) left_over.push_back(std::move(corners[i]));
  }
  corners = std::move(left_over);
  return regained;
}

TrackedFrame FeatureTracker::Report(Time t) const {
  TrackedFrame frame;
  frame.t = t;
  for (const FeatureTrack& track : tracks_) {
    frame.points.push_back(
        {track.id, track.left, track.right, config_.sigma.Of(track.octave, track.correlation)});
  }
  frame.empty_quadrants = EmptyQuadrants(tracks_, geometry_.camera(0).intrinsics());
  return frame;
}

bool FeatureTracker::IsToBeDescribed(Time t) const {
  return config_.describe_every && last_described_ && !tracks_.empty() &&
         t - *last_described_ >= *config_.describe_every;
}

void FeatureTracker::ReportDescriptors(const Context& context,
                                       const std::vector<FeatureTrack>& tracks,
                                       TrackedFrame& frame) {
  const bool has_few = SeenByBoth(tracks) < config_.unfollowed.enough_points;
  for (std::size_t i = 0; i < frame.points.size(); ++i) {
    // Where few corners are seen twice, most of those seen once are noise.
    const bool is_seen_twice = tracks[i].right.has_value() || tracks[i].age > 0;
    if (is_seen_twice || !has_few) frame.points[i].descriptor = tracks[i].descriptor;
  }
  if (config_.describe_every.has_value()) {
    frame.unfollowed = unfollowed_.Find(context.now.left, context.now.right, tracks,
                                        context.gravity_C, extractor_, config_.sigma);
  }
  frame.is_described = true;
  last_described_ = frame.t;
}

}  // namespace drydock::svin2
