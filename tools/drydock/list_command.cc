#include "estimator/registry/registry.h"
#include "scenarios/scoring/metrics.h"
#include "sensors_models/base/check.h"
#include "sensors_models/base/resources.h"
#include "sensors_models/base/yaml_node.h"
#include "tools/drydock/commands.h"

#ifdef DRYDOCK_WITH_SIM
#include "scenes/scene.h"
#endif

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace drydock::cli {
namespace {

/// The files of a folder with their summaries.
void PrintFiles(const char* title, const std::filesystem::path& folder) {
  fmt::print("{}\n", title);
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  for (const auto& file : files) {
    std::string summary;
    try {
      const YamlNode root = LoadYaml(file);
      const YamlNode* text = root.Find("summary");
      summary = text == nullptr ? "(no summary)" : text->text;
    } catch (const InputError& error) {
      summary = fmt::format("(unreadable: {})", error.what());
    }
    fmt::print("  {:<24} {}\n", file.stem().string(), summary);
  }
}

int List() {
  const std::filesystem::path scenarios = DataDirectory() / "scenarios";
  PrintFiles("Scenarios", scenarios);
  PrintFiles("Suites", scenarios / "suites");
#ifdef DRYDOCK_WITH_SIM
  fmt::print("Scenes\n");
  for (const scenes::SceneEntry& scene : scenes::Scenes())
    fmt::print("  {:<24} {}\n", scene.name, scene.summary);
#endif
  fmt::print("Estimators\n");
  for (const EstimatorEntry& entry : Estimators())
    fmt::print("  {:<24} {}\n", entry.name, entry.summary);
  fmt::print("Metrics\n");
  for (const score::MetricInfo& metric : score::AllMetrics()) {
    fmt::print("  {:<24} {}{}\n", metric.name, metric.description,
               metric.unit.empty() ? "" : fmt::format(" [{}]", metric.unit));
  }
  return kPassed;
}

}  // namespace

void AddListCommand(CLI::App& app, Action& chosen) {
  CLI::App* command =
      app.add_subcommand("list", "Scenarios, suites, scenes, estimators and metrics, a line each");
  command->callback([&chosen] { chosen = List; });
}

}  // namespace drydock::cli
