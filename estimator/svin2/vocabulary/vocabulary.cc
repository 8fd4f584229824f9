#include "estimator/svin2/vocabulary/vocabulary.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

#include "estimator/svin2/vocabulary/vocabulary_file.h"
#include "sensors_models/base/files.h"
#include "sensors_models/base/resources.h"

namespace drydock::svin2 {
namespace {

BowVector Normalised(const std::map<WordId, double>& weights) {
  double sum = 0.0;
  for (const auto& [word, weight] : weights) sum += weight;
  BowVector words;
  words.reserve(weights.size());
  for (const auto& [word, weight] : weights) {
    words.push_back({word, static_cast<float>(weight / sum)});
  }
  return words;
}

}  // namespace

Vocabulary::Vocabulary(VocabularyTree tree) : tree_(std::move(tree)) {
  RequireTree(tree_);
  nodes_.resize(tree_.children.size());
  NodeId next_child = 1;
  WordId next_word = 0;
  for (NodeId node = 0; node < nodes_.size(); ++node) {
    nodes_[node].first_child = next_child;
    for (int i = 0; i < tree_.children[node]; ++i) {
      nodes_[next_child++] = {.parent = node, .level = nodes_[node].level + 1};
    }
    nodes_[node].word = next_word;
    if (tree_.children[node] == 0) ++next_word;
  }
}

Vocabulary Vocabulary::Load(const std::filesystem::path& path) {
  const std::string content = ReadFile(path, kMaxVocabularyFileBytes);
  return Vocabulary(ParseVocabulary(content, path.string()));
}

std::filesystem::path Vocabulary::DefaultPath() {
  return DataDirectory() / "estimator" / "svin2" / "vocabulary" / "brisk.vocabulary";
}

void Vocabulary::Save(const std::filesystem::path& path) const {
  WriteFileAtomically(path, FormatVocabulary(tree_));
}

NodeId Vocabulary::LeafOf(const Descriptor& descriptor) const {
  using Found = std::pair<int, NodeId>;  // Bits that differ, and where: ties go to the first.
  Found best{std::numeric_limits<int>::max(), 0};
  std::vector<Found> beam{{0, 0}}, below;
  while (!beam.empty()) {
    below.clear();
    for (const auto& [unused, node] : beam) {
      const NodeId first = nodes_[node].first_child;
      for (NodeId child = first; child < first + tree_.children[node]; ++child) {
        const Found found{HammingDistance(descriptor, tree_.centres[child - 1]), child};
        if (tree_.children[child] == 0) {
          best = std::min(best, found);
        } else {
          below.push_back(found);
        }
      }
    }
    if (std::ssize(below) > kPaths) {
      std::ranges::nth_element(below, below.begin() + kPaths);
      below.resize(kPaths);
    }
    beam.swap(below);
  }
  return best.second;
}

WordId Vocabulary::WordOf(const Descriptor& descriptor) const {
  return nodes_[LeafOf(descriptor)].word;
}

BagOfWords Vocabulary::Transform(const std::vector<Descriptor>& descriptors,
                                 int index_level) const {
  std::map<WordId, double> weights;
  std::map<NodeId, std::vector<std::uint32_t>> members;
  for (std::size_t i = 0; i < descriptors.size(); ++i) {
    NodeId node = LeafOf(descriptors[i]);
    const WordId word = nodes_[node].word;
    if (tree_.weights[word] > 0.0F) weights[word] += tree_.weights[word];
    while (nodes_[node].level > index_level) node = nodes_[node].parent;
    members[node].push_back(static_cast<std::uint32_t>(i));
  }
  BagOfWords bag;
  bag.words = Normalised(weights);
  for (auto& [node, below] : members) bag.index.push_back({node, std::move(below)});
  return bag;
}

}  // namespace drydock::svin2
