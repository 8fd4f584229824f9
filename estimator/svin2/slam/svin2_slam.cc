#include "estimator/svin2/slam/svin2_slam.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "estimator/svin2/pose_graph/trajectory_correction.h"

namespace drydock::svin2 {
namespace {

/// In haze keyframes are seconds apart, and a place is passed in less.
constexpr Duration kLookAroundEvery{700'000'000};

Svin2Config WithKeyframes(Svin2Config config) {
  config.report_keyframes = true;
  config.frontend.describe_every = kLookAroundEvery;
  return config;
}

/// Moves each point as the body was moved that saw it.
class MapCorrection {
 public:
  MapCorrection(const Trajectory& odometry, const Trajectory& corrected)
      : odometry_(odometry), corrected_(corrected) {}

  std::vector<Eigen::Vector3d> Correct(const std::vector<TimedPoint>& points) const {
    std::vector<Eigen::Vector3d> moved;
    moved.reserve(points.size());
    for (const TimedPoint& point : points) {
      // Both trajectories have the same times.
      const auto at = std::ranges::lower_bound(odometry_, point.t, {}, &StampedPose::t);
      if (at == odometry_.end()) continue;
      const Pose& T_GI = corrected_[static_cast<std::size_t>(at - odometry_.begin())].T_WI;
      moved.push_back(T_GI * (at->T_WI.Inverse() * point.p_W));
    }
    return moved;
  }

 private:
  const Trajectory& odometry_;
  const Trajectory& corrected_;
};

}  // namespace

Svin2Slam::Svin2Slam(const Rig& rig, const Svin2Config& odometry, const LoopCloserConfig& loops)
    : odometry_(MakeSvin2(rig, WithKeyframes(odometry))),
      loops_(loops, rig.stereo,
             std::make_shared<const Vocabulary>(Vocabulary::Load(Vocabulary::DefaultPath())),
             &worker_) {}

void Svin2Slam::Add(const Measurement& measurement) {
  odometry_->Add(measurement);
  CloseLoops();
}

void Svin2Slam::Finish() {
  odometry_->Finish();
  CloseLoops();
  loops_.Finish();
}

void Svin2Slam::CloseLoops() {
  for (Keyframe& keyframe : odometry_->TakeKeyframes()) loops_.Add(std::move(keyframe));
}

std::optional<NavEstimate> Svin2Slam::Latest() const {
  std::optional<NavEstimate> latest = odometry_->Latest();
  if (latest && !loops_.graph().nodes().empty()) latest->T_GW = loops_.graph().T_GW();
  return latest;
}

Trajectory Svin2Slam::Corrected() const {
  return svin2::Corrected(loops_.graph(), odometry_->Odometry(), odometry_->PositionSigmas());
}

EstimatedMap Svin2Slam::Map() const {
  const Trajectory corrected = Corrected();
  const MapCorrection correction(odometry_->Odometry(), corrected);
  return {correction.Correct(odometry_->Landmarks()), correction.Correct(odometry_->Echoes())};
}

std::vector<EstimatorEvent> Svin2Slam::TakeEvents() {
  std::vector<EstimatorEvent> events = odometry_->TakeEvents();
  std::ranges::move(loops_.TakeEvents(), std::back_inserter(events));
  return events;
}

EstimatorTimings Svin2Slam::Timings() const {
  EstimatorTimings timings = odometry_->Timings();
  std::ranges::move(loops_.Timings(), std::back_inserter(timings));
  return timings;
}

std::unique_ptr<Estimator> MakeSvin2Slam(const Rig& rig, const YamlNode& options) {
  LoopCloserConfig loops;
  const Svin2Config odometry = ReadYaml(options, [&](YamlReader& reader) {
    reader.OptionalMap("loops", [&](YamlReader& map) { loops = ReadLoopCloserConfig(map); });
    return ReadSvin2Config(reader, Svin2Config{});
  });
  return std::make_unique<Svin2Slam>(rig, odometry, loops);
}

}  // namespace drydock::svin2
