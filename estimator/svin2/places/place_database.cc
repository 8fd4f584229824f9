#include "estimator/svin2/places/place_database.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "sensors_models/base/check.h"

namespace drydock::svin2 {

void PlaceDatabase::Add(KeyframeIndex keyframe, BagOfWords bag) {
  Check(keyframes_.empty() || keyframe > keyframes_.back(),
        "keyframe {} comes after {}: their indices must rise", keyframe,
        keyframes_.empty() ? 0 : keyframes_.back());
  const auto place = static_cast<std::uint32_t>(keyframes_.size());
  for (const WeightedWord& word : bag.words) {
    Check(word.word < postings_.size(), "word {} of a vocabulary of {}", word.word,
          postings_.size());
    postings_[word.word].push_back({place, word.weight});
  }
  keyframes_.push_back(keyframe);
  direct_.push_back(std::move(bag.index));
}

std::vector<double> PlaceDatabase::Scores(const BowVector& words) const {
  std::vector<double> scores(keyframes_.size(), 0.0);
  for (const WeightedWord& word : words) {
    Check(word.word < postings_.size(), "word {} of a vocabulary of {}", word.word,
          postings_.size());
    for (const Posting& posting : postings_[word.word]) {
      scores[posting.place] += std::min(word.weight, posting.weight);
    }
  }
  return scores;
}

std::vector<PlaceMatch> PlaceDatabase::Best(const std::vector<double>& scores,
                                            KeyframeIndex first_excluded, double min_score) const {
  std::vector<PlaceMatch> matches;
  for (std::size_t i = 0; i < scores.size() && keyframes_[i] < first_excluded; ++i) {
    if (scores[i] > 0.0 && scores[i] >= min_score) matches.push_back({keyframes_[i], scores[i]});
  }
  std::ranges::stable_sort(matches, std::ranges::greater{}, &PlaceMatch::score);
  return matches;
}

std::vector<PlaceMatch> PlaceDatabase::Query(const BowVector& words, KeyframeIndex first_excluded,
                                             double min_score) const {
  return Best(Scores(words), first_excluded, min_score);
}

std::vector<PlaceMatch> PlaceDatabase::LoopCandidates(const BowVector& words,
                                                      const std::vector<KeyframeIndex>& neighbours,
                                                      KeyframeIndex first_excluded,
                                                      const LoopCandidateRule& rule) const {
  if (neighbours.empty()) return {};
  const std::vector<double> scores = Scores(words);
  double lowest = 1.0;
  for (const KeyframeIndex neighbour : neighbours) {
    lowest = std::min(lowest, scores[PlaceOf(neighbour)]);
  }
  if (lowest < rule.min_score) return {};
  std::vector<PlaceMatch> matches =
      Best(scores, first_excluded, std::max(rule.min_score, rule.neighbour_share * lowest));
  if (matches.size() > rule.max_candidates) matches.resize(rule.max_candidates);
  return matches;
}

std::size_t PlaceDatabase::PlaceOf(KeyframeIndex keyframe) const {
  const auto found = std::ranges::lower_bound(keyframes_, keyframe);
  Check(found != keyframes_.end() && *found == keyframe, "keyframe {} is not in the database",
        keyframe);
  return static_cast<std::size_t>(found - keyframes_.begin());
}

const DirectIndex& PlaceDatabase::DirectIndexOf(KeyframeIndex keyframe) const {
  return direct_[PlaceOf(keyframe)];
}

std::size_t PlaceDatabase::Bytes() const {
  const auto held = [](const auto& vector) { return vector.capacity() * sizeof(*vector.data()); };
  std::size_t bytes = held(postings_) + held(keyframes_) + held(direct_);
  for (const auto& postings : postings_) bytes += held(postings);
  for (const DirectIndex& index : direct_) {
    bytes += held(index);
    for (const NodeMembers& node : index) bytes += held(node.descriptors);
  }
  return bytes;
}

}  // namespace drydock::svin2
