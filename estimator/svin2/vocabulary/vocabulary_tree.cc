#include "estimator/svin2/vocabulary/vocabulary_tree.h"

#include <algorithm>
#include <cmath>

#include "sensors_models/base/check.h"

namespace drydock::svin2 {

int TreeDepth(const std::vector<std::uint8_t>& children) {
  int depth = -1;
  std::size_t begin = 0, end = 1;  // Of a level's nodes.
  while (begin < end) {
    RequireInput(end <= children.size(), "the tree has {} nodes, but children for more",
                 children.size());
    std::size_t next = 0;
    for (std::size_t node = begin; node < end; ++node) next += children[node];
    begin = end;
    end += next;
    ++depth;
  }
  RequireInput(end == children.size(), "{} of {} nodes hang together", end, children.size());
  return depth;
}

void RequireTree(const VocabularyTree& tree) {
  const auto& [branching, levels, children, centres, weights] = tree;
  RequireInput(branching >= 2 && branching <= 255,
               "the branching factor is {}; it must lie in [2, 255]", branching);
  RequireInput(levels >= 1 && levels <= 10, "the number of levels is {}; it must lie in [1, 10]",
               levels);
  RequireInput(children.size() >= 2 && children.size() <= kMaxVocabularyNodes,
               "the tree has {} nodes; it must have 2 to {}", children.size(), kMaxVocabularyNodes);
  const int most = std::ranges::max(children);
  RequireInput(most <= branching, "a node has {} children; {} are allowed", most, branching);
  const int depth = TreeDepth(children);
  RequireInput(depth <= levels, "the tree is {} levels deep; {} are allowed", depth, levels);
  RequireInput(centres.size() + 1 == children.size(), "{} centres do not fit {} nodes",
               centres.size(), children.size());
  const auto words = static_cast<std::size_t>(std::ranges::count(children, 0));
  RequireInput(weights.size() == words, "{} weights do not fit {} words", weights.size(), words);
  for (const float weight : weights) {
    RequireInput(std::isfinite(weight) && weight >= 0.0F,
                 "a word's weight is {}; it must be finite and not negative", weight);
  }
}

}  // namespace drydock::svin2
