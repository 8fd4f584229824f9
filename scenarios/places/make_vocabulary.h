// Makes a vocabulary of recorded dives.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "estimator/svin2/vocabulary/train_vocabulary.h"

namespace drydock {

struct VocabularySummary {
  std::size_t images = 0;
  std::size_t descriptors = 0;
  std::size_t words = 0;
  std::size_t bytes = 0;  ///< Of the file.
};

/// Trains on the keyframes of EuRoC folders with ground truth, at least one each `max_gap` frames,
/// and writes the file.
VocabularySummary MakeVocabulary(const std::vector<std::filesystem::path>& recordings, int max_gap,
                                 const svin2::VocabularyTraining& training,
                                 const std::filesystem::path& output);

}  // namespace drydock
