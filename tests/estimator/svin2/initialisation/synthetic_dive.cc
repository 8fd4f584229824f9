#include "tests/estimator/svin2/initialisation/synthetic_dive.h"

#include <cmath>
#include <optional>

#include "estimator/inertial/imu_integration.h"
#include "sensors_models/base/random_stream.h"
#include "sensors_models/models/camera_model.h"

namespace drydock::svin2::testing {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Sine = SyntheticMotion::Sine;

double Value(const Sine& sine, double s) {
  return sine.amplitude * std::sin(sine.rate * s + sine.phase);
}
double Rate(const Sine& sine, double s) {
  return sine.amplitude * sine.rate * std::cos(sine.rate * s + sine.phase);
}
double Acceleration(const Sine& sine, double s) { return -sine.rate * sine.rate * Value(sine, s); }

constexpr double kSurface = 5.0;

std::vector<Vector3d> ScatterLandmarks(std::uint64_t seed) {
  RandomStream random(seed, "landmarks");
  constexpr int kCount = 4000;
  std::vector<Vector3d> landmarks;
  landmarks.reserve(kCount);
  for (int i = 0; i < kCount; ++i) {
    landmarks.emplace_back(random.Uniform(-3.0, 12.0), random.Uniform(-8.0, 8.0),
                           random.Uniform(-6.0, 4.0));
  }
  return landmarks;
}

class Eyes {
 public:
  explicit Eyes(const SyntheticDiveConfig& config)
      : config_(config),
        sheet_(V3Stereo()),
        landmarks_(ScatterLandmarks(config.seed)),
        noise_(config.seed, "pixels") {}

  TrackedFrame Look(Time t) {
    TrackedFrame frame;
    frame.t = t;
    const Pose T_WI = config_.motion.At(t.Seconds()).T_WI;
    for (std::size_t i = 0; i < landmarks_.size(); ++i) {
      if (std::ssize(frame.points) == config_.max_points) break;
      const auto left = See(0, T_WI, landmarks_[i]);
      if (!left.has_value()) continue;
      frame.points.push_back(
          {i + 1, *left, See(1, T_WI, landmarks_[i]), std::max(config_.pixel_sigma, 0.1)});
    }
    return frame;
  }

 private:
  std::optional<Vector2d> See(int camera, const Pose& T_WI, const Vector3d& p_W) {
    const CameraModel model(sheet_.cameras[camera]);
    const Vector3d p_C = (T_WI * sheet_.T_IC[camera]).Inverse() * p_W;
    const auto pixel = model.Project(p_C);
    if (p_C.z() < 0.7 || p_C.z() > 8.0 || !pixel.has_value() || !model.IsInside(*pixel)) {
      return std::nullopt;
    }
    if (noise_.Uniform() < config_.outlier_share) {
      return *pixel + Vector2d(noise_.Uniform(-40.0, 40.0), noise_.Uniform(-40.0, 40.0));
    }
    return *pixel + config_.pixel_sigma * Vector2d(noise_.Gaussian(), noise_.Gaussian());
  }

  SyntheticDiveConfig config_;
  StereoSheet sheet_;
  std::vector<Vector3d> landmarks_;
  RandomStream noise_;
};

Vector3d GaussianVector(RandomStream& random) {
  const double x = random.Gaussian(), y = random.Gaussian(), z = random.Gaussian();
  return {x, y, z};
}

// The v3 rig's sheet: densities times the square root of 100 Hz, and turn-on biases.
std::vector<TimedImuSample> Feel(const SyntheticDiveConfig& config, Time begin, Time end,
                                 ImuBias& bias) {
  RandomStream random(config.seed, "imu");
  bias = config.bias;
  if (config.imu_noise) {
    bias.gyro += 8.7e-4 * GaussianVector(random);
    bias.accel += 1.96e-2 * GaussianVector(random);
  }
  std::vector<TimedImuSample> samples;
  for (std::int64_t k = begin.ns / 10'000'000 - 1; k <= end.ns / 10'000'000 + 1; ++k) {
    TimedImuSample sample{{k * 10'000'000}, config.motion.Imu(static_cast<double>(k) * 0.01)};
    sample.sample.angular_rate += bias.gyro;
    sample.sample.specific_force += bias.accel;
    if (config.imu_noise) {
      sample.sample.angular_rate += 1.6e-3 * GaussianVector(random);
      sample.sample.specific_force += 7.14e-3 * GaussianVector(random);
    }
    samples.push_back(sample);
  }
  return samples;
}

std::vector<TimedDepth> Dive(const SyntheticDiveConfig& config, Time begin, Time end) {
  RandomStream random(config.seed, "depth");
  const DepthSheet sheet = V3Depth();
  std::vector<TimedDepth> readings;
  for (Time t{begin.ns + 30'000'000}; t < end; t = t + Duration{kNanosecondsPerSecond}) {
    const Pose T_WI = config.motion.At(t.Seconds() - sheet.lag_s).T_WI;
    double depth = kSurface - (T_WI * sheet.p_ID).z();
    if (config.depth_noise) {
      depth += sheet.noise_m * random.Gaussian();
      depth = std::round(depth / sheet.resolution_m) * sheet.resolution_m;
    }
    readings.push_back({t, depth});
  }
  return readings;
}

}  // namespace

