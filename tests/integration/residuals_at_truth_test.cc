// What SVIn2's factors say of simulated measurements at the true states of the bus dive: with the
// noise that they believe in, chi-square; without noise, what their own models leave out.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include <gtest/gtest.h>

#include "estimator/svin2/factors/depth_factor.h"
#include "estimator/svin2/factors/imu_factor.h"
#include "estimator/svin2/odometry/depth_link.h"
#include "scenarios/runner/scenario.h"
#include "sensors_models/base/pose_manifold.h"
#include "sensors_models/base/resources.h"
#include "sensors_models/noise/imu_noise.h"
#include "sensors_models/noise/pressure_noise.h"
#include "sim/motion/spline_motion.h"
#include "sim/sensors/depth_sensor.h"
#include "sim/sensors/imu.h"

namespace drydock {
namespace {

using svin2::ImuBias;
using svin2::ImuPreintegration;
using svin2::TimedImuSample;
using Vector15d = Eigen::Matrix<double, 15, 1>;

constexpr Duration kFramePeriod{66'666'667};
constexpr Duration kSecond{1'000'000'000};

const Scenario& BusDive() {
  static const Scenario scenario = LoadScenario(DataDirectory() / "scenarios" / "bus.yaml");
  return scenario;
}

const Rig& BusRig() {
  static const Rig rig = LoadRig(FindRig(BusDive().rig));
  return rig;
}

/// Normalised squares of residuals, each with the same degrees of freedom.
struct Squares {
  int dof = 1;
  std::vector<double> values;

  double MeanPerDof() const {
    double sum = 0.0;
    for (const double value : values) sum += value;
    return sum / (static_cast<double>(values.size()) * dof);
  }
  /// Standard deviation of MeanPerDof() if they are independent and chi-square.
  double SigmaOfMean() const { return std::sqrt(2.0 / (static_cast<double>(values.size()) * dof)); }
  double ShareAbove(double bound) const {
    const auto above = std::count_if(values.begin(), values.end(),
                                     [bound](double value) { return value > bound; });
    return static_cast<double>(above) / static_cast<double>(values.size());
  }
  void Print(const char* what) const {
    std::printf("%s: %zu of %d: mean %.3f a degree of freedom (+- %.3f)\n", what, values.size(),
                dof, MeanPerDof(), SigmaOfMean());
  }
};

/// The IMU's samples on the bus dive and the biases that each had, what scale errors and
/// misalignment made of the truth among them.
class ImuDive {
 public:
  /// `sheet` is what there is, `believed` what the factors believe.
  ImuDive(const ImuSheet& sheet, bool noise, std::uint64_t seed, const ImuSheet& believed)
      : noise_(svin2::NoiseModelOf(believed, 1.0)), motion_(BusDive().motion, seed) {
    sim::Imu imu(motion_, sheet, noise, seed);
    const ImuNoise errors(sheet, seed);
    const Eigen::Matrix3d gyro = errors.gyro_response() - Eigen::Matrix3d::Identity();
    const Eigen::Matrix3d accel = errors.accel_response() - Eigen::Matrix3d::Identity();
    while (imu.NextTime() <= motion_.End()) {
      const sim::Observation observation = imu.Observe();
      samples_.push_back(
          {observation.measurement.t, std::get<ImuSample>(observation.measurement.reading)});
      const auto& truth = std::get<sim::ImuTruth>(observation.truth);
      biases_.push_back({truth.gyro_bias, truth.accel_bias});
      if (!noise) continue;
      const ImuSample ideal = sim::IdealImu(motion_.At(observation.measurement.t));
      biases_.back().gyro += gyro * ideal.angular_rate;
      biases_.back().accel += accel * ideal.specific_force;
    }
  }

  Time End() const { return samples_.back().t; }
  const sim::Motion& motion() const { return motion_; }

  ImuPreintegration Between(Time begin, Time end) const {
    const auto from = samples_.begin() + static_cast<std::ptrdiff_t>(IndexAt(begin));
    const auto to = samples_.begin() + static_cast<std::ptrdiff_t>(IndexAt(end)) + 2;
    return *ImuPreintegration::Over({from, std::min(to, samples_.end())}, begin, end,
                                    biases_[IndexAt(begin)], noise_);
  }

  /// The factor's residual at the true states, whitened.
  Vector15d Residual(Time begin, Time end) const {
    const svin2::ImuFactor factor(Between(begin, end));
    const auto pose_i = PoseAt(begin), pose_j = PoseAt(end);
    const auto speed_i = SpeedAt(begin), speed_j = SpeedAt(end);
    const double* parameters[] = {pose_i.data(), speed_i.data(), pose_j.data(), speed_j.data()};
    Vector15d residual;
    factor.Evaluate(parameters, residual.data(), nullptr);
    return residual;
  }

 private:
  /// Of the last sample at or before `t`.
  std::size_t IndexAt(Time t) const {
    const auto after =
        std::upper_bound(samples_.begin(), samples_.end(), t,
                         [](Time at, const TimedImuSample& sample) { return at < sample.t; });
    return static_cast<std::size_t>(after - samples_.begin()) - 1;
  }
  PoseParameters PoseAt(Time t) const { return ToParameters(motion_.At(t).T_WI); }
  svin2::SpeedBiasParameters SpeedAt(Time t) const {
    return svin2::ToParameters(svin2::SpeedBias{motion_.At(t).v_W, biases_[IndexAt(t)]});
  }

  svin2::ImuNoiseModel noise_;
  sim::SplineMotion motion_;
  std::vector<TimedImuSample> samples_;
  std::vector<ImuBias> biases_;
};

/// The errors that the factor's noise model has: white noise and walking biases.
ImuSheet ModelledNoise() {
  ImuEffects effects;
  effects.scale_error = effects.misalignment = effects.quantisation = false;
  return KeepEffects(BusRig().imu, effects);
}

Squares ImuSquares(Duration interval, const ImuSheet& sheet, const ImuSheet& believed) {
  Squares squares{15, {}};
  for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
    const ImuDive dive(sheet, true, seed, believed);
    for (Time t; t + interval <= dive.End(); t = t + interval)
      squares.values.push_back(dive.Residual(t, t + interval).squaredNorm());
  }
  return squares;
}

TEST(ResidualsAtTruth, ImuOverASecondIsChiSquare) {
  const Squares squares = ImuSquares(kSecond, ModelledNoise(), ModelledNoise());
  squares.Print("IMU, 1 s");
  EXPECT_GT(squares.values.size(), 600U);
  // The ends' share (below) is one part in the number of samples.
  EXPECT_NEAR(squares.MeanPerDof(), 0.99, 4.0 * squares.SigmaOfMean());
  // 5 % and 1 % of chi-square with 15 degrees of freedom lie above these; +- 4 sigma of a share.
  EXPECT_NEAR(squares.ShareAbove(24.996), 0.05, 0.035);
  EXPECT_NEAR(squares.ShareAbove(30.578), 0.01, 0.016);
}

// Stamps of frames lie between samples. A sample next to a frame counts in part for either side,
// which lessens both variances and makes neighbours depend on each other: with 6.7 samples an
// interval the squares are about a tenth too small, on the safe side, and their sum over a second
// (above) is right.
TEST(ResidualsAtTruth, ImuBetweenFramesIsChiSquareButForTheEnds) {
  const Squares squares = ImuSquares(kFramePeriod, ModelledNoise(), ModelledNoise());
  squares.Print("IMU, frame to frame");
  EXPECT_GT(squares.MeanPerDof(), 0.80);
  EXPECT_LT(squares.MeanPerDof(), 1.0);
  EXPECT_LT(squares.ShareAbove(24.996), 0.05);
  EXPECT_LT(squares.ShareAbove(30.578), 0.01);
}

// Scale errors and misalignment act as biases that change as the body turns and tilts: by far more
// than the sheet's walk, and within the one that NoiseModelOf() adds.
TEST(ResidualsAtTruth, ScaleErrorsAndMisalignmentAreCovered) {
  const ImuSheet& whole = BusRig().imu;
  for (const Duration interval : {kFramePeriod, kSecond}) {
    const Squares left_out = ImuSquares(interval, whole, ModelledNoise());
    const Squares covered = ImuSquares(interval, whole, whole);
    left_out.Print("the whole sheet, taken for noise alone");
    covered.Print("the whole sheet");
    EXPECT_GT(left_out.MeanPerDof(), 2.0);
    EXPECT_LT(covered.MeanPerDof(), 1.0);
    EXPECT_GT(covered.MeanPerDof(), 0.5);
  }
}

// The trapezoidal rule at 100 Hz against an analytic motion: errors of second order in 10 ms.
TEST(ResidualsAtTruth, ImuWithoutNoiseIsTheIntegrationsOwnError) {
  double worst_p = 0.0, worst_a = 0.0, worst_v = 0.0, worst_square = 0.0;
  for (const std::uint64_t seed : {1, 2, 3}) {
    const ImuDive dive(BusRig().imu, false, seed, ModelledNoise());
    for (Time t; t + kFramePeriod <= dive.End(); t = t + kFramePeriod) {
      const sim::MotionState i = dive.motion().At(t), j = dive.motion().At(t + kFramePeriod);
      const svin2::ImuDelta delta = dive.Between(t, t + kFramePeriod).delta();
      const double T = kFramePeriod.Seconds();
      const Eigen::Vector3d move = j.T_WI.p() - i.T_WI.p() - i.v_W * T - 0.5 * T * T * kGravity;
      const Eigen::Quaterniond back = i.T_WI.q().conjugate();
      worst_p = std::max(worst_p, (back * move - delta.p).norm());
      worst_a = std::max(worst_a, LogSO3(back * j.T_WI.q() * delta.q.conjugate()).norm());
      worst_v = std::max(worst_v, (back * (j.v_W - i.v_W - T * kGravity) - delta.v).norm());
      worst_square = std::max(worst_square, dive.Residual(t, t + kFramePeriod).squaredNorm());
    }
  }
  std::printf("frame to frame without noise: %.2g m, %.2g rad, %.2g m/s; chi2 %.2g of 15\n",
              worst_p, worst_a, worst_v, worst_square);
  EXPECT_LT(worst_p, 1e-6);
  EXPECT_LT(worst_a, 1e-6);
  EXPECT_LT(worst_v, 1e-5);
  EXPECT_LT(worst_square, 0.1);
}

/// Residuals of depth readings, each at the frame nearest to when it was true.
std::vector<double> DepthResiduals(const DepthSheet& sheet, bool noise, std::uint64_t seed) {
  const sim::SplineMotion motion(BusDive().motion, seed);
  const double surface_z = BusDive().water.surface_z_m;
  sim::DepthSensor sensor(motion, sheet, surface_z, noise, seed);
  const double surface = surface_z + (noise ? PressureNoise(sheet, seed).offset() : 0.0);
  const double lag_s = noise ? sheet.lag_s : 0.0;
  std::vector<double> residuals;
  while (sensor.NextTime() <= motion.End()) {
    const Measurement reading = sensor.Observe().measurement;
    const Time t = reading.t - Duration::FromSeconds(lag_s);
    const Time frame = SampleTime(Time{}, std::llround(t.Seconds() * BusRig().stereo.rate_hz),
                                  BusRig().stereo.rate_hz);
    const sim::MotionState state = motion.At(frame);
    const Duration dt = t - frame;
    const svin2::DepthFactor factor({std::get<DepthSample>(reading.reading).depth,
                                     ExpSO3(dt.Seconds() * state.w_I) * sheet.p_ID, dt,
                                     svin2::DepthSigma(sheet)});
    const auto pose = ToParameters(state.T_WI);
    const auto speed = svin2::ToParameters(svin2::SpeedBias{state.v_W, {}});
    const double* parameters[] = {pose.data(), speed.data(), &surface};
    double residual = 0.0;
    factor.Evaluate(parameters, &residual, nullptr);
    residuals.push_back(residual);
  }
  return residuals;
}

TEST(ResidualsAtTruth, DepthIsChiSquare) {
  Squares squares{1, {}};
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
    for (const double residual : DepthResiduals(BusRig().depth, true, seed))
      squares.values.push_back(residual * residual);
  squares.Print("depth");
  EXPECT_GT(squares.values.size(), 1200U);
  EXPECT_NEAR(squares.MeanPerDof(), 1.0, 4.0 * squares.SigmaOfMean());
  EXPECT_NEAR(squares.ShareAbove(3.841), 0.05, 0.025);
  EXPECT_NEAR(squares.ShareAbove(6.635), 0.01, 0.011);
}

// What is left: the unevenness of the rise between frame and reading.
TEST(ResidualsAtTruth, DepthWithoutNoiseIsWithinAThirdOfAMillimetre) {
  const auto worst = [](const DepthSheet& sheet, bool noise) {
    double worst_m = 0.0;
    for (const std::uint64_t seed : {1, 2, 3})
      for (const double residual : DepthResiduals(sheet, noise, seed))
        worst_m = std::max(worst_m, std::abs(residual) * svin2::DepthSigma(sheet));
    return worst_m;
  };
  const double ideal = worst(BusRig().depth, false);
  PressureEffects lag_alone;
  lag_alone.white_noise = lag_alone.offset = lag_alone.quantisation = false;
  const double lagging = worst(KeepEffects(BusRig().depth, lag_alone), true);
  std::printf("depth without noise: %.3f mm, with the lag %.3f mm\n", 1e3 * ideal, 1e3 * lagging);
  EXPECT_LT(ideal, 0.3e-3);
  EXPECT_LT(lagging, 0.3e-3);
}

}  // namespace
}  // namespace drydock
