#include "estimator/svin2/initialisation/bundle_adjustment.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace drydock::svin2 {
namespace {

// Where Cauchy's loss bends [sigmas].
constexpr double kBend = 2.0;
// The weighted mean of a coordinate's squared error where noise is Gaussian with a variance of 1.
// With u = e'e / 2 distributed as exp(-u) and weights w = 1 / (1 + u / 2), E[w] = 2 e^2 E1(2) =
// 0.7227 and E[w u] = 2 (1 - E[w]).
constexpr double kGaussianShare = 2.0 * (1.0 - 0.7227) / 0.7227;
// A landmark behind a camera costs as much as being this many sigmas away.
constexpr double kBehind = 100.0;

double CauchyCost(double chi2) { return kBend * kBend * std::log1p(chi2 / (kBend * kBend)); }

struct LinearObservation {
  Eigen::Vector2d error;                    // Observed less predicted [sigmas].
  Eigen::Matrix<double, 2, 6> by_pose;      // Of the prediction.
  Eigen::Matrix<double, 2, 3> by_landmark;  // Of the prediction.
};

class Adjustment {
 public:
  Adjustment(const StereoGeometry& rig, const Bundle& bundle)
      : rig_(rig),
        bundle_(bundle),
        T_CI_{rig.T_IC(0).Inverse(), rig.T_IC(1).Inverse()},
        T_VI_(bundle.T_VI),
        landmarks_(bundle.landmarks) {}

  std::optional<AdjustedBundle> Run(int max_iterations) {
    double cost = Cost(T_VI_, landmarks_);
    Build();
    for (int iteration = 0; iteration < max_iterations; ++iteration) {
      const Eigen::LDLT<Eigen::MatrixXd> solver(information_);
      if (solver.info() != Eigen::Success || !(solver.vectorD().minCoeff() > 0.0)) {
        return std::nullopt;
      }
      const Eigen::VectorXd step = solver.solve(right_);
      if (!step.allFinite()) return std::nullopt;
      auto [poses, landmarks] = Moved(step);
      const double new_cost = Cost(poses, landmarks);
      if (!(new_cost < cost)) break;
      T_VI_ = std::move(poses);
      landmarks_ = std::move(landmarks);
      Build();
      const bool settled = cost - new_cost < 1e-4 * cost;
      cost = new_cost;
      if (settled) break;
    }
    return Result();
  }

 private:
  std::optional<LinearObservation> Linearise(const BundleObservation& seen) const {
    const Eigen::Vector3d& l = landmarks_[seen.landmark];
    const Eigen::Isometry3d& T_CV = T_CV_[2 * seen.frame + seen.camera];
    const auto projected = rig_.camera(seen.camera).ProjectWithJacobian(T_CV * l);
    if (!projected.has_value()) return std::nullopt;
    LinearObservation linear;
    linear.error = (seen.pixel - projected->pixel) / seen.sigma_px;
    linear.by_landmark = projected->by_point * T_CV.linear() / seen.sigma_px;
    linear.by_pose << -linear.by_landmark, linear.by_landmark * Skew(l - T_VI_[seen.frame].p());
    return linear;
  }

  // Of each frame the left camera, then the right one; as matrices, since many points go through.
  std::vector<Eigen::Isometry3d> CamerasAt(const std::vector<Pose>& poses) const {
    std::vector<Eigen::Isometry3d> T_CV;
    T_CV.reserve(2 * poses.size());
    for (const Pose& T_VI : poses) {
      for (const Pose& T_CI : T_CI_) {
        const Pose camera = T_CI * T_VI.Inverse();
        Eigen::Isometry3d& matrix = T_CV.emplace_back(camera.q());
        matrix.translation() = camera.p();
      }
    }
    return T_CV;
  }

  double Cost(const std::vector<Pose>& poses, const std::vector<Eigen::Vector3d>& landmarks) const {
    const auto T_CV = CamerasAt(poses);
    double cost = 0.0;
    for (const BundleObservation& seen : bundle_.observations) {
      const auto pixel =
          rig_.camera(seen.camera)
              .Project(T_CV[2 * seen.frame + seen.camera] * landmarks[seen.landmark]);
      const double chi2 =
          pixel.has_value() ? (seen.pixel - *pixel).squaredNorm() / (seen.sigma_px * seen.sigma_px)
                            : kBehind * kBehind;
      cost += CauchyCost(chi2);
    }
    return cost;
  }

  // One landmark's normal equations.
  struct Eliminated {
    Eigen::Matrix3d inverse = Eigen::Matrix3d::Zero();  // Of the landmark's information.
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    std::vector<std::pair<int, Eigen::Matrix<double, 6, 3>>> with_poses;  // By frame, rising.
  };

  int Size() const { return 6 * (static_cast<int>(T_VI_.size()) - 1); }

