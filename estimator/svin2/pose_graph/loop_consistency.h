// Which loops to believe.
#pragma once

#include <optional>
#include <vector>

#include "estimator/svin2/pose_graph/odometry_chain.h"
#include "estimator/svin2/pose_graph/pose_graph_types.h"

namespace drydock::svin2 {

/// Holds each loop against odometry, and loops against each other (pairwise consistency, Mangelson
/// et al., ICRA 2018), by chi-square.
///
/// A loop from a to b says where b should be: by E = T_a Z T_b^-1 from where odometry has it. That
/// must be within what odometry can have drifted from a to b. Two loops must agree on it, but for
/// the drift from the one's ends to the other's, which is little where they are near each other.
///
/// Of loops that are at odds the heavier side is believed. A loop weighs (max - chi2 against
/// odometry) / n^0.9, where n loops, itself one, agree and see the same place. A thing that looks
/// like another is seen as often as the body passes it, so n sightings weigh little more than one:
/// n^0.1.
class LoopConsistency {
 public:
  explicit LoopConsistency(const LoopCheckConfig& config) : config_(config) {}

  /// A loop between two nodes of the chain, by their positions in it.
  void Add(const OdometryChain& chain, std::size_t from, std::size_t to, const Pose& T_from_to,
           const Matrix6d& covariance);

  /// One a loop, in the order of their coming.
  std::vector<LoopVerdict> Verdicts() const;

 private:
  struct Loop {
    std::size_t from = 0, to = 0;
    Pose E;                      // What the loop says of the piece of `to`, in that of `from`.
    Matrix6d noise;              // Of E as a motion of the piece of `from`.
    std::optional<double> chi2;  // Against odometry; nothing between pieces.
    int sightings = 1;
    std::vector<std::size_t> conflicts;
  };

  bool IsRefused(const Loop& loop) const { return loop.chi2 && !(*loop.chi2 <= config_.max_chi2); }
  double Weight(const Loop& loop) const;
  bool SeeTheSame(const Loop& a, const Loop& b) const;
  bool Agree(const OdometryChain& chain, const Loop& k, const Loop& l) const;
  std::vector<bool> HeavierSide() const;

  LoopCheckConfig config_;
  std::vector<Loop> loops_;
};

}  // namespace drydock::svin2
