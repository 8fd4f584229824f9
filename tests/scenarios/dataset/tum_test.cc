#include "scenarios/dataset/tum.h"

#include <cmath>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sensors_models/base/check.h"
#include "sensors_models/base/files.h"
#include "sensors_models/base/random_stream.h"
#include "tests/support/input_error.h"

namespace drydock::dataset {
namespace {

using drydock::testing::InputErrorOf;

using ::testing::AllOf;
using ::testing::HasSubstr;

Trajectory RandomTrajectory(int count) {
  RandomStream random(1, "tum");
  Trajectory trajectory;
  Time t{1'600'000'000'000'000'000};
  for (int i = 0; i < count; ++i) {
    t.ns += 1 + static_cast<std::int64_t>(random.Uniform(0.0, 1e8));
    const Eigen::Quaterniond q(random.Gaussian(), random.Gaussian(), random.Gaussian(),
                               random.Gaussian());
    const Eigen::Vector3d p(random.Gaussian(), 1e-12 * random.Gaussian(), 1e6 * random.Gaussian());
    trajectory.push_back({t, Pose(q, p)});
  }
  return trajectory;
}

TEST(Tum, RoundTripIsExact) {
  const Trajectory trajectory = RandomTrajectory(1000);
  const std::string text = FormatTum(trajectory);
  const Trajectory back = ParseTum(text, "t.tum");
  ASSERT_EQ(back.size(), trajectory.size());
  for (std::size_t i = 0; i < back.size(); ++i) {
    ASSERT_EQ(back[i].t, trajectory[i].t);
    ASSERT_EQ(back[i].T_WI.p(), trajectory[i].T_WI.p());
    ASSERT_EQ(back[i].T_WI.q().coeffs(), trajectory[i].T_WI.q().coeffs());
  }
  EXPECT_EQ(FormatTum(back), text);
}

TEST(Tum, WritesSingleSpacesAndNoneAtTheEnd) {
  const std::string text =
      FormatTum({{Time{1'500'000'001}, Pose(Eigen::Quaterniond::Identity(), {0.1, -2.0, 3.0})}});
  EXPECT_EQ(text,
            "# timestamp tx ty tz qx qy qz qw\n"
            "1.500000001 0.10000000000000001 -2 3 0 0 0 1\n");
}

TEST(Tum, FilesGoBothWays) {
  const auto path = std::filesystem::path(::testing::TempDir()) / "drydock_tum_test/t.tum";
  WriteTum(path, RandomTrajectory(3));
  EXPECT_EQ(ReadTum(path).size(), 3U);
  std::filesystem::remove_all(path.parent_path());
  EXPECT_THROW(ReadTum(path), InputError);
}

TEST(Tum, ToleratesCommentsEmptyLinesBlanksAndCrlf) {
  const Trajectory trajectory = ParseTum(
      "# a comment\r\n"
      "\r\n"
      "1.5 1 2 3 0 0 0 1\r\n"
      "  # indented comment\n"
      "\t2.5   1e0  +2 3.0 0 0 0 -1 \n"
      "3.5 1 2 3 0 0 0 1.0005",
      "t.tum");
  ASSERT_EQ(trajectory.size(), 3U);
  EXPECT_EQ(trajectory[1].t.ns, 2'500'000'000);
  EXPECT_EQ(trajectory[1].T_WI.p(), Eigen::Vector3d(1.0, 2.0, 3.0));
  EXPECT_NEAR(trajectory[2].T_WI.q().norm(), 1.0, 1e-15);
}

TEST(Tum, QuaternionIsXyzw) {
  const Trajectory trajectory = ParseTum("0 0 0 0 0.5 -0.5 0.5 0.5\n", "t.tum");
  EXPECT_EQ(trajectory[0].T_WI.q().coeffs(), Eigen::Vector4d(0.5, -0.5, 0.5, 0.5));
}

TEST(Tum, EmptyFileIsAnEmptyTrajectory) {
  EXPECT_TRUE(ParseTum("", "t.tum").empty());
  EXPECT_TRUE(ParseTum("# only a comment", "t.tum").empty());
}

struct Broken {
  const char* name;
  const char* line;  ///< Stands in line 3, after a good pose in line 2.
  const char* says;
};

class BrokenTum : public ::testing::TestWithParam<Broken> {};

TEST_P(BrokenTum, IsNamedWithFileAndLine) {
  const std::string text =
      std::string("# header\n1 0 0 0 0 0 0 1\n") + GetParam().line + "\n9 0 0 0 0 0 0 1\n";
  const std::string error = InputErrorOf([&] { ParseTum(text, "t.tum"); });
  EXPECT_THAT(error, AllOf(HasSubstr("t.tum:3: "), HasSubstr(GetParam().says)));
}

INSTANTIATE_TEST_SUITE_P(
    Lines, BrokenTum,
    ::testing::Values(
        Broken{"SevenValues", "2 0 0 0 0 0 1", "7 values"},
        Broken{"NineValues", "2 0 0 0 0 0 0 1 5", "9 values"}, Broken{"OneValue", "2", "1 values"},
        Broken{"Commas", "2,0,0,0,0,0,0,1", "1 values"},
        Broken{"Word", "2 0 zero 0 0 0 0 1", "ty is 'zero'"},
        Broken{"Nan", "2 nan 0 0 0 0 0 1", "tx is 'nan'"},
        Broken{"NanQuaternion", "2 0 0 0 0 0 0 nan", "qw is 'nan'"},
        Broken{"Inf", "2 0 0 inf 0 0 0 1", "tz is 'inf'"},
        Broken{"Overflow", "2 0 0 1e999 0 0 0 1", "tz is '1e999'"},
        Broken{"Hex", "2 0x1 0 0 0 0 0 1", "tx is '0x1'"},
        Broken{"DecimalComma", "2 0,5 0 0 0 0 0 1", "tx is '0,5'"},
        Broken{"ZeroQuaternion", "2 0 0 0 0 0 0 0", "length is 0"},
        Broken{"LongQuaternion", "2 0 0 0 0 0 0 1.01", "length is 1.01"},
        Broken{"HugeQuaternion", "2 0 0 0 1e200 0 0 1e200", "qx is '1e200'"},
        Broken{"SameTime", "1 0 0 0 0 0 0 1", "later than the 1.000000000"},
        Broken{"SameTimeOtherwiseWritten", "1.0000000001 0 0 0 0 0 0 1", "later than"},
        Broken{"EarlierTime", "0.5 0 0 0 0 0 0 1", "t is 0.500000000"},
        Broken{"TimeNan", "nan 0 0 0 0 0 0 1", "t is 'nan'"},
        Broken{"TimeInNanoseconds", "1403636579763555584 0 0 0 0 0 0 1", "seconds within"},
        Broken{"TimeWord", "two 0 0 0 0 0 0 1", "t is 'two'"},
        Broken{"TrailingComment", "2 0 0 0 0 0 0 1 # ok", "10 values"},
        Broken{"Binary", "\x01\xfe\xff", "1 values"}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace drydock::dataset
