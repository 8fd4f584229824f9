#include "scenarios/runner/scenario_yaml.h"

#include "sensors_models/base/check.h"

namespace drydock {
namespace {

constexpr int kLongestChain = 8;

YamlNode LoadChain(const std::filesystem::path& path, int depth) {
  RequireInput(depth < kLongestChain,
               "{}: more than {} files based on one another: is there a circle?", path.string(),
               kLongestChain);
  YamlNode file = LoadYaml(path);
  const YamlNode* base = file.Find("base");
  if (base == nullptr) return file;
  RequireInput(base->kind == YamlNode::Kind::kScalar && !base->text.empty(),
               "{}: base must be a file's name", base->place.ToString());
  const std::filesystem::path base_path = path.parent_path() / base->text;
  RequireInput(std::filesystem::is_regular_file(base_path),
               "{}: base is {}, but there is no such file", base->place.ToString(),
               base_path.string());
  YamlNode merged = LoadChain(base_path, depth + 1);
  std::erase_if(file.members,
                [](const YamlNode::Member& member) { return member.first == "base"; });
  MergeYaml(merged, file);
  merged.place = file.place;
  return merged;
}

}  // namespace

YamlNode LoadWithBases(const std::filesystem::path& path) { return LoadChain(path, 0); }

}  // namespace drydock
