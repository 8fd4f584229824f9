#include "scenarios/compare/finished.h"

#include <nlohmann/json.hpp>

#include "scenarios/results/stages_json.h"
#include "scenarios/scoring/json.h"
#include "sensors_models/base/files.h"

namespace drydock::compare {
namespace {

using Json = nlohmann::ordered_json;

score::Scorecard ReadScorecard(const Json& json) {
  score::Scorecard card;
  card.run.scenario = json.at("scenario");
  card.run.seed = json.at("seed");
  card.run.estimator = json.at("estimator");
  card.run.renderer = json.at("renderer");
  card.run.commit = json.at("commit");
  card.run.config_hash = json.at("config_hash");
  card.path_length_m = json.at("path_length_m");
  card.duration_s = json.at("duration_s");
  for (const score::MetricInfo& info : score::AllMetrics()) {
    const Json& value = json.at("metrics").at(info.name);
    if (!value.is_null()) card.metrics.*info.value = value.get<double>();
  }
  return card;
}

}  // namespace

std::optional<Finished> FinishedCases::Find(const std::string& hash) const {
  if (!std::filesystem::is_regular_file(FileOf(hash))) return std::nullopt;
  try {
    const Json json = Json::parse(ReadFile(FileOf(hash)));
    Finished finished{
        ReadScorecard(json.at("scorecard")), json.at("estimator_s"), json.at("stereo_frames"), {}};
    for (const auto& [name, stage] : json.at("estimator_stages").items()) {
      finished.stages.push_back({name, stage.at("count"), stage.at("total_s"),
                                 stage.at("median_ms"), stage.at("p99_ms")});
    }
    return finished;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;  // Of another version, or somebody's own: simulated again.
  }
}

void FinishedCases::Keep(const std::string& hash, const Finished& finished) const {
  Json json;
  json["schema"] = 1;
  json["scorecard"] = Json::parse(score::ToJson(finished.scorecard));
  json["estimator_s"] = finished.estimator_s;
  json["stereo_frames"] = finished.stereo_frames;
  json["estimator_stages"] = StagesJson(finished.stages);
  WriteFileAtomically(FileOf(hash), json.dump(2) + "\n");
}

}  // namespace drydock::compare
