// A factor's derivatives against differences, on the manifold.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

#include <ceres/cost_function.h>

#include "sensors_models/base/pose_manifold.h"
#include "tests/support/numeric.h"

namespace drydock::svin2::testing {

/// One vector of parameters a block. Blocks of 7 are poses.
using Blocks = std::vector<std::vector<double>>;

template <typename Array>
std::vector<double> Block(const Array& values) {
  return {values.begin(), values.end()};
}

inline std::vector<double> Block(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

inline std::vector<const double*> Pointers(const Blocks& blocks) {
  std::vector<const double*> pointers;
  pointers.reserve(blocks.size());
  for (const auto& block : blocks) pointers.push_back(block.data());
  return pointers;
}

inline Eigen::VectorXd Residuals(const ceres::CostFunction& factor, const Blocks& blocks) {
  Eigen::VectorXd residuals(factor.num_residuals());
  if (!factor.Evaluate(Pointers(blocks).data(), residuals.data(), nullptr))
    residuals.setConstant(std::nan(""));
  return residuals;
}

/// `block` moved by `by` along direction `axis` of its tangent space.
inline std::vector<double> Moved(const std::vector<double>& block, int axis, double by) {
  std::vector<double> moved = block;
  if (block.size() != 7) {
    moved[static_cast<std::size_t>(axis)] += by;
    return moved;
  }
  const Vector6d delta = by * Vector6d::Unit(axis);
  PoseManifold().Plus(block.data(), delta.data(), moved.data());
  return moved;
}

/// The factor's derivatives by each block's tangent space: its Jacobians times PlusJacobian, as
/// Ceres takes them.
inline std::vector<Eigen::MatrixXd> TangentJacobians(const ceres::CostFunction& factor,
                                                     const Blocks& blocks) {
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  std::vector<RowMajor> ambient;
  ambient.reserve(blocks.size());
  for (const auto& block : blocks)
    ambient.push_back(
        RowMajor::Constant(factor.num_residuals(), static_cast<int>(block.size()), 1e9));
  std::vector<double*> pointers;
  pointers.reserve(blocks.size());
  for (auto& jacobian : ambient) pointers.push_back(jacobian.data());
  Eigen::VectorXd residuals(factor.num_residuals());
  factor.Evaluate(Pointers(blocks).data(), residuals.data(), pointers.data());

  std::vector<Eigen::MatrixXd> tangent;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    if (blocks[b].size() != 7) {
      tangent.emplace_back(ambient[b]);
      continue;
    }
    Eigen::Matrix<double, 7, 6, Eigen::RowMajor> plus;
    PoseManifold().PlusJacobian(blocks[b].data(), plus.data());
    tangent.emplace_back(ambient[b] * plus);
  }
  return tangent;
}

/// The largest error of a derivative by the tangent spaces of all blocks, as a share of the largest
/// derivative in its row (of all blocks) or of 1, whichever is larger.
inline double WorstJacobianError(const ceres::CostFunction& factor, const Blocks& blocks,
                                 double step = 1e-4) {
  const auto analytic = TangentJacobians(factor, blocks);
  Eigen::VectorXd scale = Eigen::VectorXd::Ones(factor.num_residuals());
  for (const auto& jacobian : analytic)
    scale = scale.cwiseMax(jacobian.cwiseAbs().rowwise().maxCoeff());
  double worst = 0.0;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    for (int axis = 0; axis < analytic[b].cols(); ++axis) {
      const auto along = [&](double by) {
        Blocks moved = blocks;
        moved[b] = Moved(blocks[b], axis, by);
        return Residuals(factor, moved);
      };
      const Eigen::VectorXd numeric = drydock::testing::NumericDerivative(along, 0.0, step);
      const Eigen::VectorXd error = (analytic[b].col(axis) - numeric).cwiseQuotient(scale);
      // Not max(): it would overlook a NaN.
      if (!(error.cwiseAbs().maxCoeff() <= worst)) worst = error.cwiseAbs().maxCoeff();
    }
  }
  return worst;
}

}  // namespace drydock::svin2::testing
