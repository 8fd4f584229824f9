#include "tests/integration/dark_trial.h"

#include <cmath>
#include <memory>

#include <fmt/format.h>

#include "estimator/registry/registry.h"
#include "scenarios/scoring/scorecard.h"

namespace drydock::testing {
namespace {

/// What was published, corrected as it was known at the time.
Trajectory RunLive(const RecordedDive& dive, Time dark, Time light, Estimator& estimator) {
  Trajectory live;
  estimator.Start(std::nullopt);
  for (const Measurement& m : dive.measurements) {
    estimator.Add(m.t >= dark && m.t < light ? Blackened(m) : m);
    const auto latest = estimator.Latest();
    if (latest && (live.empty() || latest->state.t > live.back().t))
      live.push_back({latest->state.t, latest->T_GW * latest->state.T_WI});
  }
  estimator.Finish();
  return live;
}

/// Position error of the trajectory without what lies in [from, to), as a share of the path [%].
double AtePercentOutside(const RecordedDive& dive, const Trajectory& trajectory, Time from,
                         Time to) {
  Trajectory kept;
  for (const StampedPose& pose : trajectory)
    if (pose.t < from || pose.t >= to) kept.push_back(pose);
  return score::Score({}, dive.truth, kept, kept, {}).metrics.ate_percent.value_or(NAN);
}

/// Of the last pose, where those before `dark` define the world.
double ErrorAtTheEnd(const RecordedDive& dive, const Trajectory& live, Time dark) {
  Trajectory before;
  for (const StampedPose& pose : live)
    if (pose.t < dark) before.push_back(pose);
  const auto score = score::ScoreTrajectories(dive.truth, before, score::Alignment::kYaw);
  const auto truth = Interpolate(dive.truth, live.back().t);
  return truth ? (score.transform * live.back().T_WI.p() - truth->p()).norm() : NAN;
}

/// When what was published moved away from the odometry for good.
std::optional<Time> FirstCorrection(const Trajectory& live, const Trajectory& odometry,
                                    Time light) {
  for (const StampedPose& pose : live) {
    const auto published = Interpolate(odometry, pose.t);
    if (pose.t >= light && published && (pose.T_WI.p() - published->p()).norm() > 1e-3)
      return pose.t;
  }
  return std::nullopt;
}

}  // namespace

score::LoopScore ScoreLoops(const RecordedDive& dive, const Estimator& estimator) {
  std::vector<score::Loop> loops;
  for (const LoopClosure& loop : estimator.Loops())
    loops.push_back({loop.t_now, loop.t_then, loop.T_then_now});
  return score::ScoreLoops(dive.truth, loops);
}

DarkTrial RunInTheDark(const RecordedDive& dive, Time dark, Time light) {
  const std::unique_ptr<Estimator> svin2 = FindEstimator("svin2").make(dive.rig, NoOptions());
  const Trajectory live = RunLive(dive, dark, light, *svin2);
  DarkTrial trial;
  const std::vector<LoopClosure> loops = svin2->Loops();
  const score::LoopScore score = ScoreLoops(dive, *svin2);
  trial.loops = score.judged;
  trial.true_loops = score.true_loops;
  if (const auto latest = svin2->Latest()) trial.maps = 1 + latest->map_id;
  const Time back = loops.empty() ? light : loops.front().t_now;
  if (!loops.empty()) trial.recognised_s = (back - light).Seconds();
  if (const auto corrected = FirstCorrection(live, svin2->Odometry(), light))
    trial.corrected_s = (*corrected - light).Seconds();
  trial.live_error_m = ErrorAtTheEnd(dive, live, dark);
  trial.ate_percent = AtePercentOutside(dive, svin2->Corrected(), dark, back);
  trial.ate_odometry_percent = AtePercentOutside(dive, svin2->Odometry(), dark, back);
  return trial;
}

std::string Line(const DarkTrial& trial) {
  return fmt::format(
      "recognised {:.2f} s and corrected {:.2f} s after the light came back, {:.3f} m off at the "
      "end; ATE {:.3f} %, of odometry {:.3f} %; {} maps; {} loops, {} true",
      trial.recognised_s.value_or(NAN), trial.corrected_s.value_or(NAN), trial.live_error_m,
      trial.ate_percent, trial.ate_odometry_percent, trial.maps, trial.loops, trial.true_loops);
}

}  // namespace drydock::testing
