#include "scenarios/dataset/csv.h"

#include <functional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sensors_models/base/check.h"
#include "tests/support/input_error.h"

namespace drydock::dataset {
namespace {

using drydock::testing::InputErrorOf;

using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(Csv, ReadsRowsAndSkipsWhatIsNone) {
  const std::string text = "#timestamp [ns],x,name\r\n\r\n 5 , -1.5e-3 ,a.png\r\n\n7,2,b c.png";
  CsvReader csv(text, "d.csv", {"timestamp", "x", "name"});
  ASSERT_TRUE(csv.Next());
  EXPECT_EQ(csv.IncreasingStamp(0).ns, 5);
  EXPECT_EQ(csv.Real(1), -1.5e-3);
  EXPECT_EQ(csv.FileName(2), "a.png");
  EXPECT_EQ(csv.Place(), "d.csv:3");
  ASSERT_TRUE(csv.Next());
  EXPECT_EQ(csv.IncreasingStamp(0).ns, 7);
  EXPECT_EQ(csv.Integer(1), 2);
  EXPECT_EQ(csv.Text(2), "b c.png");
  EXPECT_FALSE(csv.Next());
  EXPECT_FALSE(csv.Next());
}

TEST(Csv, OptionalColumnsAtTheEnd) {
  CsvReader csv("1,2\n3,4,5\n", "d.csv", {"a", "b", "c"}, 2);
  ASSERT_TRUE(csv.Next());
  EXPECT_EQ(csv.size(), 2U);
  ASSERT_TRUE(csv.Next());
  EXPECT_EQ(csv.size(), 3U);
}

struct Broken {
  const char* name;
  const char* row;  ///< Stands in line 3 after "5,1,a.png".
  const char* says;
};

class BrokenCsv : public ::testing::TestWithParam<Broken> {};

TEST_P(BrokenCsv, IsNamedWithFileLineAndColumn) {
  const std::string text = std::string("#timestamp,x,name\n5,1,a.png\n") + GetParam().row + "\n";
  CsvReader csv(text, "d.csv", {"timestamp", "x", "name"});
  const std::string error = InputErrorOf([&] {
    while (csv.Next()) {
      csv.IncreasingStamp(0);
      csv.Real(1);
      csv.FileName(2);
    }
  });
  EXPECT_THAT(error, AllOf(HasSubstr("d.csv:3: "), HasSubstr(GetParam().says)));
}

INSTANTIATE_TEST_SUITE_P(
    Rows, BrokenCsv,
    ::testing::Values(Broken{"TooFew", "6,1", "2 fields, must be 3"},
                      Broken{"TooMany", "6,1,a.png,", "4 fields"},
                      Broken{"Enormous", "6,1.1e9,a.png", "x is '1.1e9'"},
                      Broken{"NoNumber", "6,one,a.png", "x is 'one', must be a number from -1e9"},
                      Broken{"Empty", "6,,a.png", "x is ''"},
                      Broken{"Nan", "6,nan,a.png", "x is 'nan'"},
                      Broken{"Inf", "6,-inf,a.png", "x is '-inf'"},
                      Broken{"Overflow", "6,1e999,a.png", "x is '1e999'"},
                      Broken{"StampSeconds", "6.5,1,a.png", "timestamp is '6.5'"},
                      Broken{"StampNegative", "-6,1,a.png", "whole nanoseconds from 0 to"},
                      Broken{"StampFar", "4600000000000000001,1,a.png", "timestamp"},
                      Broken{"StampHuge", "99999999999999999999,1,a.png", "timestamp"},
                      Broken{"StampSame", "5,1,a.png", "later than the 5"},
                      Broken{"StampEarlier", "4,1,a.png", "later than the 5"},
                      Broken{"Semicolons", "6;1;a.png", "1 fields"},
                      Broken{"HeaderWithoutHash", "timestamp,x,name", "timestamp is 'timestamp'"},
                      Broken{"NoName", "6,1,", "name is ''"},
                      Broken{"FolderInName", "6,1,../a.png", "without a folder"},
                      Broken{"AbsoluteName", "6,1,/etc/passwd", "without a folder"},
                      Broken{"DotDot", "6,1,..", "without a folder"}),
    [](const auto& test) { return test.param.name; });

TEST(Csv, WholeNumbers) {
  CsvReader csv("1.5,x\n", "d.csv", {"a", "b"});
  ASSERT_TRUE(csv.Next());
  EXPECT_THROW(csv.Integer(0), InputError);
  EXPECT_THROW(csv.Stamp(1), InputError);
}

}  // namespace
}  // namespace drydock::dataset
