// A tree of visual words.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "estimator/svin2/frontend/descriptor.h"
#include "estimator/svin2/vocabulary/bag_of_words.h"
#include "estimator/svin2/vocabulary/vocabulary_tree.h"

namespace drydock::svin2 {

/// A hierarchical vocabulary of binary words (Galvez-Lopez and Tardos 2012; Nister and Stewenius
/// 2006): a descriptor goes down the tree to the children that differ in the fewest bits. The leaf
/// that it comes to is its word. Not only the best path is gone, but the best `kPaths` (Schindler,
/// Brown and Szeliski 2007): one wrong turn at the top would make another word of the same point.
class Vocabulary {
 public:
  static constexpr int kPaths = 5;

  /// Throws InputError for a tree that is none, saying why.
  explicit Vocabulary(VocabularyTree tree);

  /// Reads a file (vocabulary_file.h). InputError if it cannot be used.
  static Vocabulary Load(const std::filesystem::path& path);
  /// The vocabulary that comes with Drydock: estimator/svin2/vocabulary/brisk.vocabulary in
  /// DataDirectory().
  static std::filesystem::path DefaultPath();
  /// Writes a file that appears complete or not at all.
  void Save(const std::filesystem::path& path) const;

  const VocabularyTree& tree() const { return tree_; }
  int levels() const { return tree_.levels; }
  std::size_t words() const { return tree_.weights.size(); }

  /// The words of an image's descriptors, by tf-idf, and which descriptors lie below which node of
  /// `index_level` steps from the root (a leaf that is nearer to the root stands for itself). Words
  /// that every training image has say nothing and are left out.
  BagOfWords Transform(const std::vector<Descriptor>& descriptors, int index_level) const;

  /// The word of a descriptor; ties go to the leaf that comes first.
  WordId WordOf(const Descriptor& descriptor) const;

 private:
  struct Node {
    NodeId parent = 0, first_child = 0;
    int level = 0;    // Steps from the root.
    WordId word = 0;  // Counts for leaves.
  };
  NodeId LeafOf(const Descriptor& descriptor) const;

  VocabularyTree tree_;
  std::vector<Node> nodes_;
};

}  // namespace drydock::svin2
