#include "estimator/svin2/factors/marginalisation.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "sensors_models/base/check.h"
#include "sensors_models/base/pose_manifold.h"

namespace drydock::svin2 {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The normal equations of some blocks: cost = 1/2 dx' H dx + b' dx.
struct NormalEquations {
  std::vector<std::size_t> members;  ///< The blocks, by their indices, rising.
  std::vector<int> offsets;          ///< Where the tangent of each member begins.
  Eigen::MatrixXd H;
  Eigen::VectorXd b;

  NormalEquations(std::span<const BlockValues> blocks, std::vector<std::size_t> of)
      : members(std::move(of)) {
    int size = 0;
    for (const std::size_t k : members) {
      offsets.push_back(size);
      size += TangentSize(blocks[k]);
    }
    H.setZero(size, size);
    b.setZero(size);
  }

  int OffsetOf(std::size_t block) const {
    const auto at = std::lower_bound(members.begin(), members.end(), block);
    return offsets[static_cast<std::size_t>(at - members.begin())];
  }
};

/// Residuals and their derivatives by the tangents of the term's blocks.
struct Linearisation {
  Eigen::VectorXd error;
  std::vector<Eigen::MatrixXd> jacobians;
};

bool AllFinite(const Linearisation& linear) {
  return linear.error.allFinite() &&
         std::all_of(linear.jacobians.begin(), linear.jacobians.end(),
                     [](const Eigen::MatrixXd& jacobian) { return jacobian.allFinite(); });
}

Eigen::MatrixXd ToTangent(const RowMajor& ambient, const BlockValues& block) {
  if (block.size() != 7) return ambient;
  Eigen::Matrix<double, 7, 6, Eigen::RowMajor> plus;
  PoseManifold().PlusJacobian(block.data(), plus.data());
  return ambient * plus;
}

/// Nothing (no residuals) where the term cannot be evaluated.
Linearisation Linearise(const MarginalTerm& term, std::span<const BlockValues> blocks) {
  const int rows = term.cost->num_residuals();
  std::vector<const double*> parameters;
  std::vector<RowMajor> ambient;
  for (const std::size_t k : term.blocks) {
    parameters.push_back(blocks[k].data());
    ambient.emplace_back(RowMajor::Zero(rows, static_cast<int>(blocks[k].size())));
  }
  std::vector<double*> pointers;
  pointers.reserve(ambient.size());
  for (RowMajor& jacobian : ambient) pointers.push_back(jacobian.data());
  Linearisation linear;
  linear.error.resize(rows);
  if (!term.cost->Evaluate(parameters.data(), linear.error.data(), pointers.data())) return {};

  double weight = 1.0;
  if (term.loss != nullptr) {
    double rho[3];
    term.loss->Evaluate(linear.error.squaredNorm(), rho);
    weight = std::sqrt(std::max(0.0, rho[1]));
  }
  linear.error *= weight;
  for (std::size_t k = 0; k < ambient.size(); ++k)
    linear.jacobians.push_back(weight * ToTangent(ambient[k], blocks[term.blocks[k]]));
  return AllFinite(linear) ? linear : Linearisation{};
}

void AddTerm(std::span<const BlockValues> blocks, const MarginalTerm& term,
             NormalEquations& normal) {
  const Linearisation linear = Linearise(term, blocks);
  for (std::size_t i = 0; i < linear.jacobians.size(); ++i) {
    const Eigen::MatrixXd& J_i = linear.jacobians[i];
    const int at_i = normal.OffsetOf(term.blocks[i]);
    normal.b.segment(at_i, J_i.cols()) += J_i.transpose() * linear.error;
    for (std::size_t j = 0; j < linear.jacobians.size(); ++j) {
      const Eigen::MatrixXd& J_j = linear.jacobians[j];
      normal.H.block(at_i, normal.OffsetOf(term.blocks[j]), J_i.cols(), J_j.cols()) +=
          J_i.transpose() * J_j;
    }
  }
}

/// A positive semi-definite matrix as F' F, and a left inverse of F' on its range.
struct Factorised {
  Eigen::MatrixXd root;     ///< F, a row for each known direction.
  Eigen::MatrixXd inverse;  ///< G with G F' = I, and G' G the pseudo-inverse.
};

Factorised Factorise(const Eigen::MatrixXd& H) {
  constexpr double kUnknown = 1e-13;
  // A diagonal of 0 belongs to a direction of which nothing is known; any scale will do.
  const Eigen::VectorXd scale = H.diagonal().unaryExpr(
      [](double value) { return value > 0.0 ? 1.0 / std::sqrt(value) : 1.0; });
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scale.asDiagonal() * H *
                                                              scale.asDiagonal());
  const Eigen::VectorXd& values = solver.eigenvalues();  // In ascending order.
  const double limit = std::max(0.0, kUnknown * values[values.size() - 1]);
  const auto known = static_cast<int>((values.array() > limit).count());
  const Eigen::VectorXd roots = values.tail(known).cwiseSqrt();
  const auto directions = solver.eigenvectors().rightCols(known).transpose();
  Factorised factorised;
  factorised.root = roots.asDiagonal() * directions * scale.cwiseInverse().asDiagonal();
  factorised.inverse = roots.cwiseInverse().asDiagonal() * directions * scale.asDiagonal();
  return factorised;
}

