#include "scenarios/results/start_watch.h"

namespace drydock {
namespace {

constexpr Duration kProbation{5 * kNanosecondsPerSecond};

}  // namespace

void StartWatch::Look(Time t, const std::optional<NavEstimate>& estimate) {
  const bool running = estimate && estimate->status != TrackingStatus::kInitialising;
  const bool another_map = running && started_ && estimate->map_id != map_id_;
  if (started_ && (!running || another_map)) {
    if (t - *started_ <= kProbation) ++false_starts_;
    started_.reset();
  }
  if (running && !started_) {
    ever_started_ = true;
    started_ = t;
    map_id_ = estimate->map_id;
  }
}

std::optional<int> StartWatch::FalseStarts() const {
  return ever_started_ ? std::optional(false_starts_) : std::nullopt;
}

}  // namespace drydock
