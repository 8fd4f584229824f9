// The tree of a vocabulary as it is trained and kept.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "estimator/svin2/frontend/descriptor.h"

namespace drydock::svin2 {

inline constexpr std::size_t kMaxVocabularyNodes = 1'000'000;

/// Nodes are numbered breadth first, the root is 0: the children of a node follow one another,
/// after those of the nodes before it.
struct VocabularyTree {
  int branching = 0;                   ///< Most children of a node, 2 to 255.
  int levels = 0;                      ///< Most steps from the root to a leaf, 1 to 10.
  std::vector<std::uint8_t> children;  ///< Of each node, how many.
  std::vector<Descriptor> centres;     ///< Of each node but the root.
  std::vector<float> weights;          ///< Of each leaf, in the nodes' order: idf, not negative.

  bool operator==(const VocabularyTree&) const = default;
};

/// The most steps from the root to a leaf; InputError if the nodes do not hang together.
int TreeDepth(const std::vector<std::uint8_t>& children);

/// InputError, saying why, for a tree that is none.
void RequireTree(const VocabularyTree& tree);

}  // namespace drydock::svin2
