// Any text is either refused with an InputError or read; what was read can be written, read again
// and means the same. The same text is read as a rig, as a whole scenario and as a --set.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "scenarios/dataset/rig_yaml.h"
#include "scenarios/runner/scenario.h"
#include "sensors_models/base/check.h"
#include "sensors_models/base/yaml_node.h"
#include "sensors_models/measurement/rig.h"
#include "tests/fuzz/require.h"

namespace drydock::fuzz {
namespace {

bool SameTree(const YamlNode& a, const YamlNode& b) {
  if (a.kind != b.kind || a.text != b.text || a.items.size() != b.items.size() ||
      a.members.size() != b.members.size()) {
    return false;
  }
  for (std::size_t i = 0; i < a.items.size(); ++i) {
    if (!SameTree(a.items[i], b.items[i])) return false;
  }
  for (std::size_t i = 0; i < a.members.size(); ++i) {
    if (a.members[i].first != b.members[i].first) return false;
    if (!SameTree(a.members[i].second, b.members[i].second)) return false;
  }
  return true;
}

/// What can be read as a rig can be written and comes back to the last bit.
void ReadAsRig(const YamlNode& root) {
  Rig rig;
  try {
    rig = ReadRig(root);
  } catch (const InputError& error) {
    Require(std::string_view(error.what()).starts_with("fuzz.yaml"), "an error names its file");
    return;
  }
  const std::string written = dataset::FormatRig(rig);
  const Rig back = ReadRig(ParseYaml(written, "written.yaml"));
  Require(dataset::FormatRig(back) == written, "a rig comes back");
}

void ReadAsScenario(const YamlNode& root) {
  try {
    const Scenario scenario = ReadScenario(root, "fuzz");
    Require(scenario.motion.waypoints.size() >= 2, "a path has two ends");
  } catch (const InputError& error) {
    Require(std::string_view(error.what()).starts_with("fuzz.yaml"), "an error names its file");
  }
}

void Run(std::string_view text) {
  std::optional<YamlNode> root;
  try {
    root = ParseYaml(text, "fuzz.yaml");
  } catch (const InputError&) {
    return;
  }
  const std::string emitted = EmitYaml(*root);
  // Written out, anchors and short forms may exceed what a file may have.
  if (emitted.size() < (1U << 20)) {
    const YamlNode back = ParseYaml(emitted, "emitted.yaml");
    Require(SameTree(back, *root), "ParseYaml(EmitYaml(tree)) == tree");
    Require(EmitYaml(back) == emitted, "EmitYaml is stable");
  }
  ReadAsRig(*root);
  ReadAsScenario(*root);
  YamlNode changed = *root;
  try {
    SetYaml(changed, text.substr(0, text.find('\n')));
  } catch (const InputError&) {
  }
  MergeYaml(changed, *root);
  MergeYaml(changed, *root);
}

}  // namespace
}  // namespace drydock::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  drydock::fuzz::Run({reinterpret_cast<const char*>(data), size});
  return 0;
}
