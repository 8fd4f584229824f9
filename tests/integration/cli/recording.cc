#include "tests/integration/cli/recording.h"

#include <algorithm>
#include <vector>

#include "scenarios/dataset/euroc_writer.h"

namespace drydock::testing {
namespace {

constexpr Time kStart{100 * kNanosecondsPerSecond};

std::vector<Measurement> Glide(const Rig& rig) {
  std::vector<Measurement> dive;
  const auto add = [&](double rate_hz, Duration latency, auto reading_of) {
    for (int k = 0; k <= static_cast<int>(rate_hz); ++k) {
      const Time t = SampleTime(kStart, k, rate_hz);
      dive.push_back({t, t + latency, reading_of(k)});
    }
  };
  add(rig.imu.rate_hz, {}, [](int) { return ImuSample{{0, 0, 0}, {0, 0.2, 9.81}}; });
  add(rig.depth.rate_hz, {}, [](int) { return DepthSample{2.0}; });
  add(rig.sonar.rate_hz, {}, [&](int k) {
    SonarPing ping;
    ping.head_angle = rig.sonar.step_rad * k;
    ping.range = ping.first_range = 1.5;
    ping.intensity = 0.5;
    return ping;
  });
  add(rig.stereo.rate_hz, {40'000'000}, [](int k) {
    const cv::Mat image(24, 32, CV_8UC1, cv::Scalar(20.0 * k));
    return StereoFrame{k, {image, image}};
  });
  std::stable_sort(dive.begin(), dive.end(), [](const Measurement& a, const Measurement& b) {
    return a.t_arrival < b.t_arrival;
  });
  return dive;
}

}  // namespace

Rig SmallRig() {
  Rig rig = LoadRig(FindRig("svin2_v3"));
  rig.name = "small";
  for (CameraIntrinsics& camera : rig.stereo.cameras) {
    camera.width = 32;
    camera.height = 24;
    camera.fx = camera.fy = 24;
    camera.cx = 15.5;
    camera.cy = 11.5;
  }
  rig.imu.rate_hz = 20;
  rig.stereo.rate_hz = 5;
  rig.sonar.rate_hz = 10;
  rig.depth.rate_hz = 1;
  return rig;
}

void RecordGlide(const std::filesystem::path& target) {
  const Rig rig = SmallRig();
  dataset::EurocWriter writer(rig, target);
  for (const Measurement& measurement : Glide(rig)) writer.Add(measurement);
  for (int k = 0; k <= 20; ++k) {
    const double t = 0.05 * k;
    dataset::TruthState state;
    state.T_WI = Pose(Eigen::Quaterniond::Identity(), {1.0 + 0.5 * t, 2.0 + 0.1 * t * t, 3.0});
    state.v_W = {0.5, 0.2 * t, 0.0};
    writer.AddTruth(SampleTime(kStart, k, 20), state);
  }
  writer.Commit();
}

}  // namespace drydock::testing
