#include "estimator/svin2/pose_graph/pose_graph_solver.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include <ceres/loss_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

#include "estimator/svin2/factors/level_factor.h"
#include "estimator/svin2/factors/relative_pose_factor.h"
#include "sensors_models/base/check.h"
#include "sensors_models/base/pose_manifold.h"

namespace drydock::svin2 {
namespace {

constexpr double kUnknownHeight = 1e6;  // Standard deviation [m].

ceres::Problem::Options ProblemOptions() {
  ceres::Problem::Options options;
  options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.manifold_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.disable_all_safety_checks = true;
  return options;
}

ceres::Solver::Options SolverOptions(int iterations) {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  // Not SuiteSparse, which is GPL in parts and need not be there.
  options.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;
  options.trust_region_strategy_type = ceres::LEVENBERG_MARQUARDT;
  options.max_num_iterations = iterations;
  options.function_tolerance = 1e-8;
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  return options;
}

}  // namespace

DisjointSets::DisjointSets(std::size_t size) : parents_(size) {
  std::iota(parents_.begin(), parents_.end(), std::size_t{0});
}

std::size_t DisjointSets::SmallestOf(std::size_t element) {
  while (parents_[element] != element) {
    parents_[element] = parents_[parents_[element]];
    element = parents_[element];
  }
  return element;
}

void DisjointSets::Join(std::size_t a, std::size_t b) {
  const auto [smaller, larger] = std::minmax({SmallestOf(a), SmallestOf(b)});
  parents_[larger] = smaller;
}

PoseGraphSolver::PoseGraphSolver(const PoseGraph& graph, const PoseGraphOptions& options,
                                 std::vector<LoopVerdict> verdicts)
    : graph_(graph),
      options_(options),
      parts_(graph.nodes().size()),
      components_(graph.nodes().size()),
      has_loop_(graph.nodes().size(), false) {
  Check(options.iterations > 0 && options.huber_sigmas > 0.0 && options.huber_identity > 0.0,
        "iterations and Huber's widths must be above 0");
  result_.T_GI = graph.T_GI();
  result_.verdicts = std::move(verdicts);
}

PoseGraphSolver::End PoseGraphSolver::EndsOf(const PoseGraphEdge& edge) const {
  return {graph_.PositionOf(edge.from), graph_.PositionOf(edge.to)};
}

PoseGraphResult PoseGraphSolver::Solve() {
  JoinComponents();
  PlaceParts();
  if (Minimise()) FollowOn();
  return std::move(result_);
}

void PoseGraphSolver::JoinComponents() {
  for (const PoseGraphEdge& edge : graph_.links()) {
    const End ends = EndsOf(edge);
    parts_.Join(ends.from, ends.to);
    components_.Join(ends.from, ends.to);
  }
  const auto for_each_believed = [this](auto visit) {
    for (std::size_t k = 0; k < graph_.loops().size(); ++k)
      if (result_.verdicts[k] == LoopVerdict::kBelieved) visit(EndsOf(graph_.loops()[k]));
  };
  for_each_believed([this](const End& ends) { components_.Join(ends.from, ends.to); });
  for_each_believed([this](const End& ends) { has_loop_[components_.SmallestOf(ends.to)] = true; });
  for (std::size_t k = 0; k < result_.T_GI.size(); ++k)
    if (components_.SmallestOf(k) == k) ++result_.report.components;
}

void PoseGraphSolver::MovePart(std::size_t part, const Pose& motion) {
  for (std::size_t k = part; k < result_.T_GI.size(); ++k)
    if (parts_.SmallestOf(k) == part) result_.T_GI[k] = motion * result_.T_GI[k];
}

void PoseGraphSolver::PlaceParts() {
  std::vector<Pose>& T_GI = result_.T_GI;
  std::vector<bool> placed(T_GI.size(), false);
  for (std::size_t k = 0; k < T_GI.size(); ++k) {
    const Pose& T_WI = graph_.nodes()[k].T_WI;
    if (!has_loop_[components_.SmallestOf(k)]) T_GI[k] = T_WI;
    if (components_.SmallestOf(k) != k) continue;
    // Elsewhere if a loop was believed that is not any more.
    if (T_GI[k].BoxMinus(T_WI).norm() > 1e-9) MovePart(k, T_WI * T_GI[k].Inverse());
    T_GI[k] = T_WI;
    placed[k] = true;
  }
  for (bool moved = true; std::exchange(moved, false);) {
    for (std::size_t k = 0; k < graph_.loops().size(); ++k) {
      if (result_.verdicts[k] != LoopVerdict::kBelieved) continue;
      const PoseGraphEdge& loop = graph_.loops()[k];
      const End ends = EndsOf(loop);
      const std::size_t part_from = parts_.SmallestOf(ends.from);
      const std::size_t part_to = parts_.SmallestOf(ends.to);
      if (placed[part_from] == placed[part_to]) continue;
      const Pose motion = T_GI[ends.from] * loop.T_from_to * T_GI[ends.to].Inverse();
      if (placed[part_from]) {
        MovePart(part_to, motion);
      } else {
        MovePart(part_from, motion.Inverse());
      }
      placed[part_from] = placed[part_to] = moved = true;
    }
  }
}

bool PoseGraphSolver::Minimise() {
  const std::size_t count = result_.T_GI.size();
  PoseManifold manifold;
  ceres::HuberLoss huber(options_.identity_weights ? options_.huber_identity
                                                   : options_.huber_sigmas);
  ceres::Problem problem(ProblemOptions());
  // In one array, in the order of nodes: Ceres orders blocks by their addresses.
  std::vector<PoseParameters> states(count);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t oldest = components_.SmallestOf(k);
    if (!has_loop_[oldest]) continue;
    states[k] = ToParameters(result_.T_GI[k]);
    problem.AddParameterBlock(states[k].data(), 7, &manifold);
    if (oldest == k) problem.SetParameterBlockConstant(states[k].data());
    const PoseGraphNode& node = graph_.nodes()[k];
    if (!node.level || options_.identity_weights) continue;
    // Another map was laid at a height of its own.
    const bool is_height_known = node.map_id == graph_.nodes()[oldest].map_id;
    problem.AddResidualBlock(
        new LevelFactor(node.T_WI, is_height_known ? node.level->z : kUnknownHeight,
                        node.level->tilt),
        nullptr, states[k].data());
  }
  if (problem.NumParameterBlocks() == 0) return true;
  const auto add = [&](const PoseGraphEdge& edge, ceres::LossFunction* loss) {
    const End ends = EndsOf(edge);
    if (!has_loop_[components_.SmallestOf(ends.to)]) return;
    const Matrix6d whitening =
        options_.identity_weights ? Matrix6d::Identity() : WhiteningOf(edge.covariance);
    problem.AddResidualBlock(new RelativePoseFactor(edge.T_from_to, whitening), loss,
                             states[ends.from].data(), states[ends.to].data());
  };
  for (const PoseGraphEdge& edge : graph_.links()) add(edge, nullptr);
  for (std::size_t k = 0; k < graph_.loops().size(); ++k)
    if (result_.verdicts[k] == LoopVerdict::kBelieved) add(graph_.loops()[k], &huber);

