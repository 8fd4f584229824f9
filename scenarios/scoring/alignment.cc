#include "scenarios/scoring/alignment.h"

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "sensors_models/base/check.h"

namespace drydock::score {
namespace {

constexpr std::array<std::pair<Alignment, std::string_view>, 5> kNames = {{
    {Alignment::kNone, "none"},
    {Alignment::kOrigin, "origin"},
    {Alignment::kYaw, "yaw"},
    {Alignment::kSe3, "se3"},
    {Alignment::kSim3, "sim3"},
}};

Eigen::Quaterniond YawRotation(double yaw) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()));
}

/// Positions' means and second moments: x of the estimate, y of the truth.
struct Moments {
  Eigen::Vector3d mean_x = Eigen::Vector3d::Zero();
  Eigen::Vector3d mean_y = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance_yx = Eigen::Matrix3d::Zero();  ///< (1/n) sum (y - my) (x - mx)^T
  double variance_x = 0.0;                                  ///< (1/n) sum |x - mx|^2
};

Moments MomentsOf(const std::vector<PosePair>& pairs) {
  Moments moments;
  const auto n = static_cast<double>(pairs.size());
  for (const PosePair& pair : pairs) {
    moments.mean_x += pair.estimate.p() / n;
    moments.mean_y += pair.truth.p() / n;
  }
  for (const PosePair& pair : pairs) {
    const Eigen::Vector3d x = pair.estimate.p() - moments.mean_x;
    const Eigen::Vector3d y = pair.truth.p() - moments.mean_y;
    moments.covariance_yx += y * x.transpose() / n;
    moments.variance_x += x.squaredNorm() / n;
  }
  return moments;
}

std::optional<Similarity> AlignYaw(const std::vector<PosePair>& pairs) {
  if (pairs.size() < 2) return std::nullopt;
  const Moments moments = MomentsOf(pairs);
  const Eigen::Matrix3d covariance_xy = moments.covariance_yx.transpose();
  const double sine = covariance_xy(0, 1) - covariance_xy(1, 0);
  const double cosine = covariance_xy(0, 0) + covariance_xy(1, 1);
  if (std::hypot(sine, cosine) <= std::numeric_limits<double>::epsilon()) return std::nullopt;
  const Eigen::Quaterniond rotation = YawRotation(std::atan2(sine, cosine));
  return Similarity{1.0, Pose(rotation, moments.mean_y - rotation * moments.mean_x)};
}

/// Umeyama, Least-squares estimation of transformation parameters between two point patterns, 1991.
std::optional<Similarity> AlignUmeyama(const std::vector<PosePair>& pairs, bool with_scale) {
  if (pairs.size() < 3) return std::nullopt;
  const Moments moments = MomentsOf(pairs);
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(moments.covariance_yx,
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Vector3d& d = svd.singularValues();
  if (!(d(1) > std::numeric_limits<double>::epsilon())) return std::nullopt;
  const bool mirrored = svd.matrixU().determinant() * svd.matrixV().determinant() < 0.0;
  const Eigen::Vector3d s(1.0, 1.0, mirrored ? -1.0 : 1.0);
  const Eigen::Matrix3d rotation = svd.matrixU() * s.asDiagonal() * svd.matrixV().transpose();
  const double scale = with_scale ? d.dot(s) / moments.variance_x : 1.0;
  return Similarity{scale, Pose(Eigen::Quaterniond(rotation),
                                moments.mean_y - scale * rotation * moments.mean_x)};
}

}  // namespace

std::string_view ToString(Alignment alignment) {
  for (const auto& [value, name] : kNames) {
    if (value == alignment) return name;
  }
  Check(false, "an alignment without a name");
  return "";
}

Alignment ParseAlignment(std::string_view name) {
  for (const auto& [value, known] : kNames) {
    if (known == name) return value;
  }
  RequireInput(false, "alignment '{}': must be one of none, origin, yaw, se3, sim3", name);
  return Alignment::kNone;
}

std::optional<Similarity> Align(const std::vector<PosePair>& pairs, Alignment alignment) {
  switch (alignment) {
    case Alignment::kNone:
      return Similarity{};
    case Alignment::kOrigin:
      if (pairs.empty()) return std::nullopt;
      return Similarity{1.0, pairs.front().truth * pairs.front().estimate.Inverse()};
    case Alignment::kYaw:
      return AlignYaw(pairs);
    case Alignment::kSe3:
      return AlignUmeyama(pairs, false);
    case Alignment::kSim3:
      return AlignUmeyama(pairs, true);
  }
  return std::nullopt;
}

Similarity AlignPositionAndYaw(const PosePair& pair) {
  const Eigen::Quaterniond rotation = YawRotation(YawBetween(pair.estimate.q(), pair.truth.q()));
  return {1.0, Pose(rotation, pair.truth.p() - rotation * pair.estimate.p())};
}

}  // namespace drydock::score
