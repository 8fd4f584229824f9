#include "scenarios/runner/run_files.h"

#include <mujoco/mujoco.h>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "scenarios/dataset/tum.h"
#include "scenarios/report/trajectory_plot.h"
#include "scenarios/runner/version.h"
#include "scenarios/scoring/alignment.h"
#include "scenarios/scoring/json.h"
#include "sensors_models/base/check.h"
#include "sensors_models/base/files.h"

namespace drydock {
namespace {

using Json = nlohmann::ordered_json;

void WriteJson(const std::filesystem::path& path, const Json& json) {
  WriteFileAtomically(path, json.dump(2) + "\n");
}

void WritePng(const std::filesystem::path& path, const cv::Mat& image) {
  RequireInput(cv::imwrite(path.string(), image), "{}: cannot be written", path.string());
}

Json Manifest(const Scenario& scenario, const Dive& dive) {
  Json manifest;
  manifest["schema"] = 1;
  manifest["version"] = kVersion;
  manifest["commit"] = Commit();
  manifest["mujoco"] = mj_versionString();
  manifest["renderer"] = dive.RendererName();
  manifest["device"] = dive.DeviceName();
  manifest["config_hash"] = ConfigHash(scenario);
  manifest["scenario"] = EmitYaml(scenario.resolved);
  return manifest;
}

Json Timings(const RunTimings& timings) {
  const double total = timings.sensors + timings.estimator + timings.recording;
  Json json;
  json["schema"] = 1;
  json["simulated_s"] = timings.simulated;
  json["setup_s"] = timings.setup;
  json["sensors_s"] = timings.sensors;
  json["estimator_s"] = timings.estimator;
  json["recording_s"] = timings.recording;
  json["real_time_factor"] = total > 0.0 ? Json(timings.simulated / total) : Json(nullptr);
  return json;
}

std::string LoopsCsv(const std::vector<LoopClosure>& loops) {
  std::string csv =
      "#timestamp_now [ns],timestamp_then [ns],p_x [m],p_y [m],p_z [m],q_w [],q_x [],q_y [],q_z "
      "[]\n";
  for (const LoopClosure& loop : loops) {
    const Eigen::Vector3d& p = loop.T_then_now.p();
    const Eigen::Quaterniond& q = loop.T_then_now.q();
    csv += fmt::format("{},{},{},{},{},{},{},{},{}\n", loop.t_now.ns, loop.t_then.ns, p.x(), p.y(),
                       p.z(), q.w(), q.x(), q.y(), q.z());
  }
  return csv;
}

/// `trajectory` where the scorecard's alignment puts it upon the truth.
Trajectory Aligned(Trajectory trajectory, const score::Scorecard& card) {
  if (!card.alignment) return trajectory;
  for (StampedPose& pose : trajectory) pose.T_WI = *card.alignment * pose.T_WI;
  return trajectory;
}

}  // namespace

std::string ConfigHash(const Scenario& scenario) {
  std::string text = EmitYaml(scenario.resolved);
  for (const std::string& rig : {scenario.rig, scenario.estimator.rig})
    text += ReadFile(FindRig(rig));
  std::uint64_t hash = 0xcbf29ce484222325ULL;  // FNV-1a
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  return fmt::format("{:016x}", hash);
}

void WriteRunFiles(const std::filesystem::path& folder, const Scenario& scenario, const Dive& dive,
                   const RunFiles& files, const RunResult& result) {
  dataset::WriteTum(folder / "truth.tum", files.truth);
  dataset::WriteTum(folder / "odometry.tum", files.odometry);
  dataset::WriteTum(folder / "trajectory.tum", files.corrected);
  WriteFileAtomically(folder / "loops.csv", LoopsCsv(files.loops));
  std::string events;
  for (const std::string& event : files.events) events += event + "\n";
  WriteFileAtomically(folder / "events.log", events);
  WriteJson(folder / "manifest.json", Manifest(scenario, dive));
  WriteJson(folder / "timings.json", Timings(result.timings));
  WriteFileAtomically(folder / "scorecard.json", score::ToJson(result.scorecard));

  const std::string title =
      fmt::format("{}, seed {}: {}", scenario.name, scenario.seed, scenario.estimator.name);
  WritePng(folder / "trajectory.png",
           report::DrawTrajectories(
               title, files.truth,
               {{scenario.estimator.name, Aligned(files.corrected, result.scorecard)}}));
  if (!files.frames.empty())
    WritePng(folder / "frames.png", report::DrawContactSheet(title, files.frames));
}

}  // namespace drydock
