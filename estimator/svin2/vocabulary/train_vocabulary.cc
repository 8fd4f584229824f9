#include "estimator/svin2/vocabulary/train_vocabulary.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <utility>

#include "estimator/svin2/vocabulary/k_medians.h"
#include "sensors_models/base/check.h"
#include "sensors_models/base/random_stream.h"

namespace drydock::svin2 {
namespace {

struct Samples {
  std::vector<Descriptor> descriptors;
  std::vector<std::size_t> images;  // Of each descriptor.
};

Samples Flatten(const std::vector<std::vector<Descriptor>>& images) {
  Samples samples;
  for (std::size_t i = 0; i < images.size(); ++i) {
    samples.descriptors.insert(samples.descriptors.end(), images[i].begin(), images[i].end());
    samples.images.resize(samples.descriptors.size(), i);
  }
  return samples;
}

void RequireTraining(const VocabularyTraining& training, const Samples& samples) {
  const auto& [branching, levels, iterations, min_members, seed] = training;
  RequireInput(branching >= 2 && branching <= 255, "branching is {}; it must lie in [2, 255]",
               branching);
  RequireInput(levels >= 1 && levels <= 10, "levels is {}; it must lie in [1, 10]", levels);
  RequireInput(iterations >= 1 && min_members >= 2,
               "iterations is {} and min_members {}; they must be at least 1 and 2", iterations,
               min_members);
  const auto& descriptors = samples.descriptors;
  RequireInput(std::ranges::adjacent_find(descriptors, std::not_equal_to{}) != descriptors.end(),
               "{} descriptors, and no two that differ, make no vocabulary", descriptors.size());
}

/// Grows the tree level by level.
class Grower {
 public:
  Grower(const Samples& samples, std::size_t images, const VocabularyTraining& training)
      : samples_(samples),
        images_(static_cast<double>(images)),
        training_(training),
        random_(training.seed, "vocabulary/k_medians") {}

  VocabularyTree Grow() {
    tree_.branching = training_.branching;
    tree_.levels = training_.levels;
    std::vector<std::uint32_t> all(samples_.descriptors.size());
    std::iota(all.begin(), all.end(), 0U);
    std::vector<std::vector<std::uint32_t>> level{std::move(all)};
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
        children = KMedians(samples_.descriptors, members, training_.branching,
                            training_.iterations, random_);
      }
      // Of one child there would be no end.
      if (children.size() < 2) children.clear();
      tree_.children.push_back(static_cast<std::uint8_t>(children.size()));
      if (children.empty()) tree_.weights.push_back(Weight(members));
      for (DescriptorCluster& child : children) {
        tree_.centres.push_back(child.centre);
        next.push_back(std::move(child.members));
      }
    }
    return next;
  }

  /// ln(images / images with one of these descriptors).
  float Weight(const Members& members) const {
    std::size_t with = 0;
    // Members rise, and so do their images.
    for (std::size_t i = 0; i < members.size(); ++i) {
      if (i == 0 || samples_.images[members[i]] != samples_.images[members[i - 1]]) ++with;
    }
    return static_cast<float>(std::log(images_ / static_cast<double>(with)));
  }

  const Samples& samples_;
  double images_;
  VocabularyTraining training_;
  RandomStream random_;
  VocabularyTree tree_;
};

}  // namespace

VocabularyTree TrainVocabulary(const std::vector<std::vector<Descriptor>>& images,
                               const VocabularyTraining& training) {
  const Samples samples = Flatten(images);
  RequireTraining(training, samples);
  return Grower(samples, images.size(), training).Grow();
}

}  // namespace drydock::svin2