NavState SyntheticMotion::At(double s) const {
  NavState state;
  state.t = Time::FromSeconds(s);
  Vector3d p = speed_W * s;
  state.v_W = speed_W;
  for (int axis = 0; axis < 3; ++axis) {
    p[axis] += Value(sway[axis], s);
    state.v_W[axis] += Rate(sway[axis], s);
  }
  state.T_WI = Pose(FromYawPitchRoll(Value(yaw, s), Value(pitch, s), roll), p);
  return state;
}

ImuSample SyntheticMotion::Imu(double s) const {
  const Vector3d acceleration(Acceleration(sway[0], s), Acceleration(sway[1], s),
                              Acceleration(sway[2], s));
  const Eigen::Quaterniond only_roll = FromYawPitchRoll(0.0, 0.0, roll);
  const Eigen::Quaterniond pitch_roll = FromYawPitchRoll(0.0, Value(pitch, s), roll);
  ImuSample sample;
  // Yaw turns about W's z, pitch about the y axis after yaw; both seen from the body.
  sample.angular_rate = pitch_roll.conjugate() * Vector3d(0, 0, Rate(yaw, s)) +
                        only_roll.conjugate() * Vector3d(0, Rate(pitch, s), 0);
  sample.specific_force = At(s).T_WI.q().conjugate() * (acceleration - kGravity);
  return sample;
}

SyntheticMotion RandomMotion(MotionKind kind, std::uint64_t seed) {
  RandomStream random(seed, "motion");
  const auto sine = [&random](double amplitude, double slowest, double fastest) {
    const double a = amplitude * random.Uniform(0.5, 1.0);
    const double rate = random.Uniform(slowest, fastest);
    return Sine{a, rate, random.Uniform(-M_PI, M_PI)};
  };
  SyntheticMotion motion;
  motion.roll = random.Uniform(-0.2, 0.2);
  motion.pitch = {random.Uniform(-0.2, 0.2), 0.0, M_PI / 2.0};
  motion.yaw = {random.Uniform(-0.5, 0.5), 0.0, M_PI / 2.0};
  if (kind == MotionKind::kStill) return motion;
  const double heading = random.Uniform(-0.5, 0.5);
  motion.speed_W = random.Uniform(0.1, 0.4) * Vector3d(std::cos(heading), std::sin(heading), 0.0);
  for (Sine& sway : motion.sway) sway = sine(0.1, 0.5, 1.5);
  motion.yaw = sine(0.3, 0.3, 0.7);
  motion.pitch = sine(0.05, 0.5, 1.5);
  if (kind == MotionKind::kMoving) return motion;
  motion.pitch = sine(0.35, 0.8, 1.5);
  motion.sway[2] = sine(0.4, 0.7, 1.0);
  return motion;
}

StereoSheet V3Stereo() {
  StereoSheet sheet;
  sheet.rate_hz = 15.0;
  for (int i = 0; i < 2; ++i) {
    sheet.cameras[i] = {.width = 800,
                        .height = 600,
                        .fx = 575.0,
                        .fy = 574.5,
                        .cx = 400.0,
                        .cy = 289.0,
                        .distortion = {-0.16, 0.10, 0.0, 0.0}};
    sheet.T_IC[i] =
        Pose(Eigen::Quaterniond(0.5, -0.5, 0.5, -0.5), {0.04, i == 0 ? 0.084 : -0.059, -0.006});
  }
  return sheet;
}

DepthSheet V3Depth() {
  DepthSheet sheet;
  sheet.rate_hz = 1.0;
  sheet.p_ID = {-0.282, -0.019, 0.032};
  sheet.noise_m = 0.002;
  sheet.offset_m = 0.5;
  sheet.lag_s = 0.02;
  sheet.resolution_m = 0.002;
  return sheet;
}

StereoSheet WithBaseline(StereoSheet sheet, double factor) {
  const Vector3d baseline = sheet.T_IC[1].p() - sheet.T_IC[0].p();
  sheet.T_IC[1] = Pose(sheet.T_IC[1].q(), sheet.T_IC[0].p() + factor * baseline);
  return sheet;
}

SyntheticDive MakeSyntheticDive(const SyntheticDiveConfig& config) {
  SyntheticDive dive;
  Eyes eyes(config);
  const Time begin = Time::FromSeconds(config.begin_s);
  const Time end = Time::FromSeconds(config.begin_s + config.length_s);
  const auto imu = Feel(config, begin, end, dive.bias);
  const auto depth = Dive(config, begin, end);
  auto next_sample = imu.begin();
  auto next_depth = depth.begin();
  for (std::int64_t k = 0;; ++k) {
    const Time t = SampleTime(begin, k, 15.0);
    if (t > end) break;
    SyntheticInput input;
    input.frame = eyes.Look(t);
    // The samples reach just past the frame.
    while (next_sample != imu.end() && (input.imu.empty() || input.imu.back().t < t)) {
      input.imu.push_back(*next_sample++);
    }
    while (next_depth != depth.end() && next_depth->t <= t) input.depth.push_back(*next_depth++);
    dive.inputs.push_back(std::move(input));
  }
  return dive;
}

}  // namespace drydock::svin2::testing
