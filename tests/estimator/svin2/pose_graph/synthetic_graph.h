// A dive around a wreck as the pose graph gets it: keyframes with odometry that drifts by honest
// noise, and loops, true and false.
#pragma once

#include <cstdint>
#include <vector>

#include "estimator/svin2/pose_graph/pose_graph.h"
#include "sensors_models/base/random_stream.h"

namespace drydock::svin2::testing {

struct SyntheticDiveConfig {
  std::uint64_t seed = 1;
  std::int64_t laps = 2;
  std::int64_t per_lap = 100;     ///< Keyframes.
  double sigma_position = 0.004;  ///< Of the step from keyframe to keyframe [m],
  double sigma_angle = 0.0015;    ///< and its turn [rad].
  double loop_sigma_position = 0.02;
  double loop_sigma_angle = 0.005;
};

/// Independent components with these standard deviations.
Matrix6d Covariance(double sigma_position, double sigma_angle);

class SyntheticDive {
 public:
  explicit SyntheticDive(const SyntheticDiveConfig& config);

  /// Lets odometry go astray by `drift` [m, in W] from keyframe `first` to `last`, which its
  /// covariance admits to by `sigma` [m] a step.
  void GoBlind(std::int64_t first, std::int64_t last, const Eigen::Vector3d& drift, double sigma);

  std::int64_t size() const { return static_cast<std::int64_t>(truth_.size()); }
  const Pose& Truth(std::int64_t k) const { return truth_[static_cast<std::size_t>(k)]; }
  PoseGraphNode Node(std::int64_t k) const;
  /// From the keyframe before `k`; `k` > 0.
  PoseGraphEdge Step(std::int64_t k) const { return steps_[static_cast<std::size_t>(k)]; }
  /// A keyframe and the step that leads to it.
  void AddTo(PoseGraph& graph, std::int64_t k) const;
  void AddTo(PoseGraph& graph) const;

  /// As loop closing measures it, with noise.
  PoseGraphEdge TrueLoop(std::int64_t from, std::int64_t to);
  /// One that believes the body `shift` [m, in W] away from where it is: a look-alike.
  PoseGraphEdge FalseLoop(std::int64_t from, std::int64_t to, const Eigen::Vector3d& shift);
  /// One between any two keyframes, of any plausible relative pose.
  PoseGraphEdge RandomLoop();
  /// True loops from each `stride`-th keyframe of [first, last) to the lap before.
  std::vector<PoseGraphEdge> TrueLoops(std::int64_t first, std::int64_t last, std::int64_t stride);

 private:
  Pose Noisy(const Pose& pose, double sigma_position, double sigma_angle);
  PoseGraphEdge Loop(std::int64_t from, std::int64_t to, const Pose& T_from_to);
  void Integrate();

  SyntheticDiveConfig config_;
  RandomStream random_;
  std::vector<Pose> truth_, odometry_;
  std::vector<PoseGraphEdge> steps_;  // To each keyframe; the first is none.
};

/// Position error (RMSE) of the dive's keyframes after alignment by rotation and translation [m].
double Ate(const SyntheticDive& dive, const std::vector<Pose>& estimate);

}  // namespace drydock::svin2::testing
