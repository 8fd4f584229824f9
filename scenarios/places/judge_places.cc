#include "scenarios/places/judge_places.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

namespace drydock {
namespace {

enum class Relation { kSame, kOther, kBetween };

Relation RelationOf(const Pose& a, const Pose& b, const PlaceJudging& judging) {
  const double distance = (a.p() - b.p()).norm();
  const double angle = a.q().angularDistance(b.q());
  if (distance <= judging.same_distance_m && angle <= judging.same_angle_rad) {
    return Relation::kSame;
  }
  return distance > judging.other_distance_m || angle > judging.other_angle_rad
             ? Relation::kOther
             : Relation::kBetween;
}

void Count(Relation relation, CandidateCount& count) {
  if (relation == Relation::kSame) ++count.same;
  if (relation == Relation::kOther) ++count.other;
  if (relation == Relation::kBetween) ++count.between;
}

/// One dive from its first keyframe to the last.
class Judge {
 public:
  Judge(const svin2::Vocabulary& vocabulary, const std::vector<KeyframeView>& views,
        const PlaceJudging& judging)
      : vocabulary_(vocabulary),
        views_(views),
        judging_(judging),
        database_(vocabulary.words()),
        consistency_(judging.consistency) {}

  PlaceJudgement Run() {
    for (std::size_t i = 0; i < views_.size(); ++i) See(i);
    std::ranges::sort(result_.same);
    std::ranges::sort(result_.other);
    std::ranges::sort(result_.neighbours);
    return std::move(result_);
  }

 private:
  void See(std::size_t i) {
    svin2::BagOfWords bag = vocabulary_.Transform(views_[i].descriptors, 2);
    std::size_t first_excluded = 0;
    while ((views_[i].t - views_[first_excluded].t).Seconds() >= judging_.min_gap_s) {
      ++first_excluded;
    }
    ScorePairs(i, bag.words, first_excluded);
    Recall(i, bag.words, first_excluded);
    database_.Add(static_cast<svin2::KeyframeIndex>(i), bag);
    words_.push_back(std::move(bag.words));
  }

  void ScorePairs(std::size_t i, const svin2::BowVector& words, std::size_t end) {
    if (i > 0) result_.neighbours.push_back(svin2::Score(words, words_[i - 1]));
    bool is_revisit = false;
    for (std::size_t j = 0; j < end; ++j) {
      const Relation relation = RelationOf(views_[i].T_WI, views_[j].T_WI, judging_);
      const double score = svin2::Score(words, words_[j]);
      if (relation == Relation::kSame) result_.same.push_back(score);
      if (relation == Relation::kOther) result_.other.push_back(score);
      is_revisit |= relation == Relation::kSame;
    }
    result_.revisits += is_revisit ? 1 : 0;
  }

  void Recall(std::size_t i, const svin2::BowVector& words, std::size_t end) {
    std::vector<svin2::KeyframeIndex> neighbours;
    for (int k = 1; k <= judging_.neighbours && std::cmp_less_equal(k, i); ++k) {
      neighbours.push_back(static_cast<svin2::KeyframeIndex>(i) - k);
    }
    const auto candidates = database_.LoopCandidates(
        words, neighbours, static_cast<svin2::KeyframeIndex>(end), judging_.rule);
    const auto relation = [&](const svin2::PlaceMatch& match) {
      return RelationOf(views_[i].T_WI, views_[static_cast<std::size_t>(match.keyframe)].T_WI,
                        judging_);
    };
    if (!candidates.empty()) Count(relation(candidates.front()), result_.best);
    const auto consistent = consistency_.Update(candidates);
    if (!consistent.empty()) Count(relation(consistent.front()), result_.consistent);
  }

  const svin2::Vocabulary& vocabulary_;
  const std::vector<KeyframeView>& views_;
  const PlaceJudging& judging_;
  svin2::PlaceDatabase database_;
  svin2::CandidateConsistency consistency_;
  std::vector<svin2::BowVector> words_;  // Of each keyframe.
  PlaceJudgement result_;
};

}  // namespace

PlaceJudgement JudgePlaces(const svin2::Vocabulary& vocabulary,
                           const std::vector<KeyframeView>& views, const PlaceJudging& judging) {
  return Judge(vocabulary, views, judging).Run();
}

}  // namespace drydock
