// A YAML file as a tree that remembers where each value was written.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace drydock {

/// Where a value stands, for messages: "scenarios/bus.yaml:12".
struct SourcePlace {
  std::shared_ptr<const std::string> file;
  int line = 0;  ///< From 1; 0 where no line is known.

  std::string ToString() const;
};

/// One value: nothing, a scalar, a list or a mapping. Mappings keep the order of the file.
struct YamlNode {
  enum class Kind { kNull, kScalar, kList, kMap };
  using Member = std::pair<std::string, YamlNode>;

  // Defined where the type is complete: a pair needs that of its members before it can be copied.
  YamlNode();
  YamlNode(const YamlNode&);
  YamlNode(YamlNode&&) noexcept;
  YamlNode& operator=(const YamlNode&);
  YamlNode& operator=(YamlNode&&) noexcept;
  ~YamlNode();

  Kind kind = Kind::kNull;
  std::string text;     ///< Of a scalar, as written.
  bool quoted = false;  ///< A scalar in quotes is text, never a number.
  std::vector<YamlNode> items;
  std::vector<Member> members;
  SourcePlace place;

  /// The member with this key, or nullptr.
  const YamlNode* Find(std::string_view key) const;
  YamlNode* Find(std::string_view key);
};

/// Reads one YAML document whose top is a mapping. InputError with file and line for bad syntax,
/// duplicate keys, keys that are not plain text, several documents, anchors that nest without end,
/// what is not UTF-8, or more than 1 MiB.
YamlNode ParseYaml(std::string_view text, const std::string& file);
YamlNode LoadYaml(const std::filesystem::path& path);

/// Lays `over` upon `base`: mappings are merged key by key, everything else is replaced.
void MergeYaml(YamlNode& base, const YamlNode& over);

/// Applies "key.path=value" (list items by number: "criteria.0.max=3"). The key must lead through
/// existing mappings or lists; a last key that is not there yet is added. InputError otherwise.
void SetYaml(YamlNode& root, std::string_view assignment);

/// The same for a value that is there already; what is wrong is said of its place.
void SetYaml(YamlNode& root, std::string_view path, YamlNode value);

/// Applies each member of the mapping `values`, whose keys are paths: {water.visibility_m: 6}.
void SetAllYaml(YamlNode& root, const YamlNode& values);

/// The tree as YAML text that ParseYaml reads back to an equal tree.
std::string EmitYaml(const YamlNode& root);

}  // namespace drydock
