// Keyframes by what they show.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "estimator/svin2/vocabulary/bag_of_words.h"

namespace drydock::svin2 {

/// Counts the keyframes of a dive; neighbours in time differ by one.
using KeyframeIndex = std::int64_t;

struct PlaceMatch {
  KeyframeIndex keyframe = 0;
  double score = 0.0;  ///< 0 to 1, see Score().

  bool operator==(const PlaceMatch&) const = default;
};

/// Which keyframes are candidates for a loop (paper, section Loop-closing and Relocalization).
struct LoopCandidateRule {
  /// A candidate must have at least this share of the lowest score among the keyframe's neighbours:
  /// what a good score is depends on the scene, and they say it.
  double neighbour_share = 0.6;
  /// And not below this: where even a neighbour is unlike, nothing can be told by likeness.
  double min_score = 0.005;
  std::size_t max_candidates = 10;  ///< The best are kept.
};

/// An inverted index from words to the keyframes that show them, and the direct index of each
/// keyframe. Memory grows linearly: 8 bytes a word, 4 a descriptor and 32 a node of each keyframe,
/// with what vectors hold in reserve 8 kB a keyframe of 200 descriptors (loop_benchmark).
class PlaceDatabase {
 public:
  /// For a vocabulary of `words` words.
  explicit PlaceDatabase(std::size_t words) : postings_(words) {}

  /// Keyframes come with rising indices.
  void Add(KeyframeIndex keyframe, BagOfWords bag);

  /// The keyframes before `first_excluded` with at least `min_score` and a word in common, best
  /// first; of equal ones the oldest.
  std::vector<PlaceMatch> Query(const BowVector& words, KeyframeIndex first_excluded,
                                double min_score) const;

  /// The keyframes before `first_excluded`, usually the first of the window, that `rule` lets pass.
  /// `neighbours` are keyframes of the database near the one that shows `words`; none: none pass.
  std::vector<PlaceMatch> LoopCandidates(const BowVector& words,
                                         const std::vector<KeyframeIndex>& neighbours,
                                         KeyframeIndex first_excluded,
                                         const LoopCandidateRule& rule) const;

  /// Which descriptors of a keyframe lie below which node. Throws std::logic_error for a keyframe
  /// that is not there.
  const DirectIndex& DirectIndexOf(KeyframeIndex keyframe) const;

  std::size_t size() const { return keyframes_.size(); }
  /// Memory held, less what the allocator adds [bytes].
  std::size_t Bytes() const;

 private:
  struct Posting {
    std::uint32_t place;  // In keyframes_.
    float weight;
  };

  // Of each keyframe, in their order.
  std::vector<double> Scores(const BowVector& words) const;
  std::vector<PlaceMatch> Best(const std::vector<double>& scores, KeyframeIndex first_excluded,
                               double min_score) const;
  std::size_t PlaceOf(KeyframeIndex keyframe) const;

  std::vector<std::vector<Posting>> postings_;  // Of each word, the oldest keyframe first.
  std::vector<KeyframeIndex> keyframes_;
  std::vector<DirectIndex> direct_;  // Of each keyframe.
};

}  // namespace drydock::svin2
