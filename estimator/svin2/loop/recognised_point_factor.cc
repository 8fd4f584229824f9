#include "estimator/svin2/loop/recognised_point_factor.h"

#include <array>
#include <cmath>

#include "sensors_models/base/check.h"

namespace drydock::svin2 {
namespace {

template <int kColumns>
using Rows = Eigen::Matrix<double, 2, kColumns, Eigen::RowMajor>;

}  // namespace

RecognisedPointFactor::RecognisedPointFactor(const StereoGeometry& rig, const Eigen::Vector2d& left,
                                             const Eigen::Vector2d& right, double sigma_px,
                                             double offset_px)
    : left_(rig.camera(0), rig.T_IC(0), left, 1.0),
      right_(rig.camera(1), rig.T_IC(1), right, 1.0),
      sum_weight_(1.0 / std::sqrt(2.0 * sigma_px * sigma_px + 4.0 * offset_px * offset_px)),
      difference_weight_(1.0 / (std::sqrt(2.0) * sigma_px)) {
  Check(sigma_px > 0.0 && offset_px >= 0.0,
        "a keypoint's standard deviation must be above 0, not {}, and its offset not below 0: {}",
        sigma_px, offset_px);
}

bool RecognisedPointFactor::Evaluate(double const* const* parameters, double* residuals,
                                     double** jacobians) const {
  std::array<Eigen::Vector2d, 2> error;
  std::array<Rows<7>, 2> by_pose;
  std::array<Rows<3>, 2> by_landmark;
  for (std::size_t k = 0; k < 2; ++k) {
    std::array<double*, 2> blocks = {by_pose[k].data(), by_landmark[k].data()};
    const ReprojectionFactor& eye = k == 0 ? left_ : right_;
    if (!eye.Evaluate(parameters, error[k].data(), jacobians == nullptr ? nullptr : blocks.data()))
      return false;
  }
  Eigen::Map<Eigen::Vector4d>(residuals, 4) << sum_weight_ * (error[0] + error[1]),
      difference_weight_ * (error[0] - error[1]);
  if (jacobians == nullptr) return true;
  const auto store = [&](const auto& left, const auto& right, double* block) {
    if (block == nullptr) return;
    constexpr int kColumns = std::decay_t<decltype(left)>::ColsAtCompileTime;
    Eigen::Map<Eigen::Matrix<double, 4, kColumns, Eigen::RowMajor>>{block}
        << sum_weight_ * (left + right),
        difference_weight_ * (left - right);
  };
  store(by_pose[0], by_pose[1], jacobians[0]);
  store(by_landmark[0], by_landmark[1], jacobians[1]);
  return true;
}

}  // namespace drydock::svin2
