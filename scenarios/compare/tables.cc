#include "scenarios/compare/tables.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "scenarios/results/stages_json.h"
#include "scenarios/version/version.h"

namespace drydock::compare {
namespace {

using Json = nlohmann::ordered_json;
using Row = std::vector<std::string>;

/// What people look at first; the JSON has everything.
constexpr const char* kColumns[] = {
    "ate_percent",    "ate_rmse_m",          "scale_error_percent",
    "rpe_5m_percent", "final_drift_percent", "yaw_error_deg",
    "z_rmse_m",       "continuity_percent",  "init_time_s",
    "anees_position", "anees_orientation",   "loops_found",
    "loop_precision", "loop_recall",
};

/// Characters that a terminal shows of UTF-8 text.
std::size_t Width(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
  }));
}

std::string Table(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], Width(row[i]));
  }
  std::string text;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (std::size_t i = 0; i < widths.size(); ++i) {
      text += "| " + rows[r][i] + std::string(widths[i] - Width(rows[r][i]) + 1, ' ');
    }
    text += "|\n";
    if (r > 0) continue;
    for (const std::size_t width : widths) text += "|" + std::string(width + 2, '-');
    text += "|\n";
  }
  return text;
}

/// Four significant digits, without an exponent where people would not write one.
std::string Figure(double value) {
  const double size = std::abs(value);
  if (size != 0.0 && (size < 1e-4 || size >= 1e5)) return fmt::format("{:.2e}", value);
  const int digits = size >= 1000 ? 0 : size >= 100 ? 1 : size >= 10 ? 2 : size >= 1 ? 3 : 4;
  return fmt::format("{:.{}f}", value, digits);
}

std::string Cell(const SeedValues& values) {
  const auto median = Summarize(Statistic::kMedian, values);
  if (!median) return "–";
  std::string cell = Figure(*median);
  if (values.size() > 1) {
    cell += fmt::format(" ({} … {})", Figure(*Summarize(Statistic::kMin, values)),
                        Figure(*Summarize(Statistic::kMax, values)));
  }
  const auto present = std::count_if(values.begin(), values.end(),
                                     [](const auto& value) { return value.has_value(); });
  if (static_cast<std::size_t>(present) < values.size())
    cell += fmt::format(" [{} of {}]", present, values.size());
  return cell;
}

bool AnyoneHas(const CaseOutcome& outcome, const score::MetricInfo& metric) {
  return std::any_of(outcome.finished.begin(), outcome.finished.end(), [&](const auto& finished) {
    return Summarize(Statistic::kMin, ValuesOf(finished, metric)).has_value();
  });
}

std::string CaseTable(const Suite& suite, const CaseOutcome& outcome) {
  std::vector<Row> rows(1 + suite.entrants.size());
  rows[0].emplace_back("estimator");
  for (std::size_t i = 0; i < suite.entrants.size(); ++i)
    rows[1 + i].push_back(suite.entrants[i].label);
  for (const char* column : kColumns) {
    const score::MetricInfo& metric = *score::FindMetric(column);
    if (!AnyoneHas(outcome, metric)) continue;
    rows[0].emplace_back(metric.name);
    for (std::size_t i = 0; i < outcome.finished.size(); ++i)
      rows[1 + i].push_back(Cell(ValuesOf(outcome.finished[i], metric)));
  }
  return Table(rows);
}

std::string CriteriaTable(const std::vector<CriterionOutcome>& criteria) {
  std::vector<Row> rows = {{"case", "estimator", "criterion", "bound", "actual", ""}};
  for (const auto& [suite_criterion, unit, actual, passed] : criteria) {
    const score::Criterion& criterion = suite_criterion.criterion;
    rows.push_back({suite_criterion.case_name, suite_criterion.label,
                    fmt::format("{} {}", ToString(suite_criterion.statistic), criterion.metric),
                    score::DescribeBound(criterion), actual ? Figure(*actual) : "–",
                    passed ? "met" : "MISSED"});
  }
  return Table(rows);
}

