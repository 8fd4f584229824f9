// What an image shows, as words of a visual vocabulary.
#pragma once

#include <cstdint>
#include <vector>

namespace drydock::svin2 {

/// A leaf of the vocabulary's tree, counted from 0.
using WordId = std::uint32_t;
/// Any node of the tree; the root is 0.
using NodeId = std::uint32_t;

struct WeightedWord {
  WordId word = 0;
  float weight = 0.0F;  ///< tf-idf, above 0.

  bool operator==(const WeightedWord&) const = default;
};

/// Sorted by word; the weights add up to 1. Empty where nothing was to be seen.
using BowVector = std::vector<WeightedWord>;

/// The descriptors that lie below one node.
struct NodeMembers {
  NodeId node = 0;
  std::vector<std::uint32_t> descriptors;  ///< Their places in what was transformed, rising.

  bool operator==(const NodeMembers&) const = default;
};

/// Sorted by node. Two images' descriptors need only be compared where they share a node.
using DirectIndex = std::vector<NodeMembers>;

struct BagOfWords {
  BowVector words;
  DirectIndex index;
};

/// How alike two images are, from 0 (no word in common) to 1 (the same): 1 - |a - b|_1 / 2
/// (Nister and Stewenius 2006), which for weights that add up to 1 is the sum over the common words
/// of the smaller weight.
double Score(const BowVector& a, const BowVector& b);

}  // namespace drydock::svin2
