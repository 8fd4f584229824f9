#include "estimator/svin2/vocabulary/train_vocabulary.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <set>
#include <utility>

#include "estimator/svin2/vocabulary/k_medians.h"
#include "estimator/svin2/vocabulary/vocabulary.h"
#include "sensors_models/base/check.h"
#include "sensors_models/base/random_stream.h"

namespace drydock::svin2 {
namespace {

void RequireTraining(const VocabularyTraining& training,
                     const std::vector<Descriptor>& descriptors) {
  const auto& [branching, levels, iterations, min_members, seed] = training;
  RequireInput(branching >= 2 && branching <= 255, "branching is {}; it must lie in [2, 255]",
               branching);
  RequireInput(levels >= 1 && levels <= 10, "levels is {}; it must lie in [1, 10]", levels);
  RequireInput(iterations >= 1 && min_members >= 2,
               "iterations is {} and min_members {}; they must be at least 1 and 2", iterations,
               min_members);
  RequireInput(std::ranges::adjacent_find(descriptors, std::not_equal_to{}) != descriptors.end(),
               "{} descriptors, and no two that differ, make no vocabulary", descriptors.size());
}

/// Grows the tree level by level; the weights are left at zero.
class Grower {
 public:
  Grower(const std::vector<Descriptor>& descriptors, const VocabularyTraining& training)
      : descriptors_(descriptors),
        training_(training),
        random_(training.seed, "vocabulary/k_medians") {}

  VocabularyTree Grow() {
    tree_.branching = training_.branching;
    tree_.levels = training_.levels;
    Members all(descriptors_.size());
    std::iota(all.begin(), all.end(), 0U);
    std::vector<Members> level{std::move(all)};
    for (int depth = 0; !level.empty(); ++depth) level = Divide(level, depth);
    return std::move(tree_);
  }

 private:
  using Members = std::vector<std::uint32_t>;

  /// The members of the next level's nodes.
  std::vector<Members> Divide(const std::vector<Members>& level, int depth) {
    std::vector<Members> next;
    for (const Members& members : level) {
      std::vector<DescriptorCluster> children;
      if (depth < training_.levels && std::ssize(members) >= training_.min_members) {
        children =
            KMedians(descriptors_, members, training_.branching, training_.iterations, random_);
      }
      // Of one child there would be no end.
      if (children.size() < 2) children.clear();
      tree_.children.push_back(static_cast<std::uint8_t>(children.size()));
      if (children.empty()) tree_.weights.push_back(0.0F);
      for (DescriptorCluster& child : children) {
        tree_.centres.push_back(child.centre);
        next.push_back(std::move(child.members));
      }
    }
    return next;
  }

  const std::vector<Descriptor>& descriptors_;
  VocabularyTraining training_;
  RandomStream random_;
  VocabularyTree tree_;
};

/// ln(images / images with the word), of each word.
std::vector<float> Weights(const VocabularyTree& tree,
                           const std::vector<std::vector<Descriptor>>& images) {
  const Vocabulary vocabulary(tree);
  std::vector<int> with(vocabulary.words(), 0);
  for (const std::vector<Descriptor>& image : images) {
    std::set<WordId> words;
    for (const Descriptor& descriptor : image) words.insert(vocabulary.WordOf(descriptor));
    for (const WordId word : words) ++with[word];
  }
  std::vector<float> weights;
  weights.reserve(with.size());
  for (const int count : with) {
    // A word that lost its members to a better path is as rare as one that was seen once.
    weights.push_back(
        static_cast<float>(std::log(static_cast<double>(images.size()) / std::max(count, 1))));
  }
  return weights;
}

}  // namespace

VocabularyTree TrainVocabulary(const std::vector<std::vector<Descriptor>>& images,
                               const VocabularyTraining& training) {
  std::vector<Descriptor> descriptors;
  for (const std::vector<Descriptor>& image : images) {
    descriptors.insert(descriptors.end(), image.begin(), image.end());
  }
  RequireTraining(training, descriptors);
  VocabularyTree tree = Grower(descriptors, training).Grow();
  tree.weights = Weights(tree, images);
  return tree;
}

}  // namespace drydock::svin2
