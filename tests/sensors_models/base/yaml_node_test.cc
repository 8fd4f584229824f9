#include "sensors_models/base/yaml_node.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sensors_models/base/check.h"
#include "tests/support/input_error.h"

namespace drydock {
namespace {

using drydock::testing::InputErrorOf;

using ::testing::HasSubstr;

/// The message of the InputError that `act` throws; "" if it throws none.
std::string ParseMessage(std::string_view text) {
  return InputErrorOf([&] { ParseYaml(text, "f.yaml"); });
}

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

TEST(ParseYaml, KeepsOrderTextAndPlace) {
  const YamlNode root = ParseYaml("b: 1e-3\na:\n  - x\n  - 'y z'\nn:\n", "f.yaml");
  ASSERT_EQ(root.members.size(), 3U);
  EXPECT_EQ(root.members[0].first, "b");
  EXPECT_EQ(root.Find("b")->text, "1e-3");
  EXPECT_FALSE(root.Find("b")->quoted);
  EXPECT_TRUE(root.Find("a")->items[1].quoted);
  EXPECT_EQ(root.Find("a")->items[1].text, "y z");
  EXPECT_EQ(root.Find("a")->items[1].place.ToString(), "f.yaml:4");
  EXPECT_EQ(root.Find("n")->kind, YamlNode::Kind::kNull);
  EXPECT_EQ(root.Find("missing"), nullptr);
}

TEST(ParseYaml, RefusesWhatYamlCppLetsPass) {
  EXPECT_THAT(ParseMessage("a: 1\nb: 2\na: 3\n"),
              AllOf(HasSubstr("f.yaml:3"), HasSubstr("'a'"), HasSubstr("line 1")));
  EXPECT_THAT(ParseMessage("a: 1\n---\nb: 2\n"), HasSubstr("more than one YAML document"));
  EXPECT_THAT(ParseMessage("? [x, y]\n: 1\n"), HasSubstr("plain text"));
  EXPECT_THAT(ParseMessage("\"\": 1\n"), HasSubstr("must not be empty"));
  EXPECT_THAT(ParseMessage(std::string(129, 'k') + ": 1\n"), HasSubstr("longer than 128"));
}

TEST(ParseYaml, RefusesBadSyntaxWithItsLine) {
  EXPECT_THAT(ParseMessage("a: 1\nb: [1, 2\n"), HasSubstr("f.yaml:"));
  EXPECT_THAT(ParseMessage("a: 1\n  b: 2\n"), HasSubstr("f.yaml:2"));
  EXPECT_THAT(ParseMessage("a: *nowhere\n"), HasSubstr("f.yaml:1"));
  // yaml-cpp would take all that follows for text.
  EXPECT_THAT(ParseMessage("a: \"open\nb: 1\n"), HasSubstr("f.yaml"));
  EXPECT_THAT(ParseMessage("a: 'open\nb: 1"), HasSubstr("f.yaml"));
}

// yaml-cpp's LoadAll goes on for ever, and takes memory all the while, on each of these.
TEST(ParseYaml, RefusesTextOutsideOfTheDocument) {
  for (const char* text :
       {"a: 1\n...\n, b\n", "a: 1\n, b\n", "a\n,\n", "a: [1] ]\n", "{a: 1} }\n"}) {
    EXPECT_NE(ParseMessage(text), "") << text;
  }
}

TEST(ParseYaml, RefusesWhatIsNotAMapping) {
  for (const char* text : {"", "# nothing\n", "- a\n- b\n", "text\n", "~\n"}) {
    EXPECT_NE(ParseMessage(text), "") << text;
  }
}

TEST(ParseYaml, RefusesDepthBombs) {
  std::string flow = "a: " + std::string(40, '[') + std::string(40, ']') + "\n";
  EXPECT_THAT(ParseMessage(flow), HasSubstr("nested deeper"));
  const std::string deep = "a: " + std::string(100'000, '[');
  EXPECT_NE(ParseMessage(deep), "");
  EXPECT_NE(ParseMessage(std::string(100'000, '{')), "");
  EXPECT_NE(ParseMessage(std::string(100'000, '-').insert(1, " ")), "");
  std::string dashes;
  for (int i = 0; i < 50'000; ++i) dashes += "- ";
  EXPECT_NE(ParseMessage(dashes), "");
}

TEST(ParseYaml, RefusesAnchorsThatExplode) {
  std::string text = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n";
  for (int i = 1; i < 10; ++i) {
    text += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [";
    for (int k = 0; k < 10; ++k) text += "*a" + std::to_string(i - 1) + (k < 9 ? ", " : "]\n");
  }
  EXPECT_THAT(ParseMessage(text), HasSubstr("more than"));
}

TEST(ParseYaml, RefusesWhatIsNotUtf8) {
  EXPECT_NO_THROW(ParseYaml("a: \"\xc3\xbc \xe2\x82\xac \xf0\x9f\x90\x9f\"\r\nb:\t1\n", "f.yaml"));
  EXPECT_NO_THROW(
      ParseYaml("\xef\xbb\xbf"
                "a: 1\n",
                "f.yaml"));  // A byte order mark.
  for (const std::string_view bad :
       {std::string_view("\0", 1), std::string_view("\x1b"), std::string_view("\xfc"),
        std::string_view("\xc3"), std::string_view("\xc3("), std::string_view("\xc0\x80"),
        std::string_view("\xe2\x82"), std::string_view("\xf8\x88\x80\x80\x80")}) {
    EXPECT_THAT(ParseMessage("a: 1\nb: " + std::string(bad)), HasSubstr("f.yaml:2: is not UTF-8"))
        << ::testing::PrintToString(bad);
  }
}

TEST(ParseYaml, RefusesEscapesThatMakeNoCharacter) {
  for (const std::string_view bad : {"b: \"x\\N\"", "b: [\"\\_x\"]", "\"\\N\": 1"}) {
    EXPECT_THAT(ParseMessage("a: 1\n" + std::string(bad)),
                HasSubstr("f.yaml:2: the escapes \\N and \\_ are not supported"))
        << bad;
  }
  const YamlNode root = ParseYaml(R"(a: "\u0085\u00a0\L")", "f.yaml");
  EXPECT_EQ(root.Find("a")->text, "\xc2\x85\xc2\xa0\xe2\x80\xa8");
  EXPECT_TRUE(SameTree(ParseYaml(EmitYaml(root), "e.yaml"), root)) << EmitYaml(root);
}

TEST(ParseYaml, RefusesMappingsThatTakeForEver) {
  std::string text;
  for (int i = 0; i <= 10'000; ++i) text += "k" + std::to_string(i) + ": 1\n";
  EXPECT_THAT(ParseMessage(text), HasSubstr("f.yaml:10001: a mapping of more than 10000 keys"));
}

TEST(ParseYaml, RefusesAFileThatIsTooLarge) {
  EXPECT_THAT(ParseMessage("a: " + std::string(1 << 20, 'x')), HasSubstr("larger than"));
}

TEST(MergeYaml, MergesMappingsAndReplacesTheRest) {
  YamlNode base = ParseYaml("a: {x: 1, y: [1, 2]}\nb: 2\n", "base.yaml");
  const YamlNode over = ParseYaml("a: {y: [3], z: 4}\nb: {c: 1}\n", "over.yaml");
  MergeYaml(base, over);
  const YamlNode expected = ParseYaml("a: {x: 1, y: [3], z: 4}\nb: {c: 1}\n", "e.yaml");
  EXPECT_TRUE(SameTree(base, expected)) << EmitYaml(base);
  EXPECT_EQ(base.Find("a")->Find("z")->place.ToString(), "over.yaml:1");
  EXPECT_EQ(base.Find("a")->Find("x")->place.ToString(), "base.yaml:1");
}

TEST(SetYaml, SetsReplacesAndAdds) {
  YamlNode root = ParseYaml("a: {x: 1}\nlist: [{m: 1}, {m: 2}]\n", "f.yaml");
  SetYaml(root, "a.x=2.5");
  SetYaml(root, "a.new=[1, two]");
  SetYaml(root, "list.1.m=text");
  SetYaml(root, "top=a=b");
  SetYaml(root, "empty=");
  SetYaml(root, "not.there.yet=3");
  const YamlNode expected = ParseYaml(
      "a: {x: 2.5, new: [1, two]}\nlist: [{m: 1}, {m: text}]\ntop: a=b\nempty:\n"
      "not: {there: {yet: 3}}\n",
      "e.yaml");
  EXPECT_TRUE(SameTree(root, expected)) << EmitYaml(root);
  EXPECT_THAT(root.Find("a")->Find("x")->place.ToString(), HasSubstr("--set a.x=2.5"));
  // What was made on the way is the user's doing, too.
  EXPECT_EQ(root.Find("not")->place.ToString(), "--set not.there.yet=3");
}

TEST(SetYaml, RefusesPathsWithoutEnd) {
  YamlNode root = ParseYaml("a: 1\n", "f.yaml");
  std::string path = "x";
  for (int i = 0; i < 40; ++i) path += ".x";
  EXPECT_THAT(InputErrorOf([&] { SetYaml(root, path + "=1"); }), HasSubstr("deeper than 32"));
}

TEST(SetYaml, RefusesPathsThatLeadNowhere) {
  YamlNode root = ParseYaml("a: {x: 1}\nlist: [1, 2]\n", "f.yaml");
  for (const char* bad : {"a", "=1", "a.x.y=1", "list.2=1", "list.-1=1", "list.one=1", "a.x=[1",
                          "a.x=*b", ".a=1", "a.=1", "a.x=\"open", "a.x=1\n---\n2"}) {
    EXPECT_NE(InputErrorOf([&] { SetYaml(root, bad); }), "") << bad;
  }
}

TEST(EmitYaml, ReadsBackToTheSameTree) {
  const char* text =
      "name: x\nnumber: -1.5e-3\nnothing:\nempty_list: []\nempty_map: {}\n"
      "list: [1, [2, 3], {a: 1, b: [4]}, ~, 'q']\nmap: {a: {b: {c: d}}}\n";
  const YamlNode root = ParseYaml(text, "f.yaml");
  const std::string emitted = EmitYaml(root);
  EXPECT_TRUE(SameTree(ParseYaml(emitted, "emitted"), root)) << emitted;
  EXPECT_EQ(EmitYaml(ParseYaml(emitted, "emitted")), emitted);
}

TEST(EmitYaml, EmptyRootIsAMapping) {
  EXPECT_TRUE(ParseYaml(EmitYaml(ParseYaml("{}", "f.yaml")), "emitted").members.empty());
}

TEST(EmitYaml, NastyStringsSurvive) {
  const char* nasty[] = {
      "",     " ",     " lead",    "trail ", "a: b",  "#hash",    "a #b", "-",     "- a",  "?",
      ": ",   "null",  "~",        "NULL",   "true",  "1e3",      "0x10", "*star", "&and", "!tag",
      "%dir", "@at",   "`tick",    "{",      "}",     "[",        "]",    ",",     "\"",   "'",
      "\\",   "\\n",   "a\nb",     "a\n",    "\ttab", "\r",       "|",    ">",     "---",  "...",
      "<<",   "äöü €", "\x01\x7f", ".",      "..",    "a\n\n  b", "=",    "0",     "+1"};
  for (const char* value : nasty) {
    for (const bool quoted : {true, false}) {
      YamlNode scalar;
      scalar.kind = YamlNode::Kind::kScalar;
      scalar.text = value;
      scalar.quoted = quoted;
      YamlNode list;
      list.kind = YamlNode::Kind::kList;
      list.items = {scalar, scalar};
      YamlNode root;
      root.kind = YamlNode::Kind::kMap;
      root.members = {{"value", scalar}, {"list", list}};
      if (*value != '\0') root.members.emplace_back(value, scalar);
      const std::string emitted = EmitYaml(root);
      YamlNode back;
      ASSERT_NO_THROW(back = ParseYaml(emitted, "emitted")) << emitted;
      EXPECT_TRUE(SameTree(back, root)) << "value '" << value << "' became\n" << emitted;
      EXPECT_TRUE(!quoted || back.Find("value")->quoted) << emitted;
    }
  }
}

}  // namespace
}  // namespace drydock
