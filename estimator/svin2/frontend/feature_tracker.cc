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
  config.denoise_sigma_px = 0.0;
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
      extractor_(config.descriptor),
      matcher_(config.descriptor_matcher),
      flow_(FlowOnly(config.patches)),
      anchors_(config.anchors),
      stereo_(config.stereo, geometry_, PatchTracker(config.patches)),
      gate_(config.gate),
      keyframes_(config.keyframes),
      memory_(config.memory_keyframes) {
  RequireInput(config.sigma_px > 0.0 && config.sigma_per_unlikeness_px >= 0.0,
               "sigma_px is {} and sigma_per_unlikeness_px {}; the first must be positive, the "
               "other not negative",
               config.sigma_px, config.sigma_per_unlikeness_px);
}

void FeatureTracker::Restart() {
  tracks_.clear();
  before_.reset();
  last_described_.reset();
  keyframes_.Restart();
  memory_.Clear();
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
    return flow_.MakePyramid(preprocessor_.Process(image));
  };
  return {make(images.images[0]), make(images.images[1])};
}

TrackedFrame FeatureTracker::Track(Time t, const StereoFrame& images,
                                   const std::optional<MotionPrediction>& prediction,
                                   const LandmarkLookup& landmarks) {
  TrackedFrame frame;
  frame.t = t;
  if (!IsUsable(images)) return frame;
  const Pyramids now = MakePyramids(images);
  // Without a pose, cameras are taken to look ahead.
  const Eigen::Vector3d down =
      prediction.has_value()
          ? Eigen::Vector3d((prediction->T_WI_now * geometry_.T_IC(0)).q().conjugate() *
                            -Eigen::Vector3d::UnitZ())
          : Eigen::Vector3d(Eigen::Vector3d::UnitY());
  const Context context{now, prediction, landmarks, down};
  if (before_.has_value()) {
    tracks_ = Follow(context, TrackPredictor(geometry_, prediction, landmarks));
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
    ReportDescriptors(tracks_, frame);
  } else if (IsToBeDescribed(t)) {
    std::vector<FeatureTrack> described = tracks_;
    Describe(context, described);
    ReportDescriptors(described, frame);
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
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    from.push_back(tracks_[i].left);
    predicted.push_back(points[i].left);
  }
  const auto flow = flow_.Track(before_->left, context.now.left, from, predicted);
  std::vector<FeatureTrack> followed;
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    if (!flow[i].IsTracked()) continue;
    FeatureTrack track = tracks_[i];
    if (!anchors_.Follow(before_->left[0], context.now.left[0], flow[i].pixel, track)) continue;
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
    if (!anchors_.Follow(before_->left[0], image, corners[*matches[i]].pixel, track)) continue;
    track.inverse_depth = points[i].inverse_depth;
    track.left_before = tracks_[i].left;
    ++track.age;
    followed.push_back(std::move(track));
  }
  return followed;
}

bool FeatureTracker::AcceptRight(const Eigen::Vector2d& right, FeatureTrack& track) const {
  const auto inverse_depth = geometry_.InverseDepth(track.left, right);
  if (!inverse_depth.has_value() || !stereo_.IsOnCurve(track.left, right)) return false;
  track.right = right;
  track.inverse_depth = std::max(*inverse_depth, 0.0);
  return true;
}

bool FeatureTracker::FollowInRight(const cv::Mat& image, FeatureTrack& track) const {
  if (!track.inverse_depth.has_value()) return false;
  const auto start = geometry_.Transfer(track.left, *track.inverse_depth);
  const auto found = start.has_value() ? anchors_.FindInRight(image, *start, track) : std::nullopt;
  return found.has_value() && AcceptRight(*found, track);
}

