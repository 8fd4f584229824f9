#include "estimator/svin2/initialisation/visual_window.h"

#include <algorithm>
#include <set>
#include <utility>

namespace drydock::svin2 {

VisualWindow::VisualWindow(const StereoSheet& sheet, const VisualWindowConfig& config)
    : rig_(sheet), config_(config) {
  config_.ransac.min_inliers = config.min_landmarks;
}

FrameVerdict VisualWindow::Add(const TrackedFrame& frame, const Eigen::Quaterniond& turn) {
  const std::vector<StereoPoint> stereo = TriangulateFrame(frame);
  if (std::ssize(stereo) < config_.min_landmarks) return FrameVerdict::kTooFewLandmarks;
  Frame added;
  if (frames_.empty()) {
    added.tracked = frame;
  } else {
    auto located = Locate(frame, Predict(turn));
    if (!located.has_value()) return FrameVerdict::kNoPose;
    added = std::move(*located);
    const Eigen::Quaterniond seen_turn = frames_.back().T_VI.q().conjugate() * added.T_VI.q();
    if (LogSO3(turn.conjugate() * seen_turn).norm() > config_.max_turn_error_rad) {
      return FrameVerdict::kTurnDisagrees;
    }
  }
  AddLandmarks(added, stereo);
  frames_.push_back(std::move(added));
  return FrameVerdict::kAdded;
}

void VisualWindow::DropOldest() {
  frames_.pop_front();
  std::set<LandmarkId> alive;
  for (const Frame& frame : frames_) {
    for (const Seen& seen : frame.seen) alive.insert(seen.id);
  }
  std::erase_if(landmarks_, [&alive](const auto& entry) { return !alive.contains(entry.first); });
}

void VisualWindow::Clear() {
  frames_.clear();
  landmarks_.clear();
}

std::vector<VisualWindow::StereoPoint> VisualWindow::TriangulateFrame(
    const TrackedFrame& frame) const {
  std::vector<StereoPoint> points;
  for (const TrackedPoint& point : frame.points) {
    if (!point.right.has_value()) continue;
    const Triangulation found =
        Triangulate({{&rig_.camera(0), rig_.T_IC(0), point.left, point.sigma_px},
                     {&rig_.camera(1), rig_.T_IC(1), *point.right, point.sigma_px}},
                    config_.stereo);
    if (found.IsGood()) points.push_back({&point, found.p_W});
  }
  return points;
}

Pose VisualWindow::Predict(const Eigen::Quaterniond& turn) const {
  const Pose& last = frames_.back().T_VI;
  if (frames_.size() < 2) return {last.q() * turn, last.p()};
  // As fast as before.
  return {last.q() * turn, last.p() + (last.p() - frames_[frames_.size() - 2].T_VI.p())};
}

std::vector<VisualWindow::Seen> VisualWindow::KnownIn(const TrackedFrame& frame) const {
  std::vector<Seen> known;
  for (const TrackedPoint& point : frame.points) {
    if (!landmarks_.contains(point.id)) continue;
    known.push_back({point.id, 0, point.left, point.sigma_px});
    if (point.right.has_value()) known.push_back({point.id, 1, *point.right, point.sigma_px});
  }
  return known;
}

std::optional<VisualWindow::Frame> VisualWindow::Locate(const TrackedFrame& frame,
                                                        const Pose& prior) {
  const std::vector<Seen> known = KnownIn(frame);
  std::vector<LandmarkObservation> observations;
  observations.reserve(known.size());
  for (const Seen& seen : known) {
    observations.push_back({landmarks_.at(seen.id).p_V, seen.camera, seen.pixel});
  }
  const auto seed = static_cast<std::uint64_t>(frame.t.ns);
  const auto found = EstimateRigPose(rig_, observations, prior, seed, config_.ransac);
  if (!found.has_value()) return std::nullopt;
  Frame located{frame, found->T_WI, {}};
  std::set<LandmarkId> agreeing;
  for (const std::size_t index : found->inliers) {
    located.seen.push_back(known[index]);
    agreeing.insert(known[index].id);
  }
  if (std::ssize(agreeing) < config_.min_landmarks ||
      static_cast<double>(found->inliers.size()) <
          config_.min_inlier_share * static_cast<double>(known.size())) {
    return std::nullopt;
  }
  // A landmark that is wrong twice is no landmark; the front end may still track it.
  for (const Seen& seen : known) {
    if (seen.camera != 0 || agreeing.contains(seen.id)) continue;
    landmarks_.at(seen.id).misses++;
  }
  return located;
}

void VisualWindow::AddLandmarks(Frame& frame, const std::vector<StereoPoint>& points) {
  constexpr int kMaxMisses = 2;
  for (const StereoPoint& point : points) {
    const LandmarkId id = point.point->id;
    const auto known = landmarks_.find(id);
    if (known != landmarks_.end() && known->second.misses < kMaxMisses) continue;
    if (known != landmarks_.end()) {
      for (Frame& older : frames_)
        std::erase_if(older.seen, [id](const Seen& s) { return s.id == id; });
      std::erase_if(frame.seen, [id](const Seen& s) { return s.id == id; });
    }
    landmarks_[id] = {frame.T_VI * point.p_I, 0};
    frame.seen.push_back({id, 0, point.point->left, point.point->sigma_px});
    frame.seen.push_back({id, 1, *point.point->right, point.point->sigma_px});
  }
}

std::vector<LandmarkId> VisualWindow::ChooseLandmarks() const {
  std::map<LandmarkId, int> frames_of;
  for (const Frame& frame : frames_) {
    std::set<LandmarkId> here;
    for (const Seen& seen : frame.seen) here.insert(seen.id);
    for (const LandmarkId id : here) frames_of[id]++;
  }
  std::vector<std::pair<int, LandmarkId>> order;
  for (const auto& [id, count] : frames_of) {
    if (count >= 2) order.emplace_back(-count, id);
  }
  std::sort(order.begin(), order.end());
  if (std::ssize(order) > config_.max_adjusted_landmarks) {
    order.resize(config_.max_adjusted_landmarks);
  }
  std::vector<LandmarkId> chosen;
  chosen.reserve(order.size());
  for (const auto& [count, id] : order) chosen.push_back(id);
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

std::optional<VisualMotion> VisualWindow::Adjust() {
  const std::vector<LandmarkId> chosen = ChooseLandmarks();
  Bundle bundle;
  std::map<LandmarkId, int> index_of;
  for (const LandmarkId id : chosen) {
    index_of[id] = static_cast<int>(bundle.landmarks.size());
    bundle.landmarks.push_back(landmarks_.at(id).p_V);
  }
  for (int k = 0; k < Size(); ++k) {
    bundle.T_VI.push_back(frames_[k].T_VI);
    for (const Seen& seen : frames_[k].seen) {
      const auto index = index_of.find(seen.id);
      if (index == index_of.end()) continue;
      bundle.observations.push_back({index->second, k, seen.camera, seen.pixel, seen.sigma_px});
    }
  }
  std::stable_sort(bundle.observations.begin(), bundle.observations.end(),
                   [](const auto& a, const auto& b) { return a.landmark < b.landmark; });
  const auto adjusted = AdjustBundle(rig_, bundle, config_.adjustment_iterations);
  if (!adjusted.has_value()) return std::nullopt;
  VisualMotion motion;
  for (int k = 0; k < Size(); ++k) {
    frames_[k].T_VI = adjusted->T_VI[k];
    motion.t.push_back(frames_[k].tracked.t);
  }
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    landmarks_.at(chosen[i]).p_V = adjusted->landmarks[i];
  }
  motion.T_VI = adjusted->T_VI;
  motion.information = adjusted->information;
  motion.mean_chi2 = adjusted->mean_chi2;
  return motion;
}

}  // namespace drydock::svin2
