#include "sensors_models/base/yaml_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include <fmt/ranges.h>

#include "sensors_models/base/check.h"

namespace drydock {
namespace {

/// What a message shows of a text: not all of a long one, and no bytes that a terminal obeys.
std::string Shown(std::string_view text) {
  constexpr std::size_t kMax = 60;
  std::string shown(text.substr(0, kMax));
  for (char& c : shown) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  }
  return text.size() > kMax ? shown + "..." : shown;
}

std::string Describe(const YamlNode& node) {
  switch (node.kind) {
    case YamlNode::Kind::kNull:
      return "nothing";
    case YamlNode::Kind::kScalar:
      return node.quoted ? fmt::format("\"{}\"", Shown(node.text)) : Shown(node.text);
    case YamlNode::Kind::kList:
      return "a list";
    case YamlNode::Kind::kMap:
      return "a mapping";
  }
  return "";
}

std::string DescribeNumber(std::string_view what, Bounds bounds) {
  const bool low = bounds.low > Bounds::Any().low;
  const bool high = bounds.high < Bounds::Any().high;
  if (bounds.low == Bounds::Positive().low) {
    return high ? fmt::format("{} above 0, at most {}", what, bounds.high)
                : fmt::format("{} above 0", what);
  }
  if (low && high) return fmt::format("{} from {} to {}", what, bounds.low, bounds.high);
  if (low) return fmt::format("{} of at least {}", what, bounds.low);
  if (high) return fmt::format("{} of at most {}", what, bounds.high);
  return std::string(what);
}

template <typename Number>
std::optional<Number> ParseNumber(const YamlNode& node) {
  if (node.kind != YamlNode::Kind::kScalar || node.quoted) return std::nullopt;
  std::string_view text = node.text;
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

YamlReader::YamlReader(const YamlNode& node, std::string path)
    : node_(node), path_(std::move(path)) {
  if (node.kind != YamlNode::Kind::kMap) {
    RequireInput(false, "{}: {} is {}, must be a mapping of keys to values", node.place.ToString(),
                 path_.empty() ? "the file" : path_, Describe(node));
  }
}

std::string YamlReader::PlaceOf(std::string_view key) const {
  const YamlNode* value = node_.Find(key);
  return value == nullptr ? Place() : value->place.ToString();
}

bool YamlReader::Has(std::string_view key) const { return node_.Find(key) != nullptr; }

std::string YamlReader::PathOf(std::string_view key) const {
  return path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
}

const YamlNode* YamlReader::Value(std::string_view key) {
  known_.emplace(key);
  return node_.Find(key);
}

const YamlNode& YamlReader::Require(std::string_view key) {
  const YamlNode* value = Value(key);
  if (value == nullptr) RequireInput(false, "{}: the key '{}' is missing", Place(), PathOf(key));
  return *value;
}

void YamlReader::Fail(const YamlNode& node, std::string_view key, std::string_view allowed) const {
  throw InputError(fmt::format("{}: {} is {}, must be {}", node.place.ToString(), PathOf(key),
                               Describe(node), allowed));
}

void YamlReader::Fail(std::string_view key, std::string_view what_is_allowed) const {
  const YamlNode* value = node_.Find(key);
  Fail(value == nullptr ? node_ : *value, key, what_is_allowed);
}

double YamlReader::ToReal(const YamlNode& node, std::string_view key, Bounds bounds) const {
  const auto value = ParseNumber<double>(node);
  if (!value || !std::isfinite(*value) || *value < bounds.low || *value > bounds.high) {
    Fail(node, key, DescribeNumber("a number", bounds));
  }
  return *value;
}

std::int64_t YamlReader::ToInteger(const YamlNode& node, std::string_view key,
                                   Bounds bounds) const {
  const auto value = ParseNumber<std::int64_t>(node);
  if (!value || static_cast<double>(*value) < bounds.low ||
      static_cast<double>(*value) > bounds.high) {
    Fail(node, key, DescribeNumber("a whole number", bounds));
  }
  return *value;
}

double YamlReader::Real(std::string_view key, Bounds bounds) {
  return ToReal(Require(key), key, bounds);
}

double YamlReader::Real(std::string_view key, Bounds bounds, double default_value) {
  const YamlNode* value = Value(key);
  return value == nullptr ? default_value : ToReal(*value, key, bounds);
}

std::int64_t YamlReader::Integer(std::string_view key, Bounds bounds) {
  return ToInteger(Require(key), key, bounds);
}

std::int64_t YamlReader::Integer(std::string_view key, Bounds bounds, std::int64_t default_value) {
  const YamlNode* value = Value(key);
  return value == nullptr ? default_value : ToInteger(*value, key, bounds);
}

bool YamlReader::Boolean(std::string_view key, bool default_value) {
  const YamlNode* value = Value(key);
  if (value == nullptr) return default_value;
  const bool plain = value->kind == YamlNode::Kind::kScalar && !value->quoted;
  if (plain && value->text == "true") return true;
  if (plain && value->text == "false") return false;
  Fail(*value, key, "true or false");
}

std::string YamlReader::Text(std::string_view key) {
  const YamlNode& value = Require(key);
  if (value.kind != YamlNode::Kind::kScalar || value.text.empty()) Fail(value, key, "text");
  return value.text;
}

std::string YamlReader::Text(std::string_view key, std::string_view default_value) {
  return Value(key) == nullptr ? std::string(default_value) : Text(key);
}

std::string YamlReader::Choice(std::string_view key, const std::vector<std::string>& allowed,
                               std::string_view default_value) {
  std::string value = Text(key, default_value);
  if (std::find(allowed.begin(), allowed.end(), value) == allowed.end()) {
    Fail(key, fmt::format("one of {}", fmt::join(allowed, ", ")));
  }
  return value;
}

std::vector<double> YamlReader::Reals(std::string_view key, Bounds bounds, std::size_t size) {
  const YamlNode& value = Require(key);
  const std::string wanted =
      size > 0 ? fmt::format("a list of {} numbers", size) : "a list of numbers";
  if (value.kind != YamlNode::Kind::kList || (size > 0 && value.items.size() != size)) {
    Fail(value, key, wanted);
  }
  std::vector<double> numbers;
  for (std::size_t i = 0; i < value.items.size(); ++i) {
    numbers.push_back(ToReal(value.items[i], fmt::format("{}.{}", key, i), bounds));
  }
  return numbers;
}

Eigen::Vector3d YamlReader::Vector3(std::string_view key, Bounds bounds) {
  const std::vector<double> v = Reals(key, bounds, 3);
  return {v[0], v[1], v[2]};
}

Eigen::Vector3d YamlReader::Vector3(std::string_view key, Bounds bounds,
                                    const Eigen::Vector3d& default_value) {
  return Value(key) == nullptr ? default_value : Vector3(key, bounds);
}

void YamlReader::Map(std::string_view key, const std::function<void(YamlReader&)>& read) {
  YamlReader reader(Require(key), PathOf(key));
  read(reader);
  reader.Finish();
}

void YamlReader::OptionalMap(std::string_view key, const std::function<void(YamlReader&)>& read) {
  if (Value(key) != nullptr) Map(key, read);
}

const YamlNode* YamlReader::OptionalSubtree(std::string_view key) {
  const YamlNode* value = Value(key);
  if (value != nullptr && value->kind != YamlNode::Kind::kMap)
    Fail(*value, key, "a mapping of keys to values");
  return value;
}

void YamlReader::List(std::string_view key, const std::function<void(YamlReader&)>& read) {
  const YamlNode* value = Value(key);
  if (value == nullptr) return;
  if (value->kind != YamlNode::Kind::kList) Fail(*value, key, "a list");
  for (std::size_t i = 0; i < value->items.size(); ++i) {
    YamlReader reader(value->items[i], fmt::format("{}.{}", PathOf(key), i));
    read(reader);
    reader.Finish();
  }
}

void YamlReader::Finish() const {
  Finish([](const std::string& message) { throw InputError(message); });
}

void YamlReader::Finish(const std::function<void(const std::string&)>& warn) const {
  for (const auto& [key, value] : node_.members) {
    if (known_.contains(key)) continue;
    warn(fmt::format("{}: unknown key '{}'; known here: {}", value.place.ToString(), PathOf(key),
                     known_.empty() ? "none" : fmt::to_string(fmt::join(known_, ", "))));
  }
}

}  // namespace drydock
