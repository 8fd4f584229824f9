#include "sensors_models/base/yaml_node.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>
#include <sstream>

#include <yaml-cpp/depthguard.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include "sensors_models/base/check.h"
#include "sensors_models/base/files.h"

namespace drydock {
namespace {

constexpr std::size_t kMaxFileBytes = std::size_t{1} << 20;
constexpr int kMaxDepth = 32;
/// YAML allows keys of 1024 characters, escapes included: shorter ones can be written again.
constexpr std::size_t kMaxKeyBytes = 128;
/// Far more than any file of ours has; keys are looked up one by one.
constexpr std::size_t kMaxKeys = 10'000;
/// Anchors can make a small text into a huge tree: a tree that is larger than this is refused.
constexpr int kMaxNodes = 200'000;

/// How many bytes the UTF-8 character takes that `text` begins with; 0 if it is none.
std::size_t LengthOfCharacter(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t length = first < 0xc2 ? 0 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
  if (length == 0 || first > 0xf4 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return 0;
  }
  return length;
}

bool IsControl(char c) {
  return static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n' && c != '\r';
}

enum class Controls { kAllowed, kRefused };

/// The line, from 1, of the first byte that no UTF-8 text has, or of the first control character
/// that a text file does not have, if those are refused; nothing in a text.
std::optional<int> FindNotText(std::string_view text, Controls controls) {
  int line = 1;
  while (!text.empty()) {
    const std::size_t length = LengthOfCharacter(text);
    if (length == 0) return line;
    if (controls == Controls::kRefused && IsControl(text.front())) return line;
    if (text.front() == '\n') ++line;
    text.remove_prefix(length);
  }
  return std::nullopt;
}

class Converter {
 public:
  explicit Converter(std::shared_ptr<const std::string> file) : file_(std::move(file)) {}

  YamlNode Convert(const YAML::Node& from, int depth = 0) {
    YamlNode to;
    to.place = {file_, from.Mark().line + 1};
    RequireInput(depth < kMaxDepth, "{}: nested deeper than {}", to.place.ToString(), kMaxDepth);
    RequireInput(++nodes_ < kMaxNodes, "{}: more than {} values", to.place.ToString(), kMaxNodes);
    switch (from.Type()) {
      case YAML::NodeType::Undefined:
      case YAML::NodeType::Null:
        break;
      case YAML::NodeType::Scalar:
        to.kind = YamlNode::Kind::kScalar;
        to.text = TextOf(from, to.place);
        to.quoted = from.Tag() == "!";
        break;
      case YAML::NodeType::Sequence:
        to.kind = YamlNode::Kind::kList;
        for (const auto& item : from) to.items.push_back(Convert(item, depth + 1));
        break;
      case YAML::NodeType::Map:
        ConvertMap(from, depth, to);
        break;
    }
    return to;
  }

 private:
  /// yaml-cpp makes a single byte of each of two escapes, which is no character.
  static const std::string& TextOf(const YAML::Node& scalar, const SourcePlace& place) {
    RequireInput(!FindNotText(scalar.Scalar(), Controls::kAllowed),
                 "{}: the escapes \\N and \\_ are not supported; write \\u0085 and \\u00a0",
                 place.ToString());
    return scalar.Scalar();
  }

  void ConvertMap(const YAML::Node& from, int depth, YamlNode& to) {
    to.kind = YamlNode::Kind::kMap;
    for (const auto& member : from) {
      const SourcePlace place{file_, member.first.Mark().line + 1};
      RequireInput(member.first.IsScalar(), "{}: a key must be plain text", place.ToString());
      const std::string& key = TextOf(member.first, place);
      RequireInput(!key.empty(), "{}: a key must not be empty", place.ToString());
      RequireInput(to.members.size() < kMaxKeys, "{}: a mapping of more than {} keys",
                   place.ToString(), kMaxKeys);
      RequireInput(key.size() <= kMaxKeyBytes, "{}: a key must not be longer than {} bytes",
                   place.ToString(), kMaxKeyBytes);
      const YamlNode* earlier = to.Find(key);
      RequireInput(earlier == nullptr, "{}: the key '{}' stands twice (first in line {})",
                   place.ToString(), key, earlier == nullptr ? 0 : earlier->place.line);
      to.members.emplace_back(key, Convert(member.second, depth + 1));
      to.members.back().second.place = place;
    }
  }