Json Number(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json MetricsJson(const std::vector<Finished>& finished) {
  Json metrics = Json::object();
  for (const score::MetricInfo& metric : score::AllMetrics()) {
    const SeedValues values = ValuesOf(finished, metric);
    Json json;
    for (const Statistic statistic :
         {Statistic::kMedian, Statistic::kMean, Statistic::kMin, Statistic::kMax})
      json[std::string(ToString(statistic))] = Number(Summarize(statistic, values));
    json["values"] = Json::array();
    for (const auto& value : values) json["values"].push_back(Number(value));
    metrics[std::string(metric.name)] = json;
  }
  return metrics;
}

Json CaseJson(const Suite& suite, std::size_t index, const CaseOutcome& outcome) {
  Json json;
  json["name"] = outcome.name;
  json["scenario"] = suite.cases[index].scenario.filename().string();
  json["set"] = EmitYaml(suite.cases[index].set);
  json["seeds"] = outcome.seeds;
  json["estimators"] = Json::array();
  for (std::size_t i = 0; i < suite.entrants.size(); ++i) {
    json["estimators"].push_back(
        {{"label", suite.entrants[i].label}, {"metrics", MetricsJson(outcome.finished[i])}});
  }
  return json;
}

Json CriterionJson(const CriterionOutcome& outcome) {
  Json bound = Json::object();
  if (outcome.criterion.criterion.min) bound["min"] = *outcome.criterion.criterion.min;
  if (outcome.criterion.criterion.max) bound["max"] = *outcome.criterion.criterion.max;
  return {{"case", outcome.criterion.case_name},
          {"estimator", outcome.criterion.label},
          {"name", outcome.criterion.criterion.metric},
          {"statistic", ToString(outcome.criterion.statistic)},
          {"actual", Number(outcome.actual)},
          {"bound", bound},
          {"unit", outcome.unit},
          {"passed", outcome.passed}};
}

std::optional<double> MillisecondsPerFrame(const Finished& finished) {
  if (finished.stereo_frames == 0) return std::nullopt;
  return 1e3 * finished.estimator_s / static_cast<double>(finished.stereo_frames);
}

}  // namespace

std::string ToMarkdown(const Comparison& comparison) {
  std::string text = fmt::format("# {}\n\n{}\n", comparison.suite.name, comparison.suite.summary);
  for (const CaseOutcome& outcome : comparison.cases) {
    const Finished& any = outcome.finished.front().front();
    text += fmt::format("\n## {}\n{} seeds, {:.1f} m in {:.1f} s. Median (least … largest).\n\n",
                        outcome.name, outcome.seeds.size(), any.scorecard.path_length_m,
                        any.scorecard.duration_s);
    text += CaseTable(comparison.suite, outcome);
  }
  if (!comparison.criteria.empty()) text += "\n## Criteria\n" + CriteriaTable(comparison.criteria);
  return text;
}

std::string ToJson(const Comparison& comparison) {
  const Suite& suite = comparison.suite;
  Json json;
  json["schema"] = 1;
  json["suite"] = suite.name;
  json["summary"] = suite.summary;
  json["commit"] = Commit();
  json["renderer"] = comparison.cases.front().finished.front().front().scorecard.run.renderer;
  json["estimators"] = Json::array();
  for (const Entrant& entrant : suite.entrants) {
    json["estimators"].push_back(
        {{"label", entrant.label}, {"estimator", EmitYaml(entrant.estimator)}});
  }
  json["cases"] = Json::array();
  for (std::size_t i = 0; i < comparison.cases.size(); ++i)
    json["cases"].push_back(CaseJson(suite, i, comparison.cases[i]));
  json["criteria"] = Json::array();
  for (const CriterionOutcome& outcome : comparison.criteria)
    json["criteria"].push_back(CriterionJson(outcome));
  json["verdict"] = comparison.Passed() ? "passed" : "failed";
  return json.dump(2) + "\n";
}

std::string CostsToJson(const Comparison& comparison) {
  Json json;
  json["schema"] = 1;
  json["cases"] = Json::array();
  for (const CaseOutcome& outcome : comparison.cases) {
    Json costs;
    for (std::size_t i = 0; i < outcome.finished.size(); ++i) {
      for (const Finished& finished : outcome.finished[i]) {
        costs[comparison.suite.entrants[i].label].push_back(
            {{"seed", finished.scorecard.run.seed},
             {"estimator_cpu_s", finished.estimator_s},
             {"ms_per_frame", Number(MillisecondsPerFrame(finished))},
             {"estimator_stages", StagesJson(finished.stages)}});
      }
    }
    json["cases"].push_back({{"name", outcome.name}, {"estimators", costs}});
  }
  return json.dump(2) + "\n";
}

std::string DescribeCosts(const Comparison& comparison) {
  std::string text;
  for (std::size_t i = 0; i < comparison.suite.entrants.size(); ++i) {
    SeedValues costs;
    for (const CaseOutcome& outcome : comparison.cases) {
      for (const Finished& finished : outcome.finished[i])
        costs.push_back(MillisecondsPerFrame(finished));
    }
    const auto median = Summarize(Statistic::kMedian, costs);
    if (!median) continue;
    text += fmt::format("{}{} {:.1f} ms", text.empty() ? "" : ", ",
                        comparison.suite.entrants[i].label, *median);
  }
  return text;
}

}  // namespace drydock::compare
