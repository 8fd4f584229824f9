#include "scenarios/runner/dive_recorder.h"

namespace drydock {

DiveRecorder::DiveRecorder(const Dive& dive, const std::filesystem::path& target)
    : dive_(dive), writer_(dive.rig(), target) {}

void DiveRecorder::Add(const sim::Observation& observation) {
  writer_.Add(observation.measurement);
  std::visit([&](const auto& truth) { AddTruth(observation.measurement.t, truth); },
             observation.truth);
}

void DiveRecorder::AddTruth(Time t, const sim::ImuTruth& truth) {
  const sim::MotionState state = dive_.motion().At(t);
  writer_.AddTruth(t, {state.T_WI, state.v_W, truth.gyro_bias, truth.accel_bias});
}

void DiveRecorder::AddTruth(Time t, const sim::SonarTruth& truth) {
  writer_.AddSonarTruth(t, truth.range, truth.body);
}

void DiveRecorder::AddTruth(Time t, const sim::StereoTruth& truth) {
  for (std::size_t eye = 0; eye < truth.depth.size(); ++eye) {
    if (!truth.depth[eye].empty()) writer_.AddDepthImage(eye, t, truth.depth[eye]);
  }
}

}  // namespace drydock
