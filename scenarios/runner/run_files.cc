#include "scenarios/runner/run_files.h"

#include <mujoco/mujoco.h>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "scenarios/results/realtime_json.h"
#include "scenarios/results/stages_json.h"
#include "scenarios/version/version.h"
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

Json Manifest(const Scenario& scenario, const Dive& dive, const Results& results) {
  Json manifest;
  manifest["schema"] = 1;
  manifest["version"] = kVersion;
  manifest["commit"] = Commit();
  manifest["mujoco"] = mj_versionString();
  manifest["renderer"] = dive.RendererName();
  manifest["device"] = dive.DeviceName();
  manifest["config_hash"] = ConfigHash(scenario);
  NoteRealtime(results.realtime, manifest);
  manifest["scenario"] = EmitYaml(scenario.resolved);
  return manifest;
}

Json Timings(const RunTimings& timings, const Results& results) {
  const double total = timings.sensors + timings.estimator + timings.recording;
  Json json;
  json["schema"] = 1;
  json["simulated_s"] = timings.simulated;
  json["setup_s"] = timings.setup;
  json["sensors_s"] = timings.sensors;
  json["estimator_s"] = timings.estimator;
  json["recording_s"] = timings.recording;
  json["real_time_factor"] = total > 0.0 ? Json(timings.simulated / total) : Json(nullptr);
  if (results.realtime) json["realtime"] = RealtimeJson(*results.realtime);
  json["estimator_stages"] = StagesJson(results.stages);
  return json;
}

}  // namespace

std::string ConfigHash(const Scenario& scenario) {
  std::string text = EmitYaml(scenario.resolved);
  for (const std::string& rig : {scenario.rig, scenario.estimator.rig})
    text += ReadFile(FindRig(rig));
  return HashText(text);
}

void WriteRunFiles(const std::filesystem::path& folder, const Scenario& scenario, const Dive& dive,
                   const RunFiles& files, const RunResult& result) {
  WriteResults(folder, files.results);
  WriteJson(folder / "manifest.json", Manifest(scenario, dive, files.results));
  WriteJson(folder / "timings.json", Timings(result.timings, files.results));
  const std::string title =
      fmt::format("{}, seed {}: {}", scenario.name, scenario.seed, scenario.estimator.name);
  WriteScore(folder, title, files.truth, files.results.corrected, result.scorecard);
  if (!files.frames.empty())
    WritePng(folder / "frames.png", report::DrawContactSheet(title, files.frames));
}

}  // namespace drydock
