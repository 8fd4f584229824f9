#include "estimator/svin2/pose_graph/loop_consistency.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

namespace drydock::svin2 {
namespace {

/// Chi-square of a motion of a frame that should be none, as seen at pose `T` of that frame.
double ChiSquare(const Pose& motion, const Pose& T, const Matrix6d& covariance) {
  const Vector6d error = (motion * T).BoxMinus(T);
  const Eigen::LDLT<Matrix6d> cholesky(AtPoint(T.p(), covariance));
  if (cholesky.info() != Eigen::Success || !cholesky.isPositive())
    return std::numeric_limits<double>::infinity();
  return error.dot(cholesky.solve(error));
}

std::int64_t Apart(std::size_t a, std::size_t b) {
  return std::abs(static_cast<std::int64_t>(a) - static_cast<std::int64_t>(b));
}

}  // namespace

double LoopConsistency::Weight(const Loop& loop) const {
  // Between pieces odometry speaks neither for the loop nor against it.
  const double chi2 = loop.chi2.value_or(0.5 * config_.max_chi2);
  return (config_.max_chi2 - chi2) / std::pow(loop.sightings, 0.9);
}

bool LoopConsistency::SeeTheSame(const Loop& a, const Loop& b) const {
  return Apart(a.from, b.from) <= config_.streak_keyframes &&
         Apart(a.to, b.to) <= config_.streak_keyframes;
}

bool LoopConsistency::Agree(const OdometryChain& chain, const Loop& k, const Loop& l) const {
  const std::size_t piece_from = chain.PieceOf(k.from), piece_to = chain.PieceOf(k.to);
  // No ring leads over both loops, or they are two rings of their own.
  if (piece_from != chain.PieceOf(l.from) || piece_to != chain.PieceOf(l.to)) return true;
  if (piece_from == piece_to && (k.to <= l.from || l.to <= k.from)) return true;
  const Pose E_k_inverse = k.E.Inverse();
  const double factor = config_.sigma_factor * config_.sigma_factor;
  const Matrix6d in_from = factor * chain.DriftBetween(k.from, l.from) + k.noise + l.noise;
  const Matrix6d in_to =
      Transported(E_k_inverse, in_from) + factor * chain.DriftBetween(k.to, l.to);
  return ChiSquare(E_k_inverse * l.E, chain.T_PI(l.to), in_to) <= config_.max_chi2;
}

void LoopConsistency::Add(const OdometryChain& chain, std::size_t from, std::size_t to,
                          const Pose& T_from_to, const Matrix6d& covariance) {
  const double factor = config_.sigma_factor * config_.sigma_factor;
  Loop added;
  added.from = from;
  added.to = to;
  const Pose looped = chain.T_PI(from) * T_from_to;
  added.E = looped * chain.T_PI(to).Inverse();
  added.noise = factor * ToFrame(chain.T_PI(from).R(), looped.p(), covariance);
  if (chain.PieceOf(from) == chain.PieceOf(to)) {
    const Matrix6d drift = factor * chain.DriftBetween(from, to);
    added.chi2 = ChiSquare(added.E, chain.T_PI(to), drift + added.noise);
  }
  const std::size_t id = loops_.size();
  if (!IsRefused(added)) {
    for (std::size_t k = 0; k < id; ++k) {
      Loop& other = loops_[k];
      if (IsRefused(other)) continue;
      if (!Agree(chain, other, added)) {
        other.conflicts.push_back(id);
        added.conflicts.push_back(k);
      } else if (SeeTheSame(other, added)) {
        ++other.sightings;
        ++added.sightings;
      }
    }
  }
  loops_.push_back(std::move(added));
}

std::vector<bool> LoopConsistency::HeavierSide() const {
  const std::size_t count = loops_.size();
  std::vector<bool> kept(count);
  std::vector<double> weight(count), against(count, 0.0);
  for (std::size_t k = 0; k < count; ++k) {
    kept[k] = !IsRefused(loops_[k]);
    weight[k] = Weight(loops_[k]);
  }
  for (std::size_t k = 0; k < count; ++k)
    for (const std::size_t other : loops_[k].conflicts) against[k] += weight[other];
  // The one that the most speaks against goes, and its vote with it, until no two are at odds.
  const auto in_conflict = [&](std::size_t k) {
    const auto& conflicts = loops_[k].conflicts;
    return kept[k] && std::any_of(conflicts.begin(), conflicts.end(),
                                  [&](std::size_t other) { return kept[other]; });
  };
  while (true) {
    std::optional<std::size_t> worst;
    for (std::size_t k = 0; k < count; ++k)
      if (in_conflict(k) && (!worst || against[k] >= against[*worst])) worst = k;
    if (!worst) break;
    kept[*worst] = false;
    for (const std::size_t other : loops_[*worst].conflicts) against[other] -= weight[*worst];
  }
  // Whoever went because of one that went later comes back.
  for (std::size_t k = 0; k < count; ++k)
    if (!kept[k] && !IsRefused(loops_[k])) {
      kept[k] = true;
      kept[k] = !in_conflict(k);
    }
  return kept;
}

std::vector<LoopVerdict> LoopConsistency::Verdicts() const {
  const std::vector<bool> kept = HeavierSide();
  std::vector<LoopVerdict> verdicts;
  verdicts.reserve(loops_.size());
  for (std::size_t k = 0; k < loops_.size(); ++k) {
    if (IsRefused(loops_[k])) {
      verdicts.push_back(LoopVerdict::kAgainstOdometry);
    } else {
      verdicts.push_back(kept[k] ? LoopVerdict::kBelieved : LoopVerdict::kAgainstLoops);
    }
  }
  return verdicts;
}

}  // namespace drydock::svin2
