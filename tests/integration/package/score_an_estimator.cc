// Feeds dead reckoning two seconds of straight, level motion and scores what it makes of them.
#include <cstdio>

#include "estimator/registry/registry.h"
#include "scenarios/scoring/trajectory_score.h"

int main() {
  using namespace drydock;
  const Eigen::Vector3d kSpeed(1.0, 0.0, 0.0);
  const auto estimator = FindEstimator("dead-reckoning").make(Rig(), NoOptions());
  NavState start;
  start.v_W = kSpeed;
  estimator->Start(start);
  Trajectory truth;
  for (int k = 0; k <= 200; ++k) {
    const Time t = SampleTime(Time{}, k, 100.0);
    truth.push_back({t, Pose(Eigen::Quaterniond::Identity(), kSpeed * t.Seconds())});
    ImuSample sample;
    sample.specific_force.z() = 9.81;
    estimator->Add({t, t, sample});
  }
  const auto score =
      score::ScoreTrajectories(truth, estimator->Odometry(), score::Alignment::kOrigin);
  std::printf("ate %.4f m over %.2f m\n", score.metrics.ate_rmse_m.value(), score.path_length_m);
  return score.metrics.ate_rmse_m < 0.02 ? 0 : 1;
}
