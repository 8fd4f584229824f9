#include "scenarios/scoring/json.h"

#include <numbers>
#include <optional>

#include <nlohmann/json.hpp>

namespace drydock::score {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kDegrees = 180.0 / std::numbers::pi;

Json Number(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json MetricsJson(const Metrics& metrics) {
  Json json = Json::object();
  for (const MetricInfo& info : AllMetrics()) {
    json[std::string(info.name)] = Number(metrics.*info.value);
  }
  return json;
}

/// x_truth = scale * R(rotation_xyzw) * x_estimate + translation_m.
Json AlignmentJson(std::string_view method, const std::optional<Similarity>& similarity) {
  Json json = {{"method", method}};
  if (!similarity) {
    for (const char* key : {"scale", "rotation_xyzw", "translation_m"}) json[key] = nullptr;
    return json;
  }
  const auto& q = similarity->rigid.q();
  const auto& p = similarity->rigid.p();
  // q and -q are the same rotation; w >= 0 is written.
  const double sign = q.w() < 0.0 ? -1.0 : 1.0;
  json["scale"] = similarity->scale;
  json["rotation_xyzw"] = {sign * q.x(), sign * q.y(), sign * q.z(), sign * q.w()};
  json["translation_m"] = {p.x(), p.y(), p.z()};
  return json;
}

Json StatisticsJson(const std::optional<Statistics>& statistics, double unit) {
  if (!statistics) return nullptr;
  const Statistics& s = *statistics;
  return {{"count", s.count},
          {"rmse", s.rmse * unit},
          {"mean", s.mean * unit},
          {"median", s.median * unit},
          {"std", s.standard_deviation * unit},
          {"min", s.min * unit},
          {"max", s.max * unit},
          {"sse", s.sse * unit * unit}};
}

Json CriterionJson(const CriterionResult& result) {
  Json bound = Json::object();
  if (result.criterion.min) bound["min"] = *result.criterion.min;
  if (result.criterion.max) bound["max"] = *result.criterion.max;
  return {{"name", result.criterion.metric},
          {"actual", Number(result.actual)},
          {"bound", bound},
          {"unit", result.unit},
          {"passed", result.passed}};
}

std::string Text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace

std::string ToJson(const Scorecard& card) {
  Json json;
  json["schema"] = 1;
  json["scenario"] = card.run.scenario;
  json["seed"] = card.run.seed;
  json["estimator"] = card.run.estimator;
  json["renderer"] = card.run.renderer;
  json["commit"] = card.run.commit;
  json["config_hash"] = card.run.config_hash;
  json["path_length_m"] = card.path_length_m;
  json["duration_s"] = card.duration_s;
  json["metrics"] = MetricsJson(card.metrics);
  json["alignment"] = AlignmentJson(ToString(Alignment::kSe3), card.alignment);
  json["criteria"] = Json::array();
  for (const CriterionResult& result : card.criteria) {
    json["criteria"].push_back(CriterionJson(result));
  }
  json["verdict"] = card.Passed() ? "pass" : "fail";
  return Text(json);
}

std::string ToJson(const TrajectoryScore& score) {
  const Association& association = score.association;
  const bool nearest = score.association_options.mode == AssociationMode::kNearest;
  Json json;
  json["schema"] = 1;
  json["path_length_m"] = score.path_length_m;
  json["duration_s"] = score.duration_s;
  json["metrics"] = MetricsJson(score.metrics);
  json["alignment"] = AlignmentJson(ToString(score.alignment), score.transform);
  json["association"] = {
      {"mode", nearest ? "nearest" : "interpolate"},
      {"max_difference_s",
       nearest ? Json(score.association_options.max_difference_s) : Json(nullptr)},
      {"truth_poses", association.truth_poses},
      {"estimate_poses", association.estimate_poses},
      {"pairs", association.pairs.size()},
      {"dropped_outside", association.dropped_outside},
      {"dropped_in_gap", association.dropped_in_gap}};
  json["ape_translation_m"] = StatisticsJson(score.ape_translation, 1.0);
  json["ape_rotation_deg"] = StatisticsJson(score.ape_rotation, kDegrees);
  json["rpe_5m_translation_m"] = StatisticsJson(score.rpe_translation, 1.0);
  json["rpe_5m_rotation_deg"] = StatisticsJson(score.rpe_rotation, kDegrees);
  return Text(json);
}

}  // namespace drydock::score
