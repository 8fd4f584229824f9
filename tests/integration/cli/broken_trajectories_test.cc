// `drydock score` on trajectories that cannot be used.
#include "sensors_models/base/files.h"
#include "tests/integration/cli/broken_files.h"

namespace drydock::testing {
namespace {

class BrokenTrajectory : public BrokenFilesTest {
 protected:
  BrokenTrajectory() {
    std::string text = "# timestamp tx ty tz qx qy qz qw\n";
    for (int k = 0; k < 9; ++k)
      text += "10" + std::to_string(k) + ".5 1 2 " + std::to_string(k) + " 0 0 0 1\n";
    WriteFileAtomically(inputs() / "truth.tum", text);
    WriteFileAtomically(inputs() / "estimate.tum", text);
  }
};

TEST_P(BrokenTrajectory, IsRefused) { ExpectRefusal(GetParam()); }

const std::vector<std::string> kScore = {"score", "@truth.tum", "@estimate.tum"};

Broken Estimate(const char* name, How how, const char* says) {
  return {name, kScore, "estimate.tum", std::move(how), {says}};
}

// The third pose stands in line 4: "102.5 1 2 2 0 0 0 1".
const Broken kRows[] = {
    Estimate("SevenColumns", Edit("102.5 1 2 2 0", "102.5 1 2 2"),
             "@estimate.tum:4: 7 values, must be 8"),
    Estimate("NineColumns", Edit("102.5 1", "102.5 1 1"), "@estimate.tum:4: 9 values, must be 8"),
    Estimate("Commas", Edit("102.5 1 2 2 0 0 0 1", "102.5,1,2,2,0,0,0,1"),
             "@estimate.tum:4: 1 values"),
    Estimate("UnsortedStamps", Edit("102.5", "100.75"),
             "@estimate.tum:4: t is 100.750000000, must be later than"),
    Estimate("DuplicateStamps", Edit("102.5", "101.5"),
             "@estimate.tum:4: t is 101.500000000, must be later than"),
    Estimate("StampsInNanoseconds", Edit("102.5", "1403636579763555584"),
             "@estimate.tum:4: t is '1403636579763555584'"),
    Estimate("Nan", Edit("102.5 1", "102.5 nan"), "@estimate.tum:4: tx is 'nan', must be a number"),
    Estimate("Infinity", Edit("102.5 1", "102.5 -inf"),
             "@estimate.tum:4: tx is '-inf', must be a number"),
    Estimate("EnormousNumber", Edit("102.5 1", "102.5 1e300"),
             "@estimate.tum:4: tx is '1e300', must be a number from -1e9"),
    Estimate("BeyondDouble", Edit("102.5 1", "102.5 1e999"), "@estimate.tum:4: tx is '1e999'"),
    Estimate("Hexadecimal", Edit("102.5 1", "102.5 0x1"), "@estimate.tum:4: tx is '0x1'"),
    Estimate("NoUnitQuaternion", Edit("102.5 1 2 2 0 0 0 1", "102.5 1 2 2 0 0 1 1"),
             "@estimate.tum:4: the quaternion's length is 1.41"),
    Estimate("ZeroQuaternion", Edit("102.5 1 2 2 0 0 0 1", "102.5 1 2 2 0 0 0 0"),
             "@estimate.tum:4: the quaternion's length is 0"),
    Estimate("Text", Whole("Dear diary, today we dived.\n"), "@estimate.tum:1: 5 values"),
    Estimate("Empty", Whole(""), "@estimate.tum: holds no poses"),
    Estimate("CommentsOnly", Whole("# nothing\n"), "@estimate.tum: holds no poses"),
    Estimate("HugeLine", Append(std::string(5'000'000, '7') + "\n"), "@estimate.tum:11: 1 values"),
    Estimate("HugeNumber", Append(std::string(5'000'000, '7') + " 1 2 3 0 0 0 1\n"),
             "@estimate.tum:11: t is '7777"),
    Estimate("BinaryGarbage",
             Whole(std::string("\x7f"
                               "ELF\0\1\2\3\xff\xfe",
                               10)),
             "@estimate.tum:1: 1 values"),
    Estimate("Utf16", Utf16(), "@estimate.tum:1: "),
    Estimate("ByteOrderMark", Edit("# time", "\xef\xbb\xbf# time"), "@estimate.tum:1: "),
    Estimate("AFolder", Folder(), "@estimate.tum: is a folder, must be a file"),
    Estimate("Missing", Remove(), "@estimate.tum: no such file"),
    Estimate("OtherTimes", Whole("5 1 2 3 0 0 0 1\n6 1 2 4 0 0 0 1\n"),
             "@estimate.tum against @truth.tum: "),
    Estimate("OnePose", Whole("101.5 1 2 3 0 0 0 1\n"), "@estimate.tum against @truth.tum: "),
    {"EmptyTruth", kScore, "truth.tum", Whole(""), {"@truth.tum: holds no poses"}},
    {"UnknownAlignment",
     {"score", "@truth.tum", "@estimate.tum", "--align", "sideways"},
     "",
     {},
     {"sideways"}},
    {"NoEstimate", {"score", "@truth.tum"}, "", {}, {"estimate is required"}},
    {"UnknownCommand", {"frob"}, "", {}, {"'frob'", "must be one of", "score", "--help"}},
};

INSTANTIATE_TEST_SUITE_P(All, BrokenTrajectory, ::testing::ValuesIn(kRows), NameOf);

}  // namespace
}  // namespace drydock::testing
