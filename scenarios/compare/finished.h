// Cases that are done, kept so that a comparison that was stopped goes on where it was.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "estimator/interface/stage_timings.h"
#include "scenarios/scoring/scorecard.h"

namespace drydock::compare {

/// One estimator on one dive.
struct Finished {
  score::Scorecard scorecard;  ///< Read back: run, lengths and metrics alone.
  double estimator_s = 0.0;    ///< CPU time of the estimator's thread.
  std::size_t stereo_frames = 0;
  EstimatorTimings stages;
};

/// A folder of small JSON files, each named by a hash of everything that its figures depend on.
class FinishedCases {
 public:
  explicit FinishedCases(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Nothing if there is none, or none that can be read.
  std::optional<Finished> Find(const std::string& hash) const;
  void Keep(const std::string& hash, const Finished& finished) const;

 private:
  std::filesystem::path FileOf(const std::string& hash) const { return folder_ / (hash + ".json"); }

  std::filesystem::path folder_;
};

}  // namespace drydock::compare
