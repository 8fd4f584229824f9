#include "scenarios/scoring/initialisation.h"

#include <algorithm>
#include <vector>

#include "scenarios/scoring/association.h"
#include "scenarios/scoring/trajectory_score.h"

namespace drydock::score {
namespace {

constexpr double kFirstMotion = 0.05;  // [m]
constexpr double kLeastPath = 0.5;     // [m]
constexpr Duration kSpan{5 * kNanosecondsPerSecond};

double PathOf(const std::vector<PosePair>& pairs) {
  double path = 0.0;
  for (std::size_t i = 1; i < pairs.size(); ++i)
    path += (pairs[i].truth.p() - pairs[i - 1].truth.p()).norm();
  return path;
}

}  // namespace

std::optional<double> InitialScaleErrorPercent(const Trajectory& truth,
                                               const Trajectory& odometry) {
  const std::vector<PosePair> pairs = Associate(truth, odometry, {}).pairs;
  const auto begin = std::find_if(pairs.begin(), pairs.end(), [&](const PosePair& pair) {
    return (pair.truth.p() - pairs.front().truth.p()).norm() >= kFirstMotion;
  });
  if (begin == pairs.end() || pairs.back().t < begin->t + kSpan) return std::nullopt;
  const auto end = std::find_if(begin, pairs.end(),
                                [&](const PosePair& pair) { return pair.t > begin->t + kSpan; });
  const std::vector<PosePair> first(begin, end);
  if (PathOf(first) < kLeastPath) return std::nullopt;
  return ScaleErrorPercent(first);
}

}  // namespace drydock::score
