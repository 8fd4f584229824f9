// The optimisation problem of a loop (paper eq. 16).
#pragma once

#include <Eigen/Core>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "estimator/svin2/frontend/stereo_geometry.h"
#include "estimator/svin2/graph/factor_graph.h"
#include "estimator/svin2/loop/keyframe.h"
#include "estimator/svin2/loop/loop_matcher.h"

namespace drydock::svin2 {

struct LoopBundleConfig {
  double offset_per_sigma = 0.0;    ///< See Relocaliser::Config.
  double window_sigma_share = 0.0;  ///< See Relocaliser::Config.
  /// Of Cauchy's loss: ranges have it always, being too few to tell which does not fit.
  double cauchy_scale = 1.0;
  bool robust_pixels = true;  ///< Else their plain squares.
};

/// One pose, T_then_now, and landmarks in then's body frame, whose pose is the identity and fixed.
class LoopBundle {
 public:
  LoopBundle(const LoopBundleConfig& config, const StereoGeometry& rig, const Keyframe& now,
             const Keyframe& then, const Pose& T_then_now);

  /// A landmark that both keyframes see, at `p_then` [m] to begin with.
  void Add(const LoopMatch& match, const Eigen::Vector3d& p_then);
  /// The ranges of both keyframes that met a landmark that was added; landmarks of these patches
  /// that were not are estimated as well, from the pixels of the keyframe that the range is of.
  /// Ranges of `now` with fixed landmarks are left out: these would move with it.
  void AddRanges();

  SolverReport Optimise(const SolverLimits& limits) { return graph_.Optimise(limits); }

  Pose Motion() const { return graph_.PoseOf(pose_); }  ///< T_then_now.
  std::optional<Eigen::MatrixXd> Covariance() const { return graph_.CovarianceOf(pose_); }
  /// Of the k-th landmark that was added [m, in then's body frame].
  Eigen::Vector3d Landmark(std::size_t k) const;
  /// Of the pixels of the k-th landmark that was added.
  double LandmarkChi2(std::size_t k) const;
  double Chi2() const;  ///< Of everything.
  int DegreesOfFreedom() const { return residuals_ - 3 * landmarks_ - 6; }
  int NumRanges() const { return static_cast<int>(ranges_.size()); }

 private:
  using ByPoint = std::map<std::size_t, BlockId>;

  BlockId AddLandmark(const Eigen::Vector3d& p_then);
  void AddPixels(std::unique_ptr<ceres::CostFunction> cost, std::vector<BlockId> blocks);
  void AddRange(std::unique_ptr<ceres::CostFunction> cost, std::vector<BlockId> blocks);
  void AddSeenThen(BlockId landmark, const KeyframePoint& point);
  void AddSeenNow(BlockId landmark, const KeyframePoint& point, double offset_px);
  void AddRangesOf(const Keyframe& keyframe, bool is_now, ByPoint& by_point);
  BlockId AddMember(const Keyframe& keyframe, bool is_now, std::size_t point);

  LoopBundleConfig config_;
  const StereoGeometry& rig_;
  const Keyframe& now_;
  const Keyframe& then_;
  FactorGraph graph_;
  BlockId pose_;
  std::vector<BlockId> matched_;
  std::vector<FactorId> pixels_, ranges_;  // Rising.
  ByPoint of_now_, of_then_;               // Landmarks by the keyframes' points.
  int residuals_ = 0, landmarks_ = 0;
};

}  // namespace drydock::svin2
