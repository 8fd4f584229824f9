// `drydock estimate` on recordings, rigs and options that cannot be used.
#include "sensors_models/base/files.h"
#include "tests/integration/cli/broken_files.h"
#include "tests/integration/cli/recording.h"

namespace drydock::testing {
namespace {

class BrokenRecording : public BrokenFilesTest {
 protected:
  BrokenRecording() { RecordGlide(inputs() / "glide"); }
};

TEST_P(BrokenRecording, IsRefused) { ExpectRefusal(GetParam()); }

const std::vector<std::string> kEstimate = {
    "estimate", "@glide", "--estimator", "dead-reckoning", "--start-from-truth", "-o", "result"};

Broken File(const char* name, const std::string& file, How how, const std::string& says) {
  return {name, kEstimate, "glide/mav0/" + file, std::move(how), {"@glide/mav0/" + says}};
}

Broken Options(const char* name, std::vector<std::string> options, const char* says) {
  options.insert(options.begin(), "estimate");
  return {name, std::move(options), "", {}, {says}};
}

// Row k of a table stands in line k + 2. Stamps are in nanoseconds from 100 s on.
const Broken kTables[] = {
    File("ImuMissing", "imu0", Remove(), "imu0/sensor.yaml: no such file"),
    File("ImuTableMissing", "imu0/data.csv", Remove(), "imu0/data.csv: no such file"),
    File("ImuTableIsAFolder", "imu0/data.csv", Folder(), "imu0/data.csv: is a folder"),
    File("ImuTableEmpty", "imu0/data.csv", Whole(""),
         "arrivals.csv:2: timestamp is '100000000000', must be the time of a row of imu0/data.csv"),
    File("ImuColumnMissing", "imu0/data.csv", Edit("\n100050000000,0,", "\n100050000000,"),
         "imu0/data.csv:3: 6 fields, must be 7"),
    File("ImuNan", "imu0/data.csv", Edit("\n100050000000,0", "\n100050000000,nan"),
         "imu0/data.csv:3: w_RS_S_x is 'nan'"),
    File("ImuEnormous", "imu0/data.csv", Edit("\n100050000000,0", "\n100050000000,1e200"),
         "imu0/data.csv:3: w_RS_S_x is '1e200', must be a number from -1e9"),
    File("ImuUnsorted", "imu0/data.csv", Edit("\n100050000000", "\n99950000000"),
         "imu0/data.csv:3: timestamp is '99950000000', must be later than the 100000000000"),
    File("ImuDuplicate", "imu0/data.csv", Edit("\n100050000000", "\n100000000000"),
         "imu0/data.csv:3: timestamp is '100000000000', must be later than the 100000000000"),
    File("ImuSeconds", "imu0/data.csv", Edit("\n100050000000", "\n100.05"),
         "imu0/data.csv:3: timestamp is '100.05', must be a time in whole nanoseconds"),
    File("ImuNegativeTime", "imu0/data.csv", Edit("\n100000000000", "\n-1"),
         "imu0/data.csv:2: timestamp is '-1'"),
    File("ImuFarFuture", "imu0/data.csv", Edit("\n101000000000", "\n9223372036854775807"),
         "imu0/data.csv:22: timestamp is '9223372036854775807'"),
    File("ImuBinary", "imu0/data.csv", Whole(std::string("\x89\0\xff,\n,,", 7)),
         "imu0/data.csv:1: 2 fields, must be 7"),
    File("ImuUtf16", "imu0/data.csv", Utf16(), "imu0/data.csv:1: "),
    File("CameraFolderMissing", "cam1", Remove(), "cam1/sensor.yaml: no such file"),
    File("CameraTableMissing", "cam0/data.csv", Remove(), "cam0/data.csv: no such file"),
    File("CameraColumnMissing", "cam0/data.csv", Edit(",100200000000.png", ""),
         "cam0/data.csv:3: 1 fields, must be 2"),
    File("CameraUnsorted", "cam0/data.csv", Edit("\n100200000000,", "\n100,"),
         "cam0/data.csv:3: timestamp is '100', must be later"),
    File("CameraNameOutside", "cam1/data.csv", Edit(",100200000000.png", ",../../x.png"),
         "cam1/data.csv:3: filename is '../../x.png', must be the name of a file without a folder"),
    File("ImageMissing", "cam0/data/100200000000.png", Remove(),
         "cam0/data/100200000000.png: no such file"),
    File("NoImages", "cam0/data", Remove(), "cam0/data/100000000000.png: no such file"),
    File("ImageTruncated", "cam1/data/100400000000.png", CutOff(30),
         "cam1/data/100400000000.png: an image that cannot be read"),
    File("ImageEmpty", "cam1/data/100400000000.png", Whole(""),
         "cam1/data/100400000000.png: an image that cannot be read"),
    File("ImageIsText", "cam1/data/100400000000.png", Whole("no picture"),
         "cam1/data/100400000000.png: an image that cannot be read"),
    File("ImageOfAnotherSize", "cam1/data/100400000000.png",
         Edit(std::string("\0\0\0\x20\0\0\0\x18", 8), std::string("\0\0\0\x10\0\0\0\x18", 8)),
         "cam1/data/100400000000.png: is 16x24 px, must be 32x24"),
    File("ImageClaimsGigabytes", "cam1/data/100400000000.png",
         Edit(std::string("\0\0\0\x20\0\0\0\x18", 8), std::string("\0\1\0\0\0\1\0\0", 8)),
         "cam1/data/100400000000.png: is 65536x65536 px, must be 32x24"),
    File("SonarRangeNegative", "sonar0/data.csv", Edit("\n100100000000,1.5", "\n100100000000,-1.5"),
         "sonar0/data.csv:3: range is '-1.5', must be at least 0"),
    File("PressureText", "pressure0/data.csv", Edit("\n101000000000,2", "\n101000000000,deep"),
         "pressure0/data.csv:3: depth is 'deep'"),
    File("TruthColumns", "state_groundtruth_estimate0/data.csv",
         Edit("\n100050000000,", "\n100050000000,1,"),
         "state_groundtruth_estimate0/data.csv:3: 18 fields"),
    File("TruthQuaternion", "state_groundtruth_estimate0/data.csv",
         Edit("\n100050000000,1.025,2.00025,3,1", "\n100050000000,1.025,2.00025,3,2"),
         "state_groundtruth_estimate0/data.csv:3: the quaternion's length is 2"),
    File("ArrivalOfNothing", "arrivals.csv",
         Edit("100050000000,100050000000,imu0", "100050000001,100050000001,imu0"), "arrivals.csv:"),
    File("ArrivalUnsorted", "arrivals.csv",
         Edit("100050000000,100050000000,imu0", "100050000000,100950000000,imu0"),
         "arrivals.csv:7: arrival is '100100000000', must be at least the 100950000000 before it"),
};

const Broken kSheets[] = {
    File("SensorFileMissing", "cam0/sensor.yaml", Remove(), "cam0/sensor.yaml: no such file"),
    File("SensorFileEmpty", "cam0/sensor.yaml", Whole(""), "cam0/sensor.yaml: is empty"),
    File("SensorFileBinary", "cam0/sensor.yaml", Whole(std::string("\0\1\2\3", 4)),
         "cam0/sensor.yaml:1: is not UTF-8 text"),
    File("SensorFileSyntax", "imu0/sensor.yaml", Edit("rate_hz: 20", "rate_hz: [20"),
         "imu0/sensor.yaml:"),
    File("SensorKeyMissing", "imu0/sensor.yaml", Edit("rate_hz: 20\n", ""),
         "imu0/sensor.yaml:1: the key 'rate_hz' is missing"),
    File("SensorRateNegative", "imu0/sensor.yaml", Edit("rate_hz: 20", "rate_hz: -20"),
         "imu0/sensor.yaml:10: rate_hz is -20, must be a number from"),
    File("SensorType", "imu0/sensor.yaml", Edit("sensor_type: imu", "sensor_type: sextant"),
         "imu0/sensor.yaml:1: sensor_type is sextant, must be one of imu"),
    File("SensorMatrix", "cam0/sensor.yaml", Edit("0.0, 0.0, 0.0, 1.0]", "0.0, 0.0, 0.0, 2.0]"),
         "cam0/sensor.yaml:6: T_BS.data is a list, must be a rotation"),
    File("SensorModel", "cam0/sensor.yaml", Edit("pinhole", "omni"),
         "cam0/sensor.yaml:12: camera_model is omni, must be one of pinhole"),
    File("SensorsOfDifferentSizes", "cam1/sensor.yaml", Edit("[32, 24]", "[64, 48]"),
         "cam1/sensor.yaml:11: resolution is a list, must be that of cam0"),
    File("RigContradictsSensors", "rig.yaml", Edit("rate_hz: 20", "rate_hz: 21"),
         "rig.yaml: does not say the same of imu0"),
};

const Broken kOptions[] = {
    Options("NoSuchRecording", {"@nowhere", "-o", "result"}, "@nowhere: no such folder"),
    Options("NoRecording", {"@", "-o", "result"}, "@: no recording in EuRoC's layout"),
    Options("RecordingIsAFile", {"@glide/mav0/rig.yaml", "-o", "result"},
            "rig.yaml: no recording in EuRoC's layout"),
    Options("UnknownEstimator", {"@glide", "--estimator", "crystal-ball", "-o", "result"},
            "estimator is crystal-ball, must be one of dead-reckoning"),
    Options("UnknownRig", {"@glide", "--start-from-truth", "--rig", "trireme", "-o", "result"},
            "rig is trireme, must be one of "),
    Options("UnknownOption",
            {"@glide", "--estimator", "dead-reckoning", "--start-from-truth", "--set", "glow=3",
             "-o", "result"},
            "--set glow=3: unknown key 'glow'; known here: none"),
    Options("OptionWithoutValue", {"@glide", "--set", "glow", "-o", "result"},
            "--set glow: must be key.path=value"),
    Options("NoStart", {"@glide", "--estimator", "dead-reckoning", "-o", "result"},
            "dead-reckoning has to be told where it starts; --start-from-truth"),
    Options("NoOutput", {"@glide"}, "--output is required"),
    Options("OutputIsAFile", {"@glide", "--start-from-truth", "-o", "@glide/mav0/body.yaml"},
            "@glide/mav0/body.yaml: is a file, must be a folder"),
    Options("OutputBelowAFile",
            {"@glide", "--start-from-truth", "-o", "@glide/mav0/body.yaml/result"}, "body.yaml"),
    Options("OutputIsTheRecording", {"@glide", "--start-from-truth", "-o", "@glide"},
            "holds the recording"),
    Options("OutputHoldsOtherThings", {"@glide", "--start-from-truth", "-o", "@glide/mav0/cam0"},
            "@glide/mav0/cam0: holds other things"),
    {"NoTruthToStartFrom",
     kEstimate,
     "glide/mav0/state_groundtruth_estimate0",
     Remove(),
     {"@glide: the recording has no ground truth to start from"}},
    {"TruthOfPosesAlone",
     kEstimate,
     "glide/mav0/state_groundtruth_estimate0/data.csv",
     Whole("100000000000,1,2,3,1,0,0,0\n"),
     {"@glide: the ground truth has poses alone"}},
    {"TruthTooLate",
     kEstimate,
     "glide/mav0/state_groundtruth_estimate0/data.csv",
     Whole("200000000000,1,2,3,1,0,0,0,0,0,0,0,0,0,0,0,0\n"),
     {"@glide: the ground truth begins after the last measurement"}},
};

INSTANTIATE_TEST_SUITE_P(Tables, BrokenRecording, ::testing::ValuesIn(kTables), NameOf);
INSTANTIATE_TEST_SUITE_P(Sheets, BrokenRecording, ::testing::ValuesIn(kSheets), NameOf);
INSTANTIATE_TEST_SUITE_P(Options, BrokenRecording, ::testing::ValuesIn(kOptions), NameOf);

}  // namespace
}  // namespace drydock::testing
