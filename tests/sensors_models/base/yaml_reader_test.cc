#include "sensors_models/base/yaml_reader.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sensors_models/base/check.h"
#include "tests/support/input_error.h"

namespace drydock {
namespace {

using drydock::testing::InputErrorOf;

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

struct Config {
  double real = 0.0;
  double real_default = 0.0;
  std::int64_t integer = 0;
  bool flag = false;
  std::string text;
  std::string choice;
  Eigen::Vector3d vector = Eigen::Vector3d::Zero();
  std::vector<double> inner;
};

Config Read(const std::string& text) {
  const YamlNode root = ParseYaml(text, "f.yaml");
  return ReadYaml(root, [](YamlReader& yaml) {
    Config c;
    c.real = yaml.Real("real", {0.0, 10.0});
    c.real_default = yaml.Real("real_default", Bounds::Positive(), 7.0);
    c.integer = yaml.Integer("integer", {-5, 5}, 3);
    c.flag = yaml.Boolean("flag", true);
    c.text = yaml.Text("text", "fallback");
    c.choice = yaml.Choice("choice", {"red", "green"}, "red");
    c.vector = yaml.Vector3("vector", Bounds::Any(), Eigen::Vector3d(1.0, 2.0, 3.0));
    yaml.OptionalMap("map", [&](YamlReader& map) { c.inner.push_back(map.Real("x", {})); });
    yaml.List("list", [&](YamlReader& item) { c.inner.push_back(item.Real("x", {})); });
    return c;
  });
}

std::string MessageOf(const std::string& text) {
  return InputErrorOf([&] { Read(text); });
}

TEST(YamlReader, ReadsEveryKind) {
  const Config c = Read(
      "real: 2.5\nreal_default: 1\ninteger: -5\nflag: false\ntext: 'a b'\nchoice: green\n"
      "vector: [1, -2, 3e0]\nmap: {x: 4}\nlist: [{x: 5}, {x: 6}]\n");
  EXPECT_EQ(c.real, 2.5);
  EXPECT_EQ(c.real_default, 1.0);
  EXPECT_EQ(c.integer, -5);
  EXPECT_FALSE(c.flag);
  EXPECT_EQ(c.text, "a b");
  EXPECT_EQ(c.choice, "green");
  EXPECT_EQ(c.vector, Eigen::Vector3d(1.0, -2.0, 3.0));
  EXPECT_THAT(c.inner, ElementsAre(4.0, 5.0, 6.0));
}

TEST(YamlReader, DefaultsHoldWhereKeysAreMissing) {
  const Config c = Read("real: 0\n");
  EXPECT_EQ(c.real_default, 7.0);
  EXPECT_EQ(c.integer, 3);
  EXPECT_TRUE(c.flag);
  EXPECT_EQ(c.text, "fallback");
  EXPECT_EQ(c.choice, "red");
  EXPECT_EQ(c.vector, Eigen::Vector3d(1.0, 2.0, 3.0));
  EXPECT_TRUE(c.inner.empty());
}

struct Broken {
  const char* text;
  std::vector<const char*> parts;  ///< What the message must say.
};

class YamlReaderRefuses : public ::testing::TestWithParam<Broken> {};

TEST_P(YamlReaderRefuses, WithPlaceKeyAndWhatIsAllowed) {
  const std::string message = MessageOf(GetParam().text);
  ASSERT_NE(message, "") << "accepted:\n" << GetParam().text;
  for (const char* part : GetParam().parts) EXPECT_THAT(message, HasSubstr(part));
}

INSTANTIATE_TEST_SUITE_P(
    Cases, YamlReaderRefuses,
    ::testing::Values(
        Broken{"integer: 1\n", {"f.yaml", "'real'", "missing"}},
        Broken{"real: 1\nunknown_key: 2\n", {"f.yaml:2", "unknown_key", "real_default"}},
        Broken{"real: 1\nmap:\n  x: 1\n  y: 2\n", {"f.yaml:4", "map.y"}},
        Broken{"real: 1\nlist:\n- x: 1\n- {x: 1, z: 2}\n", {"f.yaml:4", "list.1.z"}},
        Broken{"real: 1\nlist:\n- y: 1\n", {"f.yaml:3", "list.0.x"}},
        Broken{"real: 1\nreal: 2\n", {"f.yaml:2", "real"}},
        Broken{"real: '1'\n", {"f.yaml:1", "real", "\"1\"", "from 0 to 10"}},
        Broken{"real: \"1\"\n", {"f.yaml:1", "\"1\""}},
        Broken{"real: .nan\n", {"f.yaml:1", ".nan"}}, Broken{"real: nan\n", {"f.yaml:1", "nan"}},
        Broken{"real: .inf\n", {"f.yaml:1", ".inf"}}, Broken{"real: inf\n", {"f.yaml:1"}},
        Broken{"real: -infinity\n", {"f.yaml:1"}}, Broken{"real: 1e999\n", {"1e999"}},
        Broken{"real: 10.001\n", {"10.001", "from 0 to 10"}}, Broken{"real: -0.1\n", {"-0.1"}},
        Broken{"real: 1.0m\n", {"1.0m"}}, Broken{"real: 1 2\n", {"1 2"}},
        Broken{"real: 1,5\n", {"1,5"}}, Broken{"real: 0x10\n", {"0x10"}},
        Broken{"real: +-1\n", {"+-1"}}, Broken{"real: --1\n", {"--1"}},
        Broken{"real: true\n", {"true"}}, Broken{"real:\n", {"nothing"}},
        Broken{"real: [1]\n", {"a list"}}, Broken{"real: {a: 1}\n", {"a mapping"}},
        Broken{"real: 1\nreal_default: 0\n", {"above 0"}},
        Broken{"real: 1\ninteger: 1.0\n", {"a whole number", "1.0"}},
        Broken{"real: 1\ninteger: 6\n", {"from -5 to 5"}},
        Broken{"real: 1\ninteger: 99999999999999999999\n", {"integer"}},
        Broken{"real: 1\nflag: yes\n", {"true or false"}},
        Broken{"real: 1\nflag: 'true'\n", {"true or false"}},
        Broken{"real: 1\ntext: [a]\n", {"text"}}, Broken{"real: 1\ntext: ''\n", {"text"}},
        Broken{"real: 1\nchoice: blue\n", {"blue", "red, green"}},
        Broken{"real: 1\nvector: [1, 2]\n", {"a list of 3 numbers"}},
        Broken{"real: 1\nvector: [1, 2, 3, 4]\n", {"a list of 3 numbers"}},
        Broken{"real: 1\nvector: [1, two, 3]\n", {"vector.1", "two"}},
        Broken{"real: 1\nvector: 1\n", {"a list of 3 numbers"}},
        Broken{"real: 1\nmap: 3\n", {"map", "mapping"}},
        Broken{"real: 1\nmap:\n", {"map", "nothing"}},
        Broken{"real: 1\nlist: {x: 1}\n", {"list", "a mapping"}},
        Broken{"real: 1\nlist: [1]\n", {"list.0", "mapping"}}));

TEST(YamlReader, UnknownKeysCanBeWarningsForForeignFiles) {
  const YamlNode root = ParseYaml("a: 1\nb: 2\nc: 3\n", "f.yaml");
  YamlReader yaml(root);
  yaml.Skip("b");
  yaml.Real("a", Bounds::Any());
  std::vector<std::string> warnings;
  yaml.Finish([&](const std::string& message) { warnings.push_back(message); });
  EXPECT_THAT(warnings, ElementsAre(AllOf(HasSubstr("f.yaml:3"), HasSubstr("'c'"))));
}

TEST(YamlReader, ASubtreeIsForAReaderOfItsOwn) {
  const YamlNode root = ParseYaml("options: {x: 3}\nlist: [1]\n", "f.yaml");
  YamlReader yaml(root);
  const YamlNode* options = yaml.OptionalSubtree("options");
  ASSERT_NE(options, nullptr);
  EXPECT_EQ(YamlReader(*options).Real("x", {}), 3.0);
  EXPECT_EQ(yaml.OptionalSubtree("missing"), nullptr);
  EXPECT_THROW(yaml.OptionalSubtree("list"), InputError);
  EXPECT_NO_THROW(yaml.Finish()) << "asked for is read";
}

TEST(YamlReader, RulesThatBindSeveralKeysNameThePlace) {
  const YamlNode root = ParseYaml("m:\n  low: 3\n  high: 2\n", "f.yaml");
  YamlReader yaml(root);
  const std::string error =
      InputErrorOf([&] { yaml.Map("m", [](YamlReader& map) { map.Fail("low", "below high"); }); });
  EXPECT_THAT(error, AllOf(HasSubstr("f.yaml:2"), HasSubstr("m.low is 3"),
                           HasSubstr("must be below high")));
}

}  // namespace
}  // namespace drydock
