// A recording in which any one file holds anything is read to its end or refused with an
// InputError. The input's first byte chooses the file (see kFiles), the rest is what stands in it.
// Files are written below TMPDIR: a folder in memory makes this ten times as fast.
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <unistd.h>

#include "scenarios/dataset/euroc_reader.h"
#include "scenarios/dataset/euroc_writer.h"
#include "sensors_models/base/check.h"
#include "tests/fuzz/require.h"

namespace drydock::fuzz {
namespace {

namespace fs = std::filesystem;

/// Chosen by 'a', 'b'… as the input's first byte.
constexpr std::array<const char*, 14> kFiles = {"imu0/data.csv",
                                                "imu0/sensor.yaml",
                                                "cam0/data.csv",
                                                "cam0/sensor.yaml",
                                                "cam1/data.csv",
                                                "cam1/sensor.yaml",
                                                "sonar0/data.csv",
                                                "sonar0/sensor.yaml",
                                                "pressure0/data.csv",
                                                "pressure0/sensor.yaml",
                                                "state_groundtruth_estimate0/data.csv",
                                                "cam0/data/0.png",
                                                "arrivals.csv",
                                                "rig.yaml"};
/// From here on: files that only our own recordings have.
constexpr std::size_t kFirstOfOurs = 12;

Rig SmallRig() {
  Rig rig;
  rig.name = "small";
  rig.stereo.rate_hz = 10;
  for (CameraIntrinsics& camera : rig.stereo.cameras)
    camera = {.width = 16, .height = 16, .fx = 20.0, .fy = 20.0, .cx = 8.0, .cy = 8.0};
  rig.imu = {.rate_hz = 100.0, .gyro_noise_density = 1e-4, .accel_noise_density = 1e-3};
  rig.sonar.rate_hz = 100.0;
  rig.sonar.step_rad = 0.5;
  rig.sonar.min_range_m = 0.1;
  rig.sonar.max_range_m = 6.0;
  rig.depth.rate_hz = 1.0;
  return rig;
}

void Record(const fs::path& target) {
  dataset::EurocWriter writer(SmallRig(), target);
  for (int k = 0; k < 3; ++k) {
    const Time t{k * 100'000'000};
    writer.Add({t, t, ImuSample{{0, 0, 0.1 * k}, {0, 0, 9.81}}});
    writer.Add({t, t + Duration{1000}, SonarPing{0.5 * k, 1.0 * k, 0.5, 1.0 * k, {}}});
    writer.Add({t, t + Duration{2000}, DepthSample{6.0}});
    const cv::Mat image(16, 16, CV_8UC1, cv::Scalar(50.0 * k));
    writer.Add({t, t + Duration{3000}, StereoFrame{k, {image, image}}});
    writer.AddTruth(t, {});
  }
  writer.Commit();
}

/// Two recordings in a folder of this process: one with our own extra files and one without them.
class Recordings {
 public:
  Recordings() : folder_(fs::temp_directory_path() / fmt::format("fuzz_euroc-{}", ::getpid())) {
    Record(ours());
    Record(plain());
    fs::remove(plain() / "mav0" / "arrivals.csv");
    fs::remove(plain() / "mav0" / "rig.yaml");
  }
  ~Recordings() { fs::remove_all(folder_); }
  Recordings(const Recordings&) = delete;
  Recordings& operator=(const Recordings&) = delete;

  fs::path ours() const { return folder_ / "ours"; }
  fs::path plain() const { return folder_ / "plain"; }

 private:
  fs::path folder_;
};

void Write(const fs::path& path, std::string_view content) {
  std::ofstream stream(path, std::ios::binary | std::ios::trunc);
  stream.write(content.data(), static_cast<std::streamsize>(content.size()));
}

void ReadAll(const fs::path& target) {
  try {
    const dataset::EurocReader reader(target);
    for (std::size_t i = 0; i < reader.size(); ++i) {
      const Measurement measurement = reader.Read(i);
      Require(measurement.t.ns >= 0 && measurement.t_arrival >= measurement.t,
              "what arrives has been measured");
    }
    const auto truth = reader.ReadTruth();
    for (std::size_t i = 1; i < truth.size(); ++i)
      Require(truth[i - 1].t < truth[i].t, "true times increase");
  } catch (const InputError& error) {
    Require(std::string_view(error.what()).starts_with(target.c_str()), "an error names its file");
  }
}

void Run(std::string_view input) {
  static const Recordings recordings;
  if (input.empty()) return;
  const std::size_t choice = static_cast<unsigned char>(input[0] - 'a') % kFiles.size();
  const fs::path target = choice < kFirstOfOurs ? recordings.plain() : recordings.ours();
  const fs::path file = target / "mav0" / kFiles[choice];
  const fs::path kept = target / "kept";
  fs::rename(file, kept);
  Write(file, input.substr(1));
  ReadAll(target);
  fs::rename(kept, file);
}

}  // namespace
}  // namespace drydock::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  drydock::fuzz::Run({reinterpret_cast<const char*>(data), size});
  return 0;
}
