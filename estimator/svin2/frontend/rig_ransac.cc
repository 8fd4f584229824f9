#include "estimator/svin2/frontend/rig_ransac.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

#include <opencv2/calib3d.hpp>

#include "sensors_models/base/check.h"
#include "sensors_models/base/random_stream.h"

namespace drydock::svin2 {
namespace {

using Observations = std::vector<LandmarkObservation>;

class Consensus {
 public:
  Consensus(const StereoGeometry& rig, const Observations& observations,
            const RigRansacConfig& config)
      : rig_(rig),
        observations_(observations),
        config_(config),
        T_CI_{rig.T_IC(0).Inverse(), rig.T_IC(1).Inverse()} {
    for (std::size_t i = 0; i < observations.size(); ++i) {
      const LandmarkObservation& seen = observations[i];
      Check(seen.camera == 0 || seen.camera == 1, "there is no camera {}", seen.camera);
      ideal_.push_back(rig.camera(seen.camera).Unproject(seen.pixel));
      if (ideal_.back().has_value()) of_camera_[seen.camera].push_back(i);
    }
  }

  // Inliers of a pose; the sum of squared errors, each capped at an inlier's largest, orders poses
  // with equally many.
  struct Vote {
    std::vector<std::size_t> inliers;
    double cost = 0.0;
  };
  Vote Judge(const Pose& T_WI) const {
    const std::array<Pose, 2> T_CW = {T_CI_[0] * T_WI.Inverse(), T_CI_[1] * T_WI.Inverse()};
    const double largest = config_.max_error_px * config_.max_error_px;
    Vote vote;
    for (std::size_t i = 0; i < observations_.size(); ++i) {
      const LandmarkObservation& seen = observations_[i];
      const auto pixel = rig_.camera(seen.camera).Project(T_CW[seen.camera] * seen.p_W);
      const double error =
          pixel.has_value() ? ((*pixel - seen.pixel) / seen.scale).squaredNorm() : largest;
      vote.cost += std::min(error, largest);
      if (error < largest) vote.inliers.push_back(i);
    }
    return vote;
  }

  // Poses from three observations of one camera, picked at random.
  std::vector<Pose> Sample(RandomStream& random) const {
    const std::size_t both = of_camera_[0].size() + of_camera_[1].size();
    if (both == 0) return {};
    const auto& pool = of_camera_[random.Bits() % both < of_camera_[0].size() ? 0 : 1];
    std::array<std::size_t, 3> picked{};
    for (std::size_t& index : picked) index = pool[random.Bits() % pool.size()];
    if (picked[0] == picked[1] || picked[1] == picked[2] || picked[2] == picked[0]) return {};
    return FromThree(picked);
  }

  Pose Refine(Pose T_WI, const std::vector<std::size_t>& inliers) const {
    for (int iteration = 0; iteration < config_.refinements; ++iteration) {
      Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
      Vector6d right = Vector6d::Zero();
      for (const std::size_t i : inliers) AddTo(normal, right, T_WI, i);
      const Vector6d step = normal.ldlt().solve(right);
      if (!step.allFinite()) break;
      T_WI = T_WI.BoxPlus(step);
      if (step.norm() < 1e-8) break;
    }
    return T_WI;
  }

 private:
  std::vector<Pose> FromThree(const std::array<std::size_t, 3>& picked) const {
    std::vector<cv::Point3d> points;
    std::vector<cv::Point2d> pixels;
    for (const std::size_t i : picked) {
      const Eigen::Vector3d& p = observations_[i].p_W;
      points.emplace_back(p.x(), p.y(), p.z());
      pixels.emplace_back(ideal_[i]->x(), ideal_[i]->y());
    }
    std::vector<cv::Mat> rotations, translations;
    cv::solveP3P(points, pixels, cv::Mat::eye(3, 3, CV_64F), cv::noArray(), rotations, translations,
                 cv::SOLVEPNP_AP3P);
    const Pose& T_IC = rig_.T_IC(observations_[picked[0]].camera);
    std::vector<Pose> poses;
    for (std::size_t i = 0; i < rotations.size(); ++i) {
      const Eigen::Vector3d r(rotations[i].ptr<double>()), t(translations[i].ptr<double>());
      if (r.allFinite() && t.allFinite()) poses.push_back((T_IC * Pose(ExpSO3(r), t)).Inverse());
    }
    return poses;
  }

  // An observation's error [px of its scale] and its derivative by p_C.
  struct Linear {
    Eigen::Vector2d error;
    Eigen::Matrix<double, 2, 3> by_point;
  };

