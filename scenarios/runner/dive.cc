#include "scenarios/runner/dive.h"

#include <algorithm>
#include <set>

#include "scenarios/runner/make_world.h"
#include "sensors_models/base/check.h"
#include "sensors_models/models/usable_rig.h"
#include "sim/world/path_clearance.h"

namespace drydock {
namespace {

/// A path that would be swum for longer than this is a mistake, and takes ages to check.
constexpr double kLongestDive = 1e5;  // [s]

Time EndOf(const Scenario& scenario, const sim::Motion& motion) {
  RequireInput(motion.End().Seconds() <= kLongestDive,
               "{}: the path takes {:.0f} s at {} m/s, must be at most {:.0f} s",
               scenario.motion.waypoints.back().place, motion.End().Seconds(),
               scenario.motion.speed_m_s, kLongestDive);
  if (!scenario.duration_s) return motion.End();
  return std::min(motion.End(), Time::FromSeconds(*scenario.duration_s));
}

}  // namespace

Dive::Dive(const Scenario& scenario, sim::RendererBackend backend)
    : rig_(LoadUsableRig(FindRig(scenario.rig))),
      motion_(scenario.motion, scenario.seed),
      end_(EndOf(scenario, motion_)),
      world_(MakeWorld(scenario)),
      rays_(world_),
      suite_(motion_, world_, rays_, rig_, scenario.sensors, scenario.water, scenario.lamps,
             backend, scenario.seed, end_) {
  sim::RequireClearPath(motion_, world_, rays_, scenario.motion.clearance_m, [&](Time t) {
    return fmt::format("{}, near this way-point",
                       scenario.motion.waypoints[motion_.NearestWaypoint(t)].place);
  });
}

std::string Dive::RendererName() const {
  return suite_.camera() == nullptr ? "none" : suite_.camera()->renderer().BackendName();
}

std::string Dive::DeviceName() const {
  return suite_.camera() == nullptr ? "none" : suite_.camera()->renderer().DeviceName();
}

NavState Dive::InitialState() const {
  const sim::MotionState start = motion_.At(Time{});
  const sim::ImuTruth imu = suite_.imu_truth();
  return {Time{}, start.T_WI, start.v_W, imu.gyro_bias, imu.accel_bias};
}

Trajectory Dive::Truth() const {
  std::set<Time> times;
  for (const double rate_hz : {rig_.imu.rate_hz, rig_.stereo.rate_hz}) {
    for (std::int64_t k = 0; SampleTime(Time{}, k, rate_hz) <= end_; ++k) {
      times.insert(SampleTime(Time{}, k, rate_hz));
    }
  }
  Trajectory truth;
  truth.reserve(times.size());
  for (const Time t : times) truth.push_back({t, motion_.At(t).T_WI});
  return truth;
}

}  // namespace drydock
