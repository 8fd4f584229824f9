// Grows a vocabulary's tree from the descriptors of training images.
#pragma once

#include <cstdint>
#include <vector>

#include "estimator/svin2/frontend/descriptor.h"
#include "estimator/svin2/vocabulary/vocabulary_tree.h"

namespace drydock::svin2 {

struct VocabularyTraining {
  int branching = 10;   ///< k: children of a node.
  int levels = 5;       ///< L: steps from the root to the words.
  int iterations = 20;  ///< Most rounds of k-medians for a node.
  int min_members = 2;  ///< A node of fewer descriptors is not divided.
  std::uint64_t seed = 1;
};

/// Divides the descriptors into k clusters, each of these again and so on: k-medians, where the
/// median of bits is their majority, begun as k-means++ (Arthur and Vassilvitskii 2007). A word's
/// weight is its inverse document frequency, ln(images / images with the word).
/// `images` are the descriptors of each training image. Deterministic. InputError for options that
/// cannot be used, and where there are not two different descriptors.
VocabularyTree TrainVocabulary(const std::vector<std::vector<Descriptor>>& images,
                               const VocabularyTraining& training);

}  // namespace drydock::svin2
