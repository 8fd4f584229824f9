#include "scenarios/dataset/parse.h"

#include <string>

#include <gtest/gtest.h>

namespace drydock::dataset {
namespace {

TEST(ParseSeconds, IsExactToTheNanosecond) {
  const std::pair<const char*, std::int64_t> cases[] = {
      {"0", 0},
      {"1600000000.1036668", 1'600'000'000'103'666'800},
      {"1403636579.763555584", 1'403'636'579'763'555'584},
      {"1600000000", 1'600'000'000'000'000'000},
      {"-0.5", -500'000'000},
      {"+2.000000001", 2'000'000'001},
      {"0.0000000005", 1},
      {"0.00000000049999", 0},
      {"1.0000000015", 1'000'000'002},
      {"1.600000000103666800e+09", 1'600'000'000'103'666'800},
      {"16E8", 1'600'000'000'000'000'000},
      {"1e-9", 1},
      {"5e-10", 1},
      {"4e-10", 0},
      {"1e-400", 0},
      {".5", 500'000'000},
      {"5.", 5'000'000'000},
      {"000012.5", 12'500'000'000},
      {"0.30000000000000004", 300'000'000},
      {"4600000000", 4'600'000'000'000'000'000},
      {"0e9999", 0},
  };
  for (const auto& [text, ns] : cases) {
    const auto t = ParseSeconds(text);
    // "1e-400" and "0e9999" may also be refused as numbers that no double holds.
    if (!t && std::string_view(text).find("e") != std::string_view::npos) continue;
    ASSERT_TRUE(t.has_value()) << text;
    EXPECT_EQ(t->ns, ns) << text;
  }
}

TEST(ParseSeconds, RefusesWhatIsNoTime) {
  for (const char* text :
       {"", " ", "1 ", "a", "1.2.3", "nan", "inf", "1e", "1e400", "0x1p3", "4600000001",
        "-4600000001", "1e19", "--1", "+-1", "1,5", "-", ".", "1e+"}) {
    EXPECT_FALSE(ParseSeconds(text).has_value()) << text;
  }
}

TEST(FormatSeconds, ComesBack) {
  for (const std::int64_t ns :
       {0L, 1L, -1L, 999'999'999L, 1'600'000'000'103'666'801L, -1'500'000'000L}) {
    EXPECT_EQ(ParseSeconds(FormatSeconds(Time{ns}))->ns, ns);
  }
  EXPECT_EQ(FormatSeconds(Time{-500'000'000}), "-0.500000000");
}

TEST(ParseReal, WholeTextAndFinite) {
  EXPECT_EQ(ParseReal("1e-3"), 1e-3);
  EXPECT_EQ(ParseReal("+1.5"), 1.5);
  for (const char* text : {"", "nan", "inf", "-inf", "1x", " 1", "1e999", "+-1"}) {
    EXPECT_FALSE(ParseReal(text).has_value()) << text;
  }
}

TEST(LineReader, EndsOfLines) {
  LineReader lines("a\r\n\nb\r\nc");
  EXPECT_EQ(lines.Next(), "a");
  EXPECT_EQ(lines.Next(), "");
  EXPECT_EQ(lines.Next(), "b");
  EXPECT_EQ(lines.number(), 3);
  EXPECT_EQ(lines.Next(), "c");
  EXPECT_EQ(lines.Next(), std::nullopt);
  EXPECT_EQ(lines.number(), 4);
}

TEST(Quoted, IsShortAndPrintable) {
  EXPECT_EQ(Quoted("a\x01z\xff"), "'a?z?'");
  EXPECT_LT(Quoted(std::string(1000, 'x')).size(), 50U);
}

}  // namespace
}  // namespace drydock::dataset
