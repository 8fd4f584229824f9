#include "estimator/svin2/vocabulary/bag_of_words.h"

#include <algorithm>

namespace drydock::svin2 {

double Score(const BowVector& a, const BowVector& b) {
  double score = 0.0;
  auto at = b.begin();
  for (const WeightedWord& word : a) {
    while (at != b.end() && at->word < word.word) ++at;
    if (at == b.end()) break;
    if (at->word == word.word) score += std::min(word.weight, at->weight);
  }
  return score;
}

}  // namespace drydock::svin2
