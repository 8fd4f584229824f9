#include "scenarios/scoring/association.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>

#include <fmt/format.h>

namespace drydock::score {
namespace {

/// The double that is nearest to the decimal number of seconds, as reading it from a file gives.
double DecimalSeconds(Time t) {
  const auto [seconds, rest] = std::lldiv(t.ns, kNanosecondsPerSecond);
  const std::string text =
      fmt::format("{}{}.{:09}", t.ns < 0 ? "-" : "", std::llabs(seconds), std::llabs(rest));
  double value = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

std::vector<double> Stamps(const Trajectory& trajectory) {
  std::vector<double> stamps;
  stamps.reserve(trajectory.size());
  for (const StampedPose& pose : trajectory) stamps.push_back(DecimalSeconds(pose.t));
  return stamps;
}

/// The first index of the value nearest to `t` in the sorted, non-empty `stamps`.
std::size_t Nearest(const std::vector<double>& stamps, double t) {
  const auto after = std::lower_bound(stamps.begin(), stamps.end(), t);
  if (after == stamps.begin()) return 0;
  auto nearest = after - 1;
  if (after != stamps.end() && std::abs(*after - t) < std::abs(*nearest - t)) nearest = after;
  return static_cast<std::size_t>(std::lower_bound(stamps.begin(), after, *nearest) -
                                  stamps.begin());
}

void CountDropped(const Trajectory& other, Time t, Association& association) {
  const bool outside = other.empty() || t < other.front().t || t > other.back().t;
  ++(outside ? association.dropped_outside : association.dropped_in_gap);
}

void AssociateNearest(const Trajectory& truth, const Trajectory& estimate, double max_difference_s,
                      Association& association) {
  const bool truth_is_shorter = truth.size() < estimate.size();
  const Trajectory& shorter = truth_is_shorter ? truth : estimate;
  const Trajectory& longer = truth_is_shorter ? estimate : truth;
  const std::vector<double> short_stamps = Stamps(shorter);
  const std::vector<double> long_stamps = Stamps(longer);
  for (std::size_t i = 0; i < shorter.size(); ++i) {
    const std::size_t j = longer.empty() ? 0 : Nearest(long_stamps, short_stamps[i]);
    if (longer.empty() || std::abs(long_stamps[j] - short_stamps[i]) > max_difference_s) {
      CountDropped(longer, shorter[i].t, association);
      continue;
    }
    const StampedPose& in_truth = truth_is_shorter ? shorter[i] : longer[j];
    const StampedPose& in_estimate = truth_is_shorter ? longer[j] : shorter[i];
    association.pairs.push_back({in_estimate.t, in_truth.T_WI, in_estimate.T_WI});
  }
}

void AssociateInterpolated(const Trajectory& truth, const Trajectory& estimate,
                           Association& association) {
  for (const StampedPose& pose : estimate) {
    const std::optional<Pose> there = Interpolate(truth, pose.t);
    if (there) {
      association.pairs.push_back({pose.t, *there, pose.T_WI});
    } else {
      CountDropped(truth, pose.t, association);
    }
  }
}

}  // namespace

Association Associate(const Trajectory& truth, const Trajectory& estimate,
                      const AssociationOptions& options) {
  Association association;
  association.truth_poses = truth.size();
  association.estimate_poses = estimate.size();
  if (options.mode == AssociationMode::kInterpolate) {
    AssociateInterpolated(truth, estimate, association);
  } else {
    AssociateNearest(truth, estimate, options.max_difference_s, association);
  }
  return association;
}

}  // namespace drydock::score
