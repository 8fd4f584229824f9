#include "estimator/svin2/vocabulary/vocabulary.h"

#include <cstdint>
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
  NodeId next_child = 1;
  WordId next_word = 0;
  for (const std::uint8_t count : tree_.children) {
    first_child_.push_back(next_child);
    next_child += count;
    words_.push_back(next_word);
    if (count == 0) ++next_word;
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

Vocabulary::Place Vocabulary::Descend(const Descriptor& descriptor, int index_level) const {
  NodeId node = 0, at_level = 0;
  for (int level = 1; tree_.children[node] > 0; ++level) {
    const NodeId first = first_child_[node];
    NodeId best = first;
    int best_distance = HammingDistance(descriptor, tree_.centres[first - 1]);
    for (NodeId child = first + 1; child < first + tree_.children[node]; ++child) {
      const int distance = HammingDistance(descriptor, tree_.centres[child - 1]);
      if (distance >= best_distance) continue;
      best = child;
      best_distance = distance;
    }
    node = best;
    if (level <= index_level) at_level = node;
  }
  return {words_[node], at_level};
}

WordId Vocabulary::WordOf(const Descriptor& descriptor) const {
  return Descend(descriptor, 0).word;
}

BagOfWords Vocabulary::Transform(const std::vector<Descriptor>& descriptors,
                                 int index_level) const {
  std::map<WordId, double> weights;
  std::map<NodeId, std::vector<std::uint32_t>> nodes;
  for (std::size_t i = 0; i < descriptors.size(); ++i) {
    const Place place = Descend(descriptors[i], index_level);
    nodes[place.node].push_back(static_cast<std::uint32_t>(i));
    const float idf = tree_.weights[place.word];
    if (idf > 0.0F) weights[place.word] += idf;
  }
  BagOfWords bag;
  bag.words = Normalised(weights);
  for (auto& [node, members] : nodes) bag.index.push_back({node, std::move(members)});
  return bag;
}

}  // namespace drydock::svin2
