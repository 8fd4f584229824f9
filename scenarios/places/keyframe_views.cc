#include "scenarios/places/keyframe_views.h"

#include <optional>
#include <utility>
#include <variant>

#include "scenarios/dataset/euroc_reader.h"
#include "sensors_models/base/check.h"
#include "sensors_models/base/trajectory.h"

namespace drydock {
namespace {

std::vector<svin2::Descriptor> DescriptorsOf(const svin2::TrackedFrame& frame) {
  std::vector<svin2::Descriptor> descriptors;
  for (const svin2::TrackedPoint& point : frame.points) {
    if (point.descriptor.has_value()) descriptors.push_back(*point.descriptor);
  }
  return descriptors;
}

}  // namespace

std::vector<KeyframeView> ViewKeyframes(const std::filesystem::path& recording,
                                        const svin2::FeatureTracker::Config& config) {
  const dataset::EurocReader reader(recording);
  const Trajectory truth = dataset::ToTrajectory(reader.ReadTruth());
  svin2::FeatureTracker tracker(config, reader.rig().stereo);
  std::vector<KeyframeView> views;
  std::optional<Pose> before;
  for (std::size_t i = 0; i < reader.size(); ++i) {
    const Measurement measurement = reader.Read(i);
    const auto* images = std::get_if<StereoFrame>(&measurement.reading);
    const auto T_WI = images == nullptr ? std::nullopt : Interpolate(truth, measurement.t);
    if (!T_WI.has_value()) continue;
    const svin2::MotionPrediction motion{before.value_or(*T_WI), *T_WI};
    const svin2::TrackedFrame frame = tracker.Track(measurement.t, *images, motion, {});
    before = *T_WI;
    if (frame.is_keyframe) views.push_back({measurement.t, *T_WI, DescriptorsOf(frame)});
  }
  RequireInput(!views.empty(), "{}: no frame with a true pose makes a keyframe",
               recording.string());
  return views;
}

}  // namespace drydock
