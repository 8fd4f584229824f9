// Unknown states and what is known about them.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include <ceres/cost_function.h>
#include <ceres/loss_function.h>

#include "estimator/svin2/factors/linear_prior_factor.h"
#include "sensors_models/base/pose.h"

namespace drydock::svin2 {

/// Count up from 1 in the order in which blocks and factors were added; never used again.
enum class BlockId : std::uint64_t {};
enum class FactorId : std::uint64_t {};

struct SolverLimits {
  int iterations = 5;
  /// Wall-clock time [s]; nothing: iterations alone count, and the result is reproducible.
  std::optional<double> seconds;
};

struct SolverReport {
  int iterations = 0;
  double initial_cost = 0.0;
  double final_cost = 0.0;
  bool usable = true;  ///< Else the states are as they were.
};

/// A factor graph whose blocks can be added, optimised (by Ceres) and marginalised. Blocks of 7 are
/// poses on PoseManifold; blocks of 3 are landmarks, which the solver eliminates first; others are
/// Euclidean. Deterministic: everything happens in the order of the ids.
class FactorGraph {
 public:
  FactorGraph() = default;
  FactorGraph(const FactorGraph&) = delete;
  FactorGraph& operator=(const FactorGraph&) = delete;

  BlockId AddBlock(std::span<const double> values);
  BlockId AddPose(const Pose& T_WI);

  /// A view of the block's values, until it is removed; writing moves the state.
  std::span<double> Values(BlockId block);
  std::span<const double> Values(BlockId block) const;
  Pose PoseOf(BlockId block) const;

  /// `blocks` are the cost's parameters, in its order. `cauchy_scale`: width of Cauchy's robust
  /// loss, in standard deviations of the residual; nothing: the plain square.
  FactorId AddFactor(std::unique_ptr<ceres::CostFunction> cost, std::vector<BlockId> blocks,
                     std::optional<double> cauchy_scale = std::nullopt);
  void RemoveFactor(FactorId factor);
  /// Forgets a block and all factors that touch it, with what they say about others. Not for blocks
  /// of the prior.
  void RemoveBlock(BlockId block);
  const std::vector<FactorId>& FactorsOf(BlockId block) const;

  /// Twice the factor's cost without robust loss: chi-square of its residual; infinite where it
  /// cannot be evaluated.
  double ChiSquare(FactorId factor) const;

  /// Moves all blocks to the least cost. States stay as they were where that fails.
  SolverReport Optimise(const SolverLimits& limits);

  /// Takes blocks out and keeps what all factors that touch them say about the other blocks in one
  /// linear prior, with first estimates (see svin2::Marginalise).
  void Marginalise(std::span<const BlockId> gone);
  bool IsInPrior(BlockId block) const;

  /// Joint covariance of the tangents of `blocks`, in this order, all others being unknown too;
  /// nothing where it is not determined.
  std::optional<Eigen::MatrixXd> CovarianceOf(std::span<const BlockId> blocks) const;
  std::optional<Eigen::MatrixXd> CovarianceOf(BlockId block) const;

  std::size_t num_blocks() const { return blocks_.size(); }
  std::size_t num_factors() const { return factors_.size(); }

 private:
  struct Block {
    BlockValues values;
    std::vector<FactorId> factors;  // Rising.
  };
  struct Factor {
    std::unique_ptr<ceres::CostFunction> cost;
    std::unique_ptr<ceres::LossFunction> loss;
    std::vector<BlockId> blocks;
  };

  /// Landmarks that share a factor (a sonar's patch), which cannot be eliminated one by one.
  std::set<BlockId> TiedLandmarks() const;
  LinearPrior Reduce(const std::vector<FactorId>& factors, std::span<const BlockId> kept) const;
  const BlockValues& LinearisationPoint(BlockId block) const;
  std::vector<BlockId> BlocksOf(const std::vector<FactorId>& factors) const;
  const LinearPriorFactor* Prior() const;

  std::map<BlockId, Block> blocks_;
  std::map<FactorId, Factor> factors_;
  std::uint64_t last_block_ = 0, last_factor_ = 0;
  std::optional<FactorId> prior_;
};

}  // namespace drydock::svin2
