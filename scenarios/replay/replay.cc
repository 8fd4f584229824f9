#include "scenarios/replay/replay.h"

#include <memory>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "estimator/registry/registry.h"
#include "scenarios/dataset/euroc_layout.h"
#include "scenarios/dataset/euroc_reader.h"
#include "scenarios/dataset/rig_yaml.h"
#include "scenarios/results/dense_truth.h"
#include "scenarios/results/estimator_session.h"
#include "scenarios/results/realtime_json.h"
#include "scenarios/results/result_files.h"
#include "scenarios/results/stages_json.h"
#include "scenarios/results/stopwatch.h"
#include "scenarios/version/version.h"
#include "sensors_models/base/check.h"
#include "sensors_models/base/files.h"
#include "sensors_models/models/usable_rig.h"

namespace drydock {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

/// What reports call a recording: the folder that holds mav0.
std::string NameOf(const fs::path& recording) {
  fs::path folder = fs::absolute(recording).lexically_normal();
  if (!folder.has_filename()) folder = folder.parent_path();
  if (folder.filename() == dataset::kRoot) folder = folder.parent_path();
  return folder.filename().string();
}

/// One replay from its inputs to its files.
class Player {
 public:
  Player(const fs::path& recording, const ReplayOptions& options)
      : recording_(recording), options_(options) {
    if (options.realtime)
      options_.options = OnRobot(FindEstimator(options.estimator), options.options);
    const Stopwatch watch(result_.timings.reading);
    reader_ = std::make_unique<dataset::EurocReader>(recording, options.warn);
    truth_ = reader_->ReadTruth();
    rig_ = options.rig.empty() ? OwnRig() : LoadUsableRig(FindRig(options.rig));
  }

  ReplayResult Play() {
    RequireInput(reader_->HasImuSamples(), "{}: no samples: every estimator needs them",
                 reader_->FileName("imu0/data.csv"));
    RequireOutputElsewhere();
    RequireReplaceable(options_.output, {"manifest.json"});
    std::unique_ptr<Estimator> estimator =
        FindEstimator(options_.estimator).make(rig_, options_.options);
    Start(*estimator);
    AtomicDirectory output(options_.output);
    const Results results = Feed(std::move(estimator));
    result_.poses = results.odometry.size();
    WriteResults(output.path(), results);
    WriteFileAtomically(output.path() / "manifest.json", Manifest(results).dump(2) + "\n");
    WriteFileAtomically(output.path() / "timings.json", Timings(results).dump(2) + "\n");
    if (!truth_.empty()) Score(output.path(), results);
    output.Commit(AtomicDirectory::IfExists::kReplace);
    return std::move(result_);
  }

 private:
  /// The output replaces what is there: it must not be the recording, nor hold it.
  void RequireOutputElsewhere() const {
    const fs::path from = fs::weakly_canonical(recording_);
    const fs::path to = fs::weakly_canonical(options_.output);
    for (fs::path part = from;; part = part.parent_path()) {
      RequireInput(part != to, "{}: holds the recording, which the results would replace",
                   options_.output.string());
      if (part == part.parent_path()) return;
    }
  }

  /// The rig of the recording, if it can be computed with.
  Rig OwnRig() const {
    std::size_t i = 0;
    for (const char* camera : dataset::kCameraFolders) {
      const std::string sheet = fmt::format("{}/{}", camera, dataset::kSensorFile);
      RequireUsable(reader_->rig().stereo.cameras[i++], reader_->FileName(sheet));
    }
    return reader_->rig();
  }

  void Start(Estimator& estimator) const {
    if (options_.start_from_truth) {
      estimator.Start(KnownStart());
      return;
    }
    try {
      estimator.Start(std::nullopt);
    } catch (const InputError& error) {
      throw InputError(fmt::format(
          "{}; --start-from-truth tells it, where the recording has ground truth", error.what()));
    }
  }

