#include "scenarios/runner/run.h"

#include <memory>
#include <optional>

#include "scenarios/results/estimator_session.h"
#include "scenarios/results/stopwatch.h"
#include "scenarios/runner/dive.h"
#include "scenarios/runner/dive_recorder.h"
#include "scenarios/runner/run_files.h"
#include "scenarios/runner/score_dive.h"
#include "scenarios/runner/start_estimator.h"
#include "sensors_models/base/files.h"

namespace drydock {
namespace {

constexpr std::size_t kSheetFrames = 8;

std::unique_ptr<Dive> StartDive(const Scenario& scenario, const RunOptions& options,
                                RunTimings& timings) {
  const Stopwatch watch(timings.setup);
  auto dive = std::make_unique<Dive>(scenario, options.renderer);
  timings.simulated = dive->End().Seconds();
  return dive;
}

/// Keeps `count` stereo frames that are spread evenly over the dive.
class FrameSampler {
 public:
  FrameSampler(const Dive& dive, std::size_t count) {
    const auto frames =
        static_cast<std::size_t>(dive.End().Seconds() * dive.rig().stereo.rate_hz) + 1;
    wanted_ = report::SpreadEvenly(frames, count);
  }

  void Look(const Measurement& measurement) {
    const auto* frame = std::get_if<StereoFrame>(&measurement.reading);
    if (frame == nullptr || frames_.size() == wanted_.size()) return;
    if (static_cast<std::size_t>(frame->index) >= wanted_[frames_.size()]) {
      frames_.push_back({measurement.t, frame->images});
    }
  }

  std::vector<report::SheetFrame> Take() { return std::move(frames_); }

 private:
  std::vector<std::size_t> wanted_;
  std::vector<report::SheetFrame> frames_;
};

}  // namespace

RunResult RunScenario(const Scenario& asked, const RunOptions& options) {
  const Scenario scenario = options.realtime ? WithEstimatorOnRobot(asked) : asked;
  RunResult result;
  RunTimings& timings = result.timings;
  RequireReplaceable(options.output, {"manifest.json"});
  AtomicDirectory output(options.output);
  const std::unique_ptr<Dive> dive = StartDive(scenario, options, timings);
  EstimatorSession session(StartEstimator(scenario, dive->InitialState()), Time{},
                           options.realtime);
  std::optional<DiveRecorder> recorder;
  if (options.record) recorder.emplace(*dive, output.path() / "dataset");
  FrameSampler sampler(*dive, kSheetFrames);

  while (true) {
    std::optional<sim::Observation> observation;
    {
      const Stopwatch watch(timings.sensors);
      observation = dive->Next();
    }
    if (!observation) break;
    const Measurement& measurement = observation->measurement;
    session.Add(measurement);
    sampler.Look(measurement);
    if (recorder) {
      const Stopwatch watch(timings.recording);
      recorder->Add(*observation);
    }
    options.progress(measurement.t_arrival, dive->End());
  }

  const RunFiles files{dive->Truth(), session.Finish(), sampler.Take()};
  timings.estimator = session.seconds();
  result.realtime = files.results.realtime;
  result.scorecard = ScoreDive(scenario, *dive, files.truth, files.results);
  WriteRunFiles(output.path(), scenario, *dive, files, result);
  if (recorder) recorder->Commit();
  output.Commit(AtomicDirectory::IfExists::kReplace);
  return result;
}

RunTimings RecordScenario(const Scenario& scenario, const RunOptions& options) {
  RunTimings timings;
  RequireReplaceable(options.output, {"mav0"});
  const std::unique_ptr<Dive> dive = StartDive(scenario, options, timings);
  DiveRecorder recorder(*dive, options.output);
  while (true) {
    std::optional<sim::Observation> observation;
    {
      const Stopwatch watch(timings.sensors);
      observation = dive->Next();
    }
    if (!observation) break;
    const Stopwatch watch(timings.recording);
    recorder.Add(*observation);
    options.progress(observation->measurement.t_arrival, dive->End());
  }
  recorder.Commit();
  return timings;
}

}  // namespace drydock