  std::shared_ptr<const std::string> file_;
  int nodes_ = 0;
};

bool IsPlainText(std::string_view text) {
  const auto plain = [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.' || c == '/' || c == '+';
  };
  return !text.empty() && text != "-" && text != "." &&
         std::all_of(text.begin(), text.end(), plain);
}

/// What ParseYaml would take for nothing rather than for text.
bool ReadsAsNull(std::string_view text) {
  return text == "null" || text == "Null" || text == "NULL" || text == "~";
}

std::string EmitScalar(std::string_view text, bool quoted) {
  if (!quoted && IsPlainText(text)) return std::string(text);
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      out += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    } else {
      out += c;
    }
  }
  return out + '"';
}

void EmitValue(const YamlNode& node, int indent, std::string& out);

void EmitMembers(const YamlNode& node, int indent, std::string& out) {
  for (const auto& [key, value] : node.members) {
    const bool quote_key = ReadsAsNull(key);
    out += fmt::format("{:{}}{}:", "", indent, EmitScalar(key, quote_key));
    EmitValue(value, indent + 2, out);
  }
}

void EmitValue(const YamlNode& node, int indent, std::string& out) {
  switch (node.kind) {
    case YamlNode::Kind::kNull:
      out += " ~\n";
      return;
    case YamlNode::Kind::kScalar:
      out += ' ' + EmitScalar(node.text, node.quoted || ReadsAsNull(node.text)) + '\n';
      return;
    case YamlNode::Kind::kList:
      if (node.items.empty()) {
        out += " []\n";
        return;
      }
      out += '\n';
      for (const YamlNode& item : node.items) {
        out += fmt::format("{:{}}-", "", indent);
        EmitValue(item, indent + 2, out);
      }
      return;
    case YamlNode::Kind::kMap:
      if (node.members.empty()) {
        out += " {}\n";
        return;
      }
      out += '\n';
      EmitMembers(node, indent, out);
      return;
  }
}

/// Takes what a parser says and does nothing with it.
class IgnoreEvents final : public YAML::EventHandler {
 public:
  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t,
                const std::string&) override {}
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {}
  void OnMapEnd() override {}
};

/// How many documents a text holds; 2 stands for more, too.
int CountDocuments(const std::string& text) {
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  IgnoreEvents ignore;
  int count = 0;
  while (count < 2 && parser.HandleNextDocument(ignore)) ++count;
  return count;
}

/// The text's only document, or an undefined node if it has none. yaml-cpp's own LoadAll goes on
/// for ever over a stray comma between documents.
YAML::Node LoadDocument(std::string_view text, const std::string& place) {
  // yaml-cpp lets a quote that is never closed run to the end of the text; a document's end within
  // a quote, however, is an error.
  const std::string ended = std::string(text) + (text.ends_with('\n') ? "...\n" : "\n...\n");
  const int count = CountDocuments(ended);
  RequireInput(count < 2, "{}: holds more than one YAML document, or text outside of it", place);
  return count == 0 ? YAML::Node(YAML::NodeType::Undefined) : YAML::Load(ended);
}

YamlNode ParseValue(std::string_view text, const SourcePlace& place) {
  try {
    return Converter(place.file).Convert(LoadDocument(text, place.ToString()));
  } catch (const YAML::Exception& error) {
    RequireInput(false, "{}: {}", place.ToString(), error.msg);
  }
  return {};
}

/// The value that one step of a path leads to. Adds a missing key of a mapping, as a mapping itself
/// unless it is the last: whether it means anything is for the reader to say.
YamlNode& Step(YamlNode& node, std::string_view key, bool last, const SourcePlace& place) {
  if (node.kind == YamlNode::Kind::kMap) {
    if (YamlNode* found = node.Find(key)) return *found;
    RequireInput(!key.empty() && key.size() <= kMaxKeyBytes, "{}: there is no '{}' at {}",
                 place.ToString(), key, node.place.ToString());
    YamlNode added;
    added.place = place;
    if (!last) added.kind = YamlNode::Kind::kMap;
    return node.members.emplace_back(std::string(key), std::move(added)).second;
  }
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), index);
  const bool is_index = error == std::errc() && end == key.data() + key.size();
  RequireInput(node.kind == YamlNode::Kind::kList && is_index && index < node.items.size(),
               "{}: '{}' leads nowhere at {}", place.ToString(), key, node.place.ToString());
  return node.items[index];
}

}  // namespace

