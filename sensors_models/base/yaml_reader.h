// Strict reading of configuration: what is not understood is an error, never a silent default.
#pragma once

#include <Eigen/Core>
#include <concepts>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "sensors_models/base/yaml_node.h"

namespace drydock {

/// The values that a number may have, both ends allowed.
struct Bounds {
  double low = -std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::max();

  static constexpr Bounds Any() { return {}; }
  static constexpr Bounds NotNegative() { return {0.0, std::numeric_limits<double>::max()}; }
  /// Above zero.
  static constexpr Bounds Positive() {
    return {std::numeric_limits<double>::min(), std::numeric_limits<double>::max()};
  }
};

/// Reads one mapping key by key. A getter without default insists on the key; one with a default
/// returns it where the key is missing. Wrong types, quoted numbers, NaN, infinities and values out
/// of bounds throw InputError with file, line, key, value and what is allowed. Finish() (called by
/// ReadYaml, Map and List) refuses keys that nobody asked for.
class YamlReader {
 public:
  /// `path` is the key path to `node` for messages, "" at the top. `node` must outlive the reader.
  explicit YamlReader(const YamlNode& node, std::string path = "");

  bool Has(std::string_view key) const;

  double Real(std::string_view key, Bounds bounds);
  double Real(std::string_view key, Bounds bounds, double default_value);
  std::int64_t Integer(std::string_view key, Bounds bounds);
  std::int64_t Integer(std::string_view key, Bounds bounds, std::int64_t default_value);
  bool Boolean(std::string_view key, bool default_value);
  std::string Text(std::string_view key);
  std::string Text(std::string_view key, std::string_view default_value);
  /// One of `allowed`.
  std::string Choice(std::string_view key, const std::vector<std::string>& allowed,
                     std::string_view default_value);
  /// A list of numbers, of exactly `size` where `size` > 0.
  std::vector<double> Reals(std::string_view key, Bounds bounds, std::size_t size = 0);
  Eigen::Vector3d Vector3(std::string_view key, Bounds bounds = {});
  Eigen::Vector3d Vector3(std::string_view key, Bounds bounds,
                          const Eigen::Vector3d& default_value);

  /// A mapping under `key`, read by `read`. With OptionalMap, `read` is not called where the key is
  /// missing.
  void Map(std::string_view key, const std::function<void(YamlReader&)>& read);
  void OptionalMap(std::string_view key, const std::function<void(YamlReader&)>& read);
  /// A list of mappings, `read` called for each; a missing key is an empty list.
  void List(std::string_view key, const std::function<void(YamlReader&)>& read);
  /// The value of `key` as it stands, which is read by that; nullptr where the key is missing.
  const YamlNode* Value(std::string_view key);
  /// The mapping under `key` as it stands, for a reader of its own; nullptr where the key is
  /// missing.
  const YamlNode* OptionalSubtree(std::string_view key);
  /// Marks `key` as read without looking at it.
  void Skip(std::string_view key) { known_.emplace(key); }

  /// Throws InputError for the place and value of `key`, with what is allowed: for rules that bind
  /// several keys.
  [[noreturn]] void Fail(std::string_view key, std::string_view what_is_allowed) const;
  /// "file:line" of the mapping.
  std::string Place() const { return node_.place.ToString(); }
  /// "file:line" of the value of `key`; the mapping's where the key is missing.
  std::string PlaceOf(std::string_view key) const;

  /// Throws InputError if the mapping has a key that was never asked for.
  void Finish() const;
  /// The same, but hands each such key to `warn`: for files that other programs write.
  void Finish(const std::function<void(const std::string& message)>& warn) const;

 private:
  const YamlNode& Require(std::string_view key);
  std::string PathOf(std::string_view key) const;
  double ToReal(const YamlNode& node, std::string_view key, Bounds bounds) const;
  std::int64_t ToInteger(const YamlNode& node, std::string_view key, Bounds bounds) const;
  [[noreturn]] void Fail(const YamlNode& node, std::string_view key,
                         std::string_view allowed) const;

  const YamlNode& node_;
  std::string path_;
  std::set<std::string, std::less<>> known_;
};

/// Reads all of `root` by `read` and refuses what `read` did not ask for.
template <std::invocable<YamlReader&> Read>
auto ReadYaml(const YamlNode& root, Read read) {
  YamlReader reader(root);
  auto result = read(reader);
  reader.Finish();
  return result;
}

}  // namespace drydock