/// Minimises over the tangent [at, at + size); its rows and columns of H become 0.
void Eliminate(NormalEquations& normal, int at, int size) {
  const Eigen::MatrixXd inverse = Factorise(normal.H.block(at, at, size, size)).inverse;
  const Eigen::MatrixXd coupling = normal.H.middleCols(at, size) * inverse.transpose();
  const Eigen::VectorXd right = inverse * normal.b.segment(at, size);
  normal.b.noalias() -= coupling * right;
  normal.H.noalias() -= coupling * coupling.transpose();
  normal.H.middleCols(at, size).setZero();
  normal.H.middleRows(at, size).setZero();
}

/// Blocks that are to go, the smallest first.
std::vector<std::size_t> BlocksToEliminate(std::span<const BlockValues> blocks,
                                           std::span<const std::size_t> kept) {
  std::vector<std::size_t> eliminated;
  for (std::size_t k = 0; k < blocks.size(); ++k)
    if (std::find(kept.begin(), kept.end(), k) == kept.end()) eliminated.push_back(k);
  std::stable_sort(eliminated.begin(), eliminated.end(), [&](std::size_t a, std::size_t b) {
    return blocks[a].size() < blocks[b].size();
  });
  return eliminated;
}

/// The terms in which a landmark (a block of 3) that is to go meets no other such: it can be
/// eliminated from them alone, before the whole is put together. By landmark.
struct TermGroups {
  std::map<std::size_t, std::vector<std::size_t>> by_landmark;
  std::vector<std::size_t> others;
};

TermGroups GroupTerms(std::span<const BlockValues> blocks, std::span<const MarginalTerm> terms,
                      std::span<const std::size_t> kept) {
  std::vector<bool> is_alone(blocks.size());
  for (std::size_t k = 0; k < blocks.size(); ++k) is_alone[k] = blocks[k].size() == 3;
  for (const std::size_t k : kept) is_alone[k] = false;
  for (const MarginalTerm& term : terms) {
    const auto count = std::count_if(term.blocks.begin(), term.blocks.end(),
                                     [&](std::size_t k) { return blocks[k].size() == 3; });
    if (count > 1)
      for (const std::size_t k : term.blocks) is_alone[k] = false;
  }
  TermGroups groups;
  for (std::size_t k = 0; k < terms.size(); ++k) {
    const auto landmark = std::find_if(terms[k].blocks.begin(), terms[k].blocks.end(),
                                       [&](std::size_t block) { return is_alone[block]; });
    if (landmark == terms[k].blocks.end()) {
      groups.others.push_back(k);
    } else {
      groups.by_landmark[*landmark].push_back(k);
    }
  }
  return groups;
}

/// Adds what the terms of one landmark say about all other blocks.
void AddWithoutLandmark(std::span<const BlockValues> blocks, std::span<const MarginalTerm> terms,
                        std::size_t landmark, const std::vector<std::size_t>& of_landmark,
                        NormalEquations& normal) {
  std::set<std::size_t> members;
  for (const std::size_t k : of_landmark)
    members.insert(terms[k].blocks.begin(), terms[k].blocks.end());
  NormalEquations local(blocks, {members.begin(), members.end()});
  for (const std::size_t k : of_landmark) AddTerm(blocks, terms[k], local);
  Eliminate(local, local.OffsetOf(landmark), TangentSize(blocks[landmark]));
  for (const std::size_t i : local.members) {
    if (i == landmark) continue;
    const int to_i = normal.OffsetOf(i), from_i = local.OffsetOf(i), rows = TangentSize(blocks[i]);
    normal.b.segment(to_i, rows) += local.b.segment(from_i, rows);
    for (const std::size_t j : local.members) {
      if (j == landmark) continue;
      const int columns = TangentSize(blocks[j]);
      normal.H.block(to_i, normal.OffsetOf(j), rows, columns) +=
          local.H.block(from_i, local.OffsetOf(j), rows, columns);
    }
  }
}

}  // namespace

LinearPrior Marginalise(std::span<const BlockValues> blocks, std::span<const MarginalTerm> terms,
                        std::span<const std::size_t> kept) {
  Check(!kept.empty(), "marginalisation must keep a block");
  const TermGroups groups = GroupTerms(blocks, terms, kept);
  std::vector<std::size_t> members;
  for (std::size_t k = 0; k < blocks.size(); ++k)
    if (!groups.by_landmark.contains(k)) members.push_back(k);
  NormalEquations normal(blocks, members);
  for (const auto& [landmark, of_landmark] : groups.by_landmark)
    AddWithoutLandmark(blocks, terms, landmark, of_landmark, normal);
  for (const std::size_t k : groups.others) AddTerm(blocks, terms[k], normal);
  for (const std::size_t k : BlocksToEliminate(blocks, kept))
    if (!groups.by_landmark.contains(k))
      Eliminate(normal, normal.OffsetOf(k), TangentSize(blocks[k]));

  LinearPrior prior;
  std::vector<int> rows;
  for (const std::size_t k : kept) {
    prior.x0.push_back(blocks[k]);
    for (int axis = 0; axis < TangentSize(blocks[k]); ++axis)
      rows.push_back(normal.OffsetOf(k) + axis);
  }
  const Eigen::MatrixXd H = normal.H(rows, rows);
  const Factorised factorised = Factorise(0.5 * (H + H.transpose()));
  prior.jacobian = factorised.root;
  prior.error = factorised.inverse * normal.b(rows);
  if (prior.error.size() == 0) {
    prior.jacobian.setZero(1, H.cols());
    prior.error.setZero(1);
  }
  return prior;
}

}  // namespace drydock::svin2