  NavState KnownStart() const {
    RequireInput(!truth_.empty(), "{}: the recording has no ground truth to start from",
                 recording_.string());
    const auto& [t, state, pose_only] = truth_.front();
    RequireInput(!pose_only,
                 "{}: the ground truth has poses alone: a start needs velocity and biases too",
                 recording_.string());
    RequireInput(t <= reader_->ArrivalOf(reader_->size() - 1),
                 "{}: the ground truth begins after the last measurement", recording_.string());
    return {t, state.T_WI, state.v_W, state.gyro_bias, state.accel_bias};
  }

  Measurement Read(std::size_t i) {
    const Stopwatch watch(result_.timings.reading);
    return reader_->Read(i);
  }

  Results Feed(std::unique_ptr<Estimator> estimator) {
    const Time start = reader_->ArrivalOf(0);
    const Duration length = reader_->ArrivalOf(reader_->size() - 1) - start;
    result_.timings.recorded = length.Seconds();
    EstimatorSession session(std::move(estimator), start, options_.realtime);
    for (std::size_t i = 0; i < reader_->size(); ++i) {
      const Measurement measurement = Read(i);
      session.Add(measurement);
      ++result_.measurements;
      options_.progress(Time{} + (measurement.t_arrival - start), Time{} + length);
    }
    Results results = session.Finish();
    result_.timings.estimator = session.seconds();
    result_.realtime = results.realtime;
    return results;
  }

  void Score(const fs::path& folder, const Results& results) {
    score::RunInfo info;
    info.scenario = NameOf(recording_);
    info.estimator = options_.estimator;
    info.renderer = "none";
    info.commit = Commit();
    info.config_hash = ConfigHash();
    const Trajectory truth = TruthToScoreBy(results);
    info.known = KnownMetrics(truth, results);
    result_.scorecard = score::Score(info, truth, results.odometry, results.corrected, {});
    WriteScore(folder, fmt::format("{}: {}", info.scenario, info.estimator), truth,
               results.corrected, *result_.scorecard);
  }

  /// A run has the truth at each frame; so has, nearly, its recording.
  Trajectory TruthToScoreBy(const Results& results) const {
    const Trajectory recorded = dataset::ToTrajectory(truth_);
    return AddInterpolated(AddInterpolated(recorded, results.odometry), results.corrected);
  }

  std::string ConfigHash() const {
    return HashText(fmt::format("{} {}\n{}\n{}", options_.estimator, options_.start_from_truth,
                                EmitYaml(options_.options), dataset::FormatRig(rig_)));
  }

  Json Manifest(const Results& results) const {
    Json manifest;
    manifest["schema"] = 1;
    manifest["version"] = kVersion;
    manifest["commit"] = Commit();
    manifest["config_hash"] = ConfigHash();
    NoteRealtime(results.realtime, manifest);
    manifest["recording"] = recording_.string();
    manifest["estimator"] = options_.estimator;
    manifest["start_from_truth"] = options_.start_from_truth;
    manifest["options"] = EmitYaml(options_.options);
    manifest["rig"] = dataset::FormatRig(rig_);
    return manifest;
  }

  Json Timings(const Results& results) const {
    const ReplayTimings& timings = result_.timings;
    const double total = timings.reading + timings.estimator;
    Json json;
    json["schema"] = 1;
    json["recorded_s"] = timings.recorded;
    json["reading_s"] = timings.reading;
    json["estimator_s"] = timings.estimator;
    json["real_time_factor"] = total > 0.0 ? Json(timings.recorded / total) : Json(nullptr);
    if (results.realtime) json["realtime"] = RealtimeJson(*results.realtime);
    json["estimator_stages"] = StagesJson(results.stages);
    return json;
  }

  const fs::path recording_;
  ReplayOptions options_;
  std::unique_ptr<dataset::EurocReader> reader_;
  std::vector<dataset::StampedTruth> truth_;
  Rig rig_;
  ReplayResult result_;
};

}  // namespace

ReplayResult Replay(const fs::path& recording, const ReplayOptions& options) {
  return Player(recording, options).Play();
}

}  // namespace drydock
