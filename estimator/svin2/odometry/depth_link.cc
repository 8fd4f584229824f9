#include "estimator/svin2/odometry/depth_link.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace drydock::svin2 {
namespace {

/// Over longer than that a body does not rise evenly: older readings say nothing of a frame.
constexpr Duration kOldest{1'000'000'000};

}  // namespace

bool DepthLink::Add(Time t, const DepthSample& reading) {
  if (!std::isfinite(reading.depth) || (last_ && t <= *last_)) return false;
  last_ = t;
  waiting_.push_back({t - Duration::FromSeconds(sheet_.lag_s), reading.depth});
  since_frame_.push_back({t, reading.depth});
  return true;
}

std::vector<EstimatorEvent> DepthLink::Feed(SlidingWindow& window, const ImuBuffer& imu) {
  std::vector<EstimatorEvent> said;
  const NavState state = window.Latest();
  for (; !waiting_.empty() && waiting_.front().t <= state.t; waiting_.pop_front()) {
    const auto& [t, depth] = waiting_.front();
    if (state.t - t > kOldest) continue;
    const double age = (state.t - t).Seconds();
    const std::vector<TimedImuSample> samples = imu.Between(t, t);
    const Eigen::Vector3d rate_I =
        samples.empty() ? Eigen::Vector3d::Zero()
                        : Eigen::Vector3d(samples.front().sample.angular_rate - state.gyro_bias);
    const Eigen::Vector3d port = ExpSO3(-age * rate_I) * sheet_.p_ID;
    const double height = (state.T_WI * port).z() - age * state.v_W.z();
    const double surface = height + depth;
    const double expected = window.SurfaceHeight().value_or(surface) - height;
    if (!window.SurfaceHeight()) believed_ = against_ = 0;
    if (gate_.Believes(t, depth - expected)) {
      ++believed_;
      against_ = 0;
    } else if (Outvotes(surface)) {
      said.push_back(
          {t, fmt::format("{} depths in a row differ by {:.2f} m from what was expected, "
                          "and agree: the surface is found anew",
                          against_, depth - expected)});
      window.ForgetSurface();
      gate_.Believes(t, 0.0);
      believed_ = std::exchange(against_, 0);
    } else {
      said.push_back({t, fmt::format("a depth of {:.2f} m was not believed: {:.2f} m were expected",
                                     depth, expected)});
      continue;
    }
    window.AddDepth(t, {depth, sheet_.p_ID, {}, DepthSigma(sheet_)}, rate_I);
  }
  return said;
}

bool DepthLink::Outvotes(double surface) {
  if (against_ > 0 && std::abs(surface - surface_against_) > agreement_m_) against_ = 0;
  surface_against_ = surface;
  return ++against_ > believed_;
}

double DepthSigma(const DepthSheet& sheet) {
  // What carrying it to a frame adds: 5 mm/s of error in speed over 1/30 s, and turning.
  constexpr double kCarried = 3e-4;
  return std::hypot(sheet.noise_m, sheet.resolution_m / std::sqrt(12.0), kCarried);
}

}  // namespace drydock::svin2