std::string SourcePlace::ToString() const {
  const std::string name = file ? *file : "(unknown)";
  return line > 0 ? fmt::format("{}:{}", name, line) : name;
}

YamlNode::YamlNode() = default;
YamlNode::YamlNode(const YamlNode&) = default;
YamlNode::YamlNode(YamlNode&&) noexcept = default;
YamlNode& YamlNode::operator=(const YamlNode&) = default;
YamlNode& YamlNode::operator=(YamlNode&&) noexcept = default;
YamlNode::~YamlNode() = default;

const YamlNode* YamlNode::Find(std::string_view key) const {
  const auto found = std::find_if(members.begin(), members.end(),
                                  [key](const Member& member) { return member.first == key; });
  return found == members.end() ? nullptr : &found->second;
}

YamlNode* YamlNode::Find(std::string_view key) {
  return const_cast<YamlNode*>(static_cast<const YamlNode*>(this)->Find(key));
}

YamlNode ParseYaml(std::string_view text, const std::string& file) {
  const auto name = std::make_shared<const std::string>(file);
  RequireInput(text.size() <= kMaxFileBytes, "{}: larger than {} bytes", file, kMaxFileBytes);
  if (const auto line = FindNotText(text, Controls::kRefused)) {
    RequireInput(false, "{}: is not UTF-8 text", SourcePlace{name, *line}.ToString());
  }
  YamlNode root;
  try {
    root = Converter(name).Convert(LoadDocument(text, file));
  } catch (const YAML::DeepRecursion& error) {
    RequireInput(false, "{}: nested deeper than {}",
                 SourcePlace{name, error.mark.line + 1}.ToString(), kMaxDepth);
  } catch (const YAML::Exception& error) {
    RequireInput(false, "{}: {}", SourcePlace{name, error.mark.line + 1}.ToString(), error.msg);
  }
  RequireInput(root.kind == YamlNode::Kind::kMap, "{}: {}must be a mapping of keys to values", file,
               root.kind == YamlNode::Kind::kNull ? "is empty, " : "");
  return root;
}

YamlNode LoadYaml(const std::filesystem::path& path) {
  return ParseYaml(ReadFile(path, kMaxFileBytes), path.string());
}

void MergeYaml(YamlNode& base, const YamlNode& over) {
  if (base.kind != YamlNode::Kind::kMap || over.kind != YamlNode::Kind::kMap) {
    base = over;
    return;
  }
  for (const auto& [key, value] : over.members) {
    if (YamlNode* existing = base.Find(key)) {
      MergeYaml(*existing, value);
    } else {
      base.members.emplace_back(key, value);
    }
  }
}

void SetYaml(YamlNode& root, std::string_view assignment) {
  const auto equals = assignment.find('=');
  RequireInput(equals != std::string_view::npos && equals > 0, "--set {}: must be key.path=value",
               assignment);
  const SourcePlace place{std::make_shared<const std::string>(fmt::format("--set {}", assignment)),
                          0};
  YamlNode value = ParseValue(assignment.substr(equals + 1), place);
  value.place = place;
  SetYaml(root, assignment.substr(0, equals), std::move(value));
}

void SetYaml(YamlNode& root, std::string_view path, YamlNode value) {
  YamlNode* node = &root;
  for (int depth = 1;; ++depth) {
    RequireInput(depth < kMaxDepth, "{:.60}: leads deeper than {}", value.place.ToString(),
                 kMaxDepth);
    const auto dot = path.find('.');
    const bool last = dot == std::string_view::npos;
    node = &Step(*node, path.substr(0, dot), last, value.place);
    if (last) break;
    path.remove_prefix(dot + 1);
  }
  *node = std::move(value);
}

void SetAllYaml(YamlNode& root, const YamlNode& values) {
  for (const auto& [path, value] : values.members) SetYaml(root, path, value);
}

std::string EmitYaml(const YamlNode& root) {
  if (root.members.empty()) return "{}\n";
  std::string out;
  EmitMembers(root, 0, out);
  return out;
}

}  // namespace drydock