  // Normal equations at the present state, landmarks eliminated.
  void Build() {
    information_ = Eigen::MatrixXd::Zero(Size(), Size());
    right_ = Eigen::VectorXd::Zero(Size());
    T_CV_ = CamerasAt(T_VI_);
    chi2_ = 0.0;
    weights_ = 0.0;
    used_ = 0;
    eliminated_.assign(landmarks_.size(), {});
    auto begin = bundle_.observations.begin();
    while (begin != bundle_.observations.end()) {
      auto end = std::find_if(begin, bundle_.observations.end(), [begin](const auto& seen) {
        return seen.landmark != begin->landmark;
      });
      Eliminate(begin, end, eliminated_[begin->landmark]);
      begin = end;
    }
    information_.triangularView<Eigen::StrictlyUpper>() = information_.transpose();
  }

  using Iterator = std::vector<BundleObservation>::const_iterator;
  void Eliminate(Iterator begin, Iterator end, Eliminated& landmark) {
    Eigen::Matrix3d own = Eigen::Matrix3d::Zero();
    for (auto seen = begin; seen != end; ++seen) {
      const auto linear = Linearise(*seen);
      if (!linear.has_value()) continue;
      const double weight = 1.0 / (1.0 + linear->error.squaredNorm() / (kBend * kBend));
      chi2_ += weight * linear->error.squaredNorm();
      weights_ += weight;
      ++used_;
      own += weight * linear->by_landmark.transpose() * linear->by_landmark;
      landmark.right += weight * linear->by_landmark.transpose() * linear->error;
      if (seen->frame == 0) continue;
      const int at = 6 * (seen->frame - 1);
      information_.block<6, 6>(at, at) += weight * linear->by_pose.transpose() * linear->by_pose;
      right_.segment<6>(at) += weight * linear->by_pose.transpose() * linear->error;
      if (landmark.with_poses.empty() || landmark.with_poses.back().first != at) {
        landmark.with_poses.emplace_back(at, Eigen::Matrix<double, 6, 3>::Zero());
      }
      landmark.with_poses.back().second +=
          weight * linear->by_pose.transpose() * linear->by_landmark;
    }
    // A little more than nothing, for landmarks that one camera saw once.
    own.diagonal() *= 1.0 + 1e-9;
    own.diagonal().array() += 1e-6;
    landmark.inverse = own.inverse();
    for (const auto& [row, left] : landmark.with_poses) {
      const Eigen::Matrix<double, 6, 3> weighted = left * landmark.inverse;
      right_.segment<6>(row) -= weighted * landmark.right;
      for (const auto& [column, other] : landmark.with_poses) {
        if (column > row) break;
        information_.block<6, 6>(row, column) -= weighted * other.transpose();
      }
    }
  }

  std::pair<std::vector<Pose>, std::vector<Eigen::Vector3d>> Moved(
      const Eigen::VectorXd& step) const {
    std::vector<Pose> poses = T_VI_;
    for (std::size_t k = 1; k < poses.size(); ++k) {
      poses[k] = poses[k].BoxPlus(step.segment<6>(6 * (static_cast<int>(k) - 1)));
    }
    std::vector<Eigen::Vector3d> landmarks = landmarks_;
    for (std::size_t i = 0; i < landmarks.size(); ++i) {
      Eigen::Vector3d right = eliminated_[i].right;
      for (const auto& [at, with] : eliminated_[i].with_poses) {
        right -= with.transpose() * step.segment<6>(at);
      }
      landmarks[i] += eliminated_[i].inverse * right;
    }
    return {std::move(poses), std::move(landmarks)};
  }

  AdjustedBundle Result() const {
    AdjustedBundle result{T_VI_, landmarks_, information_, 0.0};
    result.mean_chi2 = used_ > 0 ? chi2_ / used_ : 0.0;
    const double equations = 2.0 * used_;
    const double unknowns = Size() + 3.0 * static_cast<double>(landmarks_.size());
    if (equations > unknowns) {
      const double variance = chi2_ / (2.0 * weights_ * kGaussianShare) * equations;
      result.information /= std::max(1.0, variance / (equations - unknowns));
    }
    return result;
  }

  const StereoGeometry& rig_;
  const Bundle& bundle_;
  std::array<Pose, 2> T_CI_;
  std::vector<Pose> T_VI_;
  std::vector<Eigen::Vector3d> landmarks_;
  Eigen::MatrixXd information_;
  Eigen::VectorXd right_;
  std::vector<Eliminated> eliminated_;
  std::vector<Eigen::Isometry3d> T_CV_;
  double chi2_ = 0.0;
  double weights_ = 0.0;
  int used_ = 0;
};

}  // namespace

std::optional<AdjustedBundle> AdjustBundle(const StereoGeometry& rig, const Bundle& bundle,
                                           int max_iterations) {
  if (bundle.T_VI.size() < 2 || bundle.observations.empty()) return std::nullopt;
  return Adjustment(rig, bundle).Run(max_iterations);
}

}  // namespace drydock::svin2