  // Of a radtan lens on the plane z = 1 times the focal length, which is the image but for some
  // per cent; a fisheye shrinks its border several times.
  std::optional<Linear> Linearise(std::size_t i, const Eigen::Vector3d& p_C) const {
    const LandmarkObservation& seen = observations_[i];
    const CameraModel& camera = rig_.camera(seen.camera);
    if (!ideal_[i].has_value() || p_C.z() < 1e-3) return std::nullopt;
    if (camera.intrinsics().lens == LensModel::kEquidistant) {
      const auto projected = camera.ProjectWithJacobian(p_C);
      if (!projected.has_value()) return std::nullopt;
      return Linear{(seen.pixel - projected->pixel) / seen.scale, projected->by_point / seen.scale};
    }
    const double focal = camera.intrinsics().fx / seen.scale;
    const Eigen::Vector2d predicted = p_C.head<2>() / p_C.z();
    Linear linear{focal * (*ideal_[i] - predicted), {}};
    linear.by_point << Eigen::Matrix2d::Identity(), -predicted;
    linear.by_point *= focal / p_C.z();
    return linear;
  }

  // One observation's part of the normal equations.
  void AddTo(Eigen::Matrix<double, 6, 6>& normal, Vector6d& right, const Pose& T_WI,
             std::size_t i) const {
    const LandmarkObservation& seen = observations_[i];
    const Eigen::Matrix3d R_CW = T_CI_[seen.camera].R() * T_WI.R().transpose();
    const Eigen::Vector3d p_C = T_CI_[seen.camera] * (T_WI.Inverse() * seen.p_W);
    const std::optional<Linear> linear = Linearise(i, p_C);
    if (!linear) return;
    const auto& [error, by_point] = *linear;
    // T_WI moved by [dp; da] on the left: p_C changes by R_CW (-dp + [p_W - p_WI]x da).
    Eigen::Matrix<double, 2, 6> jacobian;
    jacobian << -by_point * R_CW, by_point * R_CW * Skew(seen.p_W - T_WI.p());
    // Cauchy's loss, with its bend at a third of the inliers' largest error.
    const double bend = config_.max_error_px / 3.0;
    const double weight = 1.0 / (1.0 + error.squaredNorm() / (bend * bend));
    normal += weight * jacobian.transpose() * jacobian;
    right += weight * jacobian.transpose() * error;
  }

  const StereoGeometry& rig_;
  const Observations& observations_;
  const RigRansacConfig& config_;
  std::array<Pose, 2> T_CI_;
  std::vector<std::optional<Eigen::Vector2d>> ideal_;
  std::array<std::vector<std::size_t>, 2> of_camera_;
};

// How many samples of three it takes to have one without outliers, by `confidence`.
int SamplesNeeded(std::size_t inliers, std::size_t all, double confidence, int at_most) {
  const double share = static_cast<double>(inliers) / static_cast<double>(all);
  const double good = share * share * share;
  if (good >= 1.0 - 1e-12) return 1;
  if (good <= 1e-12) return at_most;
  const double needed = std::log(1.0 - confidence) / std::log(1.0 - good);
  return static_cast<int>(std::clamp(std::ceil(needed), 1.0, static_cast<double>(at_most)));
}

}  // namespace

std::optional<RigPose> EstimateRigPose(const StereoGeometry& rig, const Observations& observations,
                                       const std::optional<Pose>& prior, std::uint64_t seed,
                                       const RigRansacConfig& config) {
  if (observations.size() < static_cast<std::size_t>(std::max(config.min_inliers, 3))) {
    return std::nullopt;
  }
  const Consensus consensus(rig, observations, config);
  RandomStream random(seed, "rig ransac");
  std::optional<Pose> best;
  Consensus::Vote vote;
  const auto consider = [&](const Pose& T_WI) {
    auto other = consensus.Judge(T_WI);
    if (best.has_value() && other.cost >= vote.cost) return;
    best = T_WI;
    vote = std::move(other);
  };
  if (prior.has_value()) consider(*prior);
  int needed = config.max_iterations;
  for (int iteration = 0; iteration < needed; ++iteration) {
    for (const Pose& T_WI : consensus.Sample(random)) consider(T_WI);
    needed = SamplesNeeded(vote.inliers.size(), observations.size(), config.confidence,
                           config.max_iterations);
  }
  if (!best.has_value()) return std::nullopt;
  // A sample's pose is rough: with a better one, more are inliers.
  for (int round = 0; round < 3 && vote.inliers.size() >= 3; ++round) {
    consider(consensus.Refine(*best, vote.inliers));
  }
  if (vote.inliers.size() < static_cast<std::size_t>(config.min_inliers)) return std::nullopt;
  return RigPose{*best, std::move(vote.inliers)};
}

}  // namespace drydock::svin2
