// A small recording for tests.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "scenarios/dataset/euroc_writer.h"
#include "sensors_models/base/files.h"
#include "sensors_models/base/random_stream.h"

namespace drydock::dataset {

/// A rig with small images, sonar and pressure sensor.
inline Rig SmallRig() {
  Rig rig = LoadRig(FindRig("svin2_v3"));
  for (CameraIntrinsics& camera : rig.stereo.cameras) {
    camera.width = 32;
    camera.height = 24;
  }
  return rig;
}

inline cv::Mat NoiseImage(RandomStream& random, int type) {
  cv::Mat image(24, 32, type);
  for (std::size_t i = 0; i < image.total() * image.elemSize(); ++i) {
    image.data[i] = static_cast<unsigned char>(random.Bits());
  }
  return image;
}

/// Two seconds of noise: IMU at 20 Hz, frames at 5 Hz (the sixth missing), pings at 10 Hz, depth at
/// 1 Hz, in the order of arrival, which differs from that of the stamps.
inline std::vector<Measurement> SmallDive(int image_type = CV_8UC1) {
  RandomStream random(1, "dive");
  std::vector<Measurement> dive;
  const auto add = [&](Time t, double latency_s, Reading reading) {
    dive.push_back({t, t + Duration::FromSeconds(latency_s), std::move(reading)});
  };
  const auto vector = [&] {
    return Eigen::Vector3d(random.Gaussian(), random.Gaussian() * 1e-9, random.Gaussian() * 1e6);
  };
  const Time start{1'600'000'000'000'000'000};
  for (int k = 0; k < 40; ++k) add(SampleTime(start, k, 20), 0.0, ImuSample{vector(), vector()});
  for (int k = 0; k < 10; ++k) {
    if (k == 5) continue;
    StereoFrame frame;
    frame.index = k;
    frame.images = {NoiseImage(random, image_type), NoiseImage(random, image_type)};
    add(SampleTime(start, k, 5), random.Uniform(0.0, 0.3), frame);
  }
  for (int k = 0; k < 20; ++k) {
    const double range = k % 3 == 0 ? 0.0 : random.Uniform(0.1, 6.0);
    SonarPing ping{random.Uniform(0.0, 6.28), range, 0.5, 0.5 * range, {}};
    if (k % 5 != 0) ping.profile.resize(255);  // Some pings may lack it.
    for (std::uint8_t& bin : ping.profile) bin = static_cast<std::uint8_t>(random.Bits());
    add(SampleTime(start, k, 10), 0.01, std::move(ping));
  }
  for (int k = 0; k < 2; ++k) add(SampleTime(start, k, 1), 0.0, DepthSample{random.Gaussian()});
  std::stable_sort(dive.begin(), dive.end(), [](const Measurement& a, const Measurement& b) {
    return a.t_arrival < b.t_arrival;
  });
  return dive;
}

inline TruthState RandomTruth(RandomStream& random) {
  const auto vector = [&] {
    return Eigen::Vector3d(random.Gaussian(), random.Gaussian(), random.Gaussian());
  };
  TruthState state;
  state.T_WI = Pose(ExpSO3(vector()), vector());
  state.v_W = vector();
  state.gyro_bias = 1e-3 * vector();
  state.accel_bias = 1e-2 * vector();
  return state;
}

/// A test with a folder of its own.
class RecordingTest : public testing::Test {
 protected:
  RecordingTest() {
    std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
    std::replace(name.begin(), name.end(), '/', '_');
    const char* suite = testing::UnitTest::GetInstance()->current_test_info()->test_suite_name();
    std::string folder = std::string("drydock_") + suite + "_" + name;
    std::replace(folder.begin(), folder.end(), '/', '_');
    folder_ = std::filesystem::path(testing::TempDir()) / folder;
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~RecordingTest() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path target() const { return folder_ / "dive"; }
  std::filesystem::path mav0() const { return target() / "mav0"; }

  void Record(const std::vector<Measurement>& dive) const {
    EurocWriter writer(SmallRig(), target());
    RandomStream random(2, "truth");
    for (const Measurement& measurement : dive) writer.Add(measurement);
    for (int k = 0; k < 10; ++k) {
      writer.AddTruth(SampleTime(dive.front().t, k, 5), RandomTruth(random));
    }
    writer.Commit();
  }

  /// Replaces the first `from` in a file of the recording.
  void Edit(const std::string& file, const std::string& from, const std::string& to) const {
    std::string text = ReadFile(mav0() / file);
    const auto at = text.find(from);
    ASSERT_NE(at, std::string::npos) << file << " has no " << from;
    WriteFileAtomically(mav0() / file, text.replace(at, from.size(), to));
  }

  std::filesystem::path folder_;
};

}  // namespace drydock::dataset