// Where a depth is known the anchor is looked for at once; else, or if it is not there, the patch
// of the left image is tracked into the right one. Without a depth only if `search`.
void FeatureTracker::MatchStereo(const Pyramids& now, bool search,
                                 std::vector<FeatureTrack>& tracks) const {
  std::vector<Eigen::Vector2d> pixels;
  std::vector<std::optional<double>> inverse_depths;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    tracks[i].right.reset();
    if (!search && !tracks[i].inverse_depth.has_value()) continue;
    if (FollowInRight(now.right[0], tracks[i])) continue;
    pixels.push_back(tracks[i].left);
    inverse_depths.push_back(tracks[i].inverse_depth);
    places.push_back(i);
  }
  const auto matches = stereo_.Match(now.left, now.right, pixels, inverse_depths);
  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (!matches[i].IsTracked()) continue;
    FeatureTrack& track = tracks[places[i]];
    const auto finer = anchors_.FindInRight(now.right[0], matches[i].pixel, track);
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
  std::vector<Eigen::Vector2d> pixels;
  pixels.reserve(tracks.size());
  for (const FeatureTrack& track : tracks) pixels.push_back(track.left);
  const auto descriptors =
      extractor_.Describe(context.now.left[0], pixels, geometry_.camera(0), context.gravity_C);
  for (std::size_t i = 0; i < tracks.size(); ++i) tracks[i].descriptor = descriptors[i];
}

// Corners away from what is tracked; without ids yet.
std::vector<FeatureTrack> FeatureTracker::NewTracks(const cv::Mat& image) const {
  std::vector<Eigen::Vector2d> occupied;
  occupied.reserve(tracks_.size());
  for (const FeatureTrack& track : tracks_) occupied.push_back(track.left);
  std::vector<FeatureTrack> fresh;
  for (const Corner& corner : detector_.Detect(image, occupied)) {
    FeatureTrack track;
    track.left = track.left_before = corner.pixel;
    if (anchors_.Anchor(image, track)) fresh.push_back(std::move(track));
  }
  return fresh;
}

void FeatureTracker::AddCorners(const Context& context, const std::optional<Pose>& T_WI) {
  std::vector<FeatureTrack> fresh = NewTracks(context.now.left[0]);
  if (config_.matching != Matching::kPatches) {
    Describe(context, fresh);
    Describe(context, tracks_);
    std::optional<Pose> pose = T_WI;
    if (!pose.has_value() && context.motion.has_value()) pose = context.motion->T_WI_now;
    if (pose.has_value()) {
      std::vector<FeatureTrack> regained = Regain(context, *pose, fresh);
      MatchStereo(context.now, false, regained);
      std::ranges::move(regained, std::back_inserter(tracks_));
    }
  }
  MatchStereo(context.now, true, fresh);
  for (FeatureTrack& track : fresh) {
    track.id = next_id_++;
    tracks_.push_back(std::move(track));
  }
  std::ranges::sort(tracks_, {}, &FeatureTrack::id);
}

// Lost points that are among the new corners; these corners are taken out.
std::vector<FeatureTrack> FeatureTracker::Regain(const Context& context, const Pose& T_WI,
                                                 std::vector<FeatureTrack>& corners) const {
  const Pose T_CW = (T_WI * geometry_.T_IC(0)).Inverse();
  std::vector<FeatureTrack> lost;
  std::vector<DescribedPoint> expected, found;
  for (FeatureTrack& track : memory_.Lost(tracks_)) {
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
    if (!anchors_.Regain(context.now.left[0], corner.left, lost[i])) continue;
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
    const double unlikeness = std::max(1.0 - track.correlation, 0.0);
    frame.points.push_back({track.id, track.left, track.right,
                            config_.sigma_px + config_.sigma_per_unlikeness_px * unlikeness});
  }
  frame.empty_quadrants = EmptyQuadrants(tracks_, geometry_.camera(0).intrinsics());
  return frame;
}

bool FeatureTracker::IsToBeDescribed(Time t) const {
  return config_.describe_every && last_described_ && !tracks_.empty() &&
         t - *last_described_ >= *config_.describe_every;
}

void FeatureTracker::ReportDescriptors(const std::vector<FeatureTrack>& tracks,
                                       TrackedFrame& frame) {
  for (std::size_t i = 0; i < frame.points.size(); ++i)
    frame.points[i].descriptor = tracks[i].descriptor;
  frame.is_described = true;
  last_described_ = frame.t;
}

}  // namespace drydock::svin2
