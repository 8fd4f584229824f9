#include "estimator/svin2/graph/factor_graph.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include <ceres/problem.h>
#include <ceres/solver.h>

#include "estimator/svin2/factors/marginalisation.h"
#include "sensors_models/base/check.h"
#include "sensors_models/base/pose_manifold.h"

namespace drydock::svin2 {
namespace {

constexpr std::size_t kPoseSize = 7;
constexpr std::size_t kLandmarkSize = 3;

ceres::Problem::Options ProblemOptions() {
  ceres::Problem::Options options;
  options.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.manifold_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.disable_all_safety_checks = true;
  return options;
}

ceres::Solver::Options SolverOptions(const SolverLimits& limits) {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_SCHUR;
  options.trust_region_strategy_type = ceres::LEVENBERG_MARQUARDT;
  options.max_num_iterations = limits.iterations;
  if (limits.seconds) options.max_solver_time_in_seconds = *limits.seconds;
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  return options;
}

}  // namespace

BlockId FactorGraph::AddBlock(std::span<const double> values) {
  const BlockId id{++last_block_};
  blocks_.emplace(id, Block{BlockValues(values.begin(), values.end()), {}});
  return id;
}

BlockId FactorGraph::AddPose(const Pose& T_WI) { return AddBlock(ToParameters(T_WI)); }

std::span<double> FactorGraph::Values(BlockId block) { return blocks_.at(block).values; }

std::span<const double> FactorGraph::Values(BlockId block) const {
  return blocks_.at(block).values;
}

Pose FactorGraph::PoseOf(BlockId block) const { return FromParameters(Values(block).data()); }

FactorId FactorGraph::AddFactor(std::unique_ptr<ceres::CostFunction> cost,
                                std::vector<BlockId> blocks, std::optional<double> cauchy_scale) {
  const FactorId id{++last_factor_};
  for (const BlockId block : blocks) blocks_.at(block).factors.push_back(id);
  std::unique_ptr<ceres::LossFunction> loss;
  if (cauchy_scale) loss = std::make_unique<ceres::CauchyLoss>(*cauchy_scale);
  factors_.emplace(id, Factor{std::move(cost), std::move(loss), std::move(blocks)});
  return id;
}

void FactorGraph::RemoveFactor(FactorId factor) {
  const auto at = factors_.find(factor);
  Check(at != factors_.end(), "there is no factor {}", static_cast<std::uint64_t>(factor));
  for (const BlockId block : at->second.blocks) {
    std::vector<FactorId>& of_block = blocks_.at(block).factors;
    of_block.erase(std::lower_bound(of_block.begin(), of_block.end(), factor));
  }
  factors_.erase(at);
}

void FactorGraph::RemoveBlock(BlockId block) {
  Check(!IsInPrior(block), "a block of the prior can only be marginalised");
  const std::vector<FactorId> factors = FactorsOf(block);
  for (const FactorId factor : factors) RemoveFactor(factor);
  blocks_.erase(block);
}

const std::vector<FactorId>& FactorGraph::FactorsOf(BlockId block) const {
  return blocks_.at(block).factors;
}

double FactorGraph::ChiSquare(FactorId factor) const {
  const Factor& that = factors_.at(factor);
  std::vector<const double*> parameters;
  parameters.reserve(that.blocks.size());
  for (const BlockId block : that.blocks) parameters.push_back(blocks_.at(block).values.data());
  Eigen::VectorXd residual(that.cost->num_residuals());
  if (!that.cost->Evaluate(parameters.data(), residual.data(), nullptr) || !residual.allFinite())
    return std::numeric_limits<double>::infinity();
  return residual.squaredNorm();
}

std::set<BlockId> FactorGraph::TiedLandmarks() const {
  std::set<BlockId> tied;
  const auto is_landmark = [this](BlockId block) {
    return blocks_.at(block).values.size() == kLandmarkSize;
  };
  for (const auto& [id, factor] : factors_)
    if (std::count_if(factor.blocks.begin(), factor.blocks.end(), is_landmark) > 1)
      tied.insert(factor.blocks.begin(), factor.blocks.end());
  return tied;
}

SolverReport FactorGraph::Optimise(const SolverLimits& limits) {
  SolverReport report;
  if (factors_.empty()) return report;
  // Ceres orders blocks by their addresses: in one array, in the order of ids, runs agree to the
  // bit.
  std::map<BlockId, std::size_t> offsets;
  std::vector<double> state;
  for (const auto& [id, block] : blocks_) {
    offsets.emplace(id, state.size());
    state.insert(state.end(), block.values.begin(), block.values.end());
  }

  PoseManifold manifold;
  ceres::Problem problem(ProblemOptions());
  ceres::Solver::Options options = SolverOptions(limits);
  options.linear_solver_ordering = std::make_shared<ceres::ParameterBlockOrdering>();
  const std::set<BlockId> tied = TiedLandmarks();
  for (const auto& [id, block] : blocks_) {
    if (block.factors.empty()) continue;
    double* values = state.data() + offsets.at(id);
    const std::size_t size = block.values.size();
    problem.AddParameterBlock(values, static_cast<int>(size),
                              size == kPoseSize ? &manifold : nullptr);
    const bool goes_first = size == kLandmarkSize && !tied.contains(id);
    options.linear_solver_ordering->AddElementToGroup(values, goes_first ? 0 : 1);
  }
  std::vector<double*> parameters;
  for (const auto& [id, factor] : factors_) {
    parameters.clear();
    for (const BlockId block : factor.blocks)
      parameters.push_back(state.data() + offsets.at(block));
    problem.AddResidualBlock(factor.cost.get(), factor.loss.get(), parameters);
  }

  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  report.iterations = static_cast<int>(summary.iterations.size());
  report.initial_cost = summary.initial_cost;
  report.final_cost = summary.final_cost;
  report.usable = summary.IsSolutionUsable();
  if (!report.usable) return report;
  for (auto& [id, block] : blocks_)
    std::copy_n(state.data() + offsets.at(id), block.values.size(), block.values.data());
  return report;
}

const LinearPriorFactor* FactorGraph::Prior() const {
  if (!prior_) return nullptr;
  return static_cast<const LinearPriorFactor*>(factors_.at(*prior_).cost.get());
}

bool FactorGraph::IsInPrior(BlockId block) const {
  if (!prior_) return false;
  const std::vector<FactorId>& factors = FactorsOf(block);
  return std::binary_search(factors.begin(), factors.end(), *prior_);
}

const BlockValues& FactorGraph::LinearisationPoint(BlockId block) const {
  if (!IsInPrior(block)) return blocks_.at(block).values;
  const std::vector<BlockId>& of_prior = factors_.at(*prior_).blocks;
  const auto at = std::find(of_prior.begin(), of_prior.end(), block) - of_prior.begin();
  return Prior()->prior().x0[static_cast<std::size_t>(at)];
}

std::vector<BlockId> FactorGraph::BlocksOf(const std::vector<FactorId>& factors) const {
  std::vector<BlockId> blocks;
  for (const FactorId factor : factors) {
    const std::vector<BlockId>& of_factor = factors_.at(factor).blocks;
    blocks.insert(blocks.end(), of_factor.begin(), of_factor.end());
  }
  std::sort(blocks.begin(), blocks.end());
  blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
  return blocks;
}

LinearPrior FactorGraph::Reduce(const std::vector<FactorId>& factors,
                                std::span<const BlockId> kept) const {
  const std::vector<BlockId> blocks = BlocksOf(factors);
  const auto index_of = [&](BlockId block) {
    return static_cast<std::size_t>(std::lower_bound(blocks.begin(), blocks.end(), block) -
                                    blocks.begin());
  };
  std::vector<BlockValues> values;
  values.reserve(blocks.size());
  for (const BlockId block : blocks) values.push_back(LinearisationPoint(block));
  std::vector<MarginalTerm> terms;
  for (const FactorId id : factors) {
    const Factor& factor = factors_.at(id);
    MarginalTerm term{factor.cost.get(), factor.loss.get(), {}};
    for (const BlockId block : factor.blocks) term.blocks.push_back(index_of(block));
    terms.push_back(std::move(term));
  }
  std::vector<std::size_t> kept_indices;
  for (const BlockId block : kept) kept_indices.push_back(index_of(block));
  return svin2::Marginalise(values, terms, kept_indices);
}

void FactorGraph::Marginalise(std::span<const BlockId> gone) {
  std::set<FactorId> touching;
  for (const BlockId block : gone)
    touching.insert(FactorsOf(block).begin(), FactorsOf(block).end());
  if (prior_) touching.insert(*prior_);
  const std::vector<FactorId> factors(touching.begin(), touching.end());
  std::vector<BlockId> kept;
  for (const BlockId block : BlocksOf(factors))
    if (std::find(gone.begin(), gone.end(), block) == gone.end()) kept.push_back(block);

  std::unique_ptr<LinearPriorFactor> prior;
  if (!kept.empty()) prior = std::make_unique<LinearPriorFactor>(Reduce(factors, kept));
  for (const FactorId factor : factors) RemoveFactor(factor);
  prior_.reset();
  for (const BlockId block : gone) blocks_.erase(block);
  if (prior) prior_ = AddFactor(std::move(prior), kept);
}

std::optional<Eigen::MatrixXd> FactorGraph::CovarianceOf(BlockId block) const {
  const std::array<BlockId, 1> blocks = {block};
  return CovarianceOf(blocks);
}

std::optional<Eigen::MatrixXd> FactorGraph::CovarianceOf(std::span<const BlockId> blocks) const {
  std::vector<FactorId> all;
  all.reserve(factors_.size());
  for (const auto& [id, factor] : factors_) all.push_back(id);
  const LinearPrior reduced = Reduce(all, blocks);
  const Eigen::MatrixXd information = reduced.jacobian.transpose() * reduced.jacobian;
  if (reduced.jacobian.rows() < information.rows()) return std::nullopt;
  const Eigen::LLT<Eigen::MatrixXd> cholesky(information);
  if (cholesky.info() != Eigen::Success) return std::nullopt;
  return cholesky.solve(Eigen::MatrixXd::Identity(information.rows(), information.cols()));
}

}  // namespace drydock::svin2
