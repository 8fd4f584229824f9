#include "estimator/svin2/loop/relocaliser.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

#include "estimator/svin2/loop/loop_bundle.h"
#include "sensors_models/base/check.h"

namespace drydock::svin2 {
namespace {

struct LoopLandmark {
  LoopMatch match;
  Eigen::Vector3d p_then;
};

std::vector<LoopLandmark> Begin(const Keyframe& now, const Keyframe& then,
                                const std::vector<LoopMatch>& matches, const Pose& T_then_now) {
  std::vector<LoopLandmark> landmarks;
  for (const LoopMatch& match : matches) {
    const auto& of_then = then.points[match.then].p_I;
    const auto& of_now = now.points[match.now].p_I;
    if (of_then.has_value()) {
      landmarks.push_back({match, *of_then});
    } else if (of_now.has_value()) {
      landmarks.push_back({match, T_then_now * *of_now});
    }
  }
  return landmarks;
}

// Those whose pixels fit, where the bundle has them.
std::vector<LoopLandmark> Fitting(const LoopBundle& bundle,
                                  const std::vector<LoopLandmark>& landmarks, double max_chi2) {
  std::vector<LoopLandmark> fitting;
  for (std::size_t k = 0; k < landmarks.size(); ++k) {
    if (bundle.LandmarkChi2(k) <= max_chi2)
      fitting.push_back({landmarks[k].match, bundle.Landmark(k)});
  }
  return fitting;
}

double LargestSigma(const Eigen::Matrix3d& covariance) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, solver.eigenvalues()[2]));
}

Relocalisation Describe(const LoopBundle& bundle, const std::vector<LoopLandmark>& landmarks) {
  Relocalisation result;
  result.T_then_now = bundle.Motion();
  result.chi2_per_dof = bundle.Chi2() / std::max(1, bundle.DegreesOfFreedom());
  result.ranges = bundle.NumRanges();
  for (const LoopLandmark& landmark : landmarks) result.inliers.push_back(landmark.match);
  return result;
}

}  // namespace

Relocaliser::Relocaliser(const Config& config, const StereoGeometry& rig)
    : config_(config), rig_(rig) {
  RequireInput(config.min_inliers >= 4, "min_inliers is {}; it must be at least 4",
               config.min_inliers);
  RequireInput(config.offset_per_sigma >= 0.0 && config.window_sigma_share >= 0.0,
               "offset_per_sigma is {} and window_sigma_share {}; neither may be negative",
               config.offset_per_sigma, config.window_sigma_share);
  RequireInput(config.covariance_inflation >= 1.0,
               "covariance_inflation is {}; it must be at least 1", config.covariance_inflation);
  RequireInput(config.cauchy_scale > 0.0 && config.max_landmark_chi2 > 0.0 &&
                   config.max_chi2_per_dof > 0.0 && config.max_sigma_m > 0.0 &&
                   config.max_sigma_rad > 0.0 && config.solver.iterations > 0,
               "the bounds of a loop's optimisation must be positive");
}

Relocalisation Relocaliser::Conclude(Relocalisation result,
                                     const std::optional<Eigen::MatrixXd>& covariance) const {
  result.status = LoopStatus::kUndetermined;
  if (!covariance.has_value()) return result;
  result.covariance =
      config_.covariance_inflation * std::max(1.0, result.chi2_per_dof) * *covariance;
  if (LargestSigma(result.covariance.topLeftCorner<3, 3>()) > config_.max_sigma_m ||
      LargestSigma(result.covariance.bottomRightCorner<3, 3>()) > config_.max_sigma_rad) {
    return result;
  }
  result.status =
      result.chi2_per_dof <= config_.max_chi2_per_dof ? LoopStatus::kGood : LoopStatus::kPoorFit;
  return result;
}

Relocalisation Relocaliser::Relocalise(const Keyframe& now, const Keyframe& then,
                                       const std::vector<LoopMatch>& matches,
                                       const Pose& T_then_now) const {
  constexpr int kRounds = 3;  // The first with the robust loss.
  Pose motion = T_then_now;
  std::vector<LoopLandmark> landmarks = Begin(now, then, matches, T_then_now);
  for (int round = 0; static_cast<int>(landmarks.size()) >= config_.min_inliers; ++round) {
    LoopBundle bundle({.offset_per_sigma = config_.offset_per_sigma,
                       .window_sigma_share = config_.window_sigma_share,
                       .cauchy_scale = config_.cauchy_scale,
                       .robust_pixels = round == 0},
                      rig_, now, then, motion);
    for (const LoopLandmark& landmark : landmarks) bundle.Add(landmark.match, landmark.p_then);
    if (config_.use_sonar) bundle.AddRanges();
    bundle.Optimise(config_.solver);
    motion = bundle.Motion();

    // The robust loss leaves the largest errors larger than least squares would.
    const double max_chi2 = (round == 0 ? 2.0 : 1.0) * config_.max_landmark_chi2;
    std::vector<LoopLandmark> kept = Fitting(bundle, landmarks, max_chi2);
    const bool all_fit = kept.size() == landmarks.size();
    if (round > 0 && (all_fit || round == kRounds - 1))
      return Conclude(Describe(bundle, landmarks), bundle.Covariance());
    landmarks = std::move(kept);
  }
  Relocalisation refused;
  refused.T_then_now = motion;
  return refused;
}

}  // namespace drydock::svin2