  ceres::Solver::Summary summary;
  ceres::Solve(SolverOptions(options_.iterations), &problem, &summary);
  PoseGraphReport& report = result_.report;
  report.iterations = static_cast<int>(summary.iterations.size());
  report.initial_cost = summary.initial_cost;
  report.final_cost = summary.final_cost;
  report.converged = summary.termination_type == ceres::CONVERGENCE;
  report.usable = summary.IsSolutionUsable();
  if (!report.usable) {
    result_.T_GI = graph_.T_GI();
    return false;
  }
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t oldest = components_.SmallestOf(k);
    if (has_loop_[oldest] && oldest != k) result_.T_GI[k] = FromParameters(states[k].data());
  }
  return true;
}

void PoseGraphSolver::FollowOn() {
  std::vector<Pose>& T_GI = result_.T_GI;
  // By a component's oldest node, which lies where odometry has it.
  std::vector<std::optional<Pose>> motions(T_GI.size());
  for (std::size_t k = 0; k < T_GI.size(); ++k) {
    const std::size_t oldest = components_.SmallestOf(k);
    if (oldest == k && k > 0)
      motions[k] = CorrectionBetween(graph_.nodes()[k - 1].T_WI, T_GI[k - 1]);
    if (motions[oldest]) T_GI[k] = *motions[oldest] * T_GI[k];
  }
}

}  // namespace drydock::svin2
