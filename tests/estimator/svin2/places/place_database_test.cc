#include "estimator/svin2/places/place_database.h"

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/estimator/svin2/vocabulary/synthetic_descriptors.h"

namespace drydock::svin2 {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

BagOfWords Bag(BowVector words) { return {std::move(words), {}}; }

// Four keyframes; the first and the third are alike.
PlaceDatabase FourPlaces() {
  PlaceDatabase database(10);
  database.Add(3, Bag({{0, 0.5F}, {1, 0.5F}}));
  database.Add(4, Bag({{2, 0.5F}, {3, 0.5F}}));
  database.Add(5, Bag({{0, 0.5F}, {1, 0.25F}, {2, 0.25F}}));
  database.Add(7, Bag({{4, 1.0F}}));
  return database;
}

const BowVector kQuery = {{0, 0.5F}, {1, 0.5F}};

TEST(PlaceDatabase, GivesTheBestFirst) {
  EXPECT_THAT(FourPlaces().Query(kQuery, 100, 0.0),
              ElementsAre(PlaceMatch{3, 1.0}, PlaceMatch{5, 0.75}));
}

TEST(PlaceDatabase, ScoresAreThoseOfTheVectors) {
  const Vocabulary vocabulary = testing::SmallVocabulary();
  const auto images = testing::SyntheticImages(15, 100, 40, 3);
  PlaceDatabase database(vocabulary.words());
  std::vector<BowVector> words;
  for (std::size_t i = 0; i < images.size(); ++i) {
    BagOfWords bag = vocabulary.Transform(images[i], 1);
    words.push_back(bag.words);
    database.Add(static_cast<KeyframeIndex>(i), std::move(bag));
  }
  for (const BowVector& query : words) {
    const auto matches = database.Query(query, 100, 0.0);
    EXPECT_TRUE(std::ranges::is_sorted(matches, std::ranges::greater{}, &PlaceMatch::score));
    EXPECT_GE(matches.size(), 10U);
    for (const PlaceMatch& match : matches) {
      EXPECT_NEAR(match.score, Score(query, words[static_cast<std::size_t>(match.keyframe)]), 1e-9);
    }
  }
}

// With the vocabulary that comes with Drydock: 300 images of one world, each of which finds itself.
TEST(PlaceDatabase, FindsEachKeyframeByItself) {
  const Vocabulary vocabulary = Vocabulary::Load(Vocabulary::DefaultPath());
  const auto images = testing::SyntheticImages(300, 400, 80, 5);
  PlaceDatabase database(vocabulary.words());
  for (std::size_t i = 0; i < images.size(); ++i)
    database.Add(static_cast<KeyframeIndex>(i), vocabulary.Transform(images[i], 2));
  for (std::size_t i = 0; i < images.size(); ++i) {
    const auto found = database.Query(vocabulary.Transform(images[i], 2).words, 300, 0.0);
    ASSERT_GE(found.size(), 2U);
    EXPECT_EQ(found[0].keyframe, static_cast<KeyframeIndex>(i));
    EXPECT_NEAR(found[0].score, 1.0, 1e-6);
    EXPECT_LT(found[1].score, 0.9);
  }
}

TEST(PlaceDatabase, LeavesOutTheWindowAndWhatIsUnlike) {
  const PlaceDatabase database = FourPlaces();
  EXPECT_THAT(database.Query(kQuery, 5, 0.0), ElementsAre(PlaceMatch{3, 1.0}));
  EXPECT_THAT(database.Query(kQuery, 3, 0.0), IsEmpty());
  EXPECT_THAT(database.Query(kQuery, 100, 0.75),
              ElementsAre(PlaceMatch{3, 1.0}, PlaceMatch{5, 0.75}));
  EXPECT_THAT(database.Query(kQuery, 100, 0.76), ElementsAre(PlaceMatch{3, 1.0}));
  EXPECT_THAT(database.Query({{9, 1.0F}}, 100, 0.0), IsEmpty());
  EXPECT_THAT(database.Query({}, 100, 0.0), IsEmpty());
  EXPECT_THAT(PlaceDatabase(10).Query(kQuery, 100, 0.0), IsEmpty());
}

TEST(PlaceDatabase, EquallyGoodOnesGoByAge) {
  PlaceDatabase database(10);
  for (KeyframeIndex i = 0; i < 40; ++i) database.Add(i, Bag({{0, 1.0F}}));
  const auto matches = database.Query({{0, 1.0F}}, 100, 0.0);
  ASSERT_EQ(matches.size(), 40U);
  EXPECT_TRUE(std::ranges::is_sorted(matches, {}, &PlaceMatch::keyframe));
}

// Keyframes 4 and 7, the neighbours, score 0.25 and 0.5.
TEST(PlaceDatabase, CandidatesMustCompareWithTheNeighbours) {
  const PlaceDatabase database = FourPlaces();
  const BowVector query = {{0, 0.125F}, {1, 0.125F}, {2, 0.25F}, {4, 0.5F}};
  const auto candidates = [&](const std::vector<KeyframeIndex>& neighbours, double share,
                              std::size_t most = 10) {
    LoopCandidateRule rule;
    rule.neighbour_share = share;
    rule.max_candidates = most;
    return database.LoopCandidates(query, neighbours, 7, rule);
  };
  EXPECT_THAT(candidates({4, 7}, 1.0),
              ElementsAre(PlaceMatch{5, 0.5}, PlaceMatch{3, 0.25}, PlaceMatch{4, 0.25}));
  EXPECT_THAT(candidates({7}, 1.0), ElementsAre(PlaceMatch{5, 0.5}));
  EXPECT_THAT(candidates({7}, 0.5, 2), ElementsAre(PlaceMatch{5, 0.5}, PlaceMatch{3, 0.25}));
  EXPECT_THAT(candidates({7}, 1.1), IsEmpty());
  EXPECT_THAT(candidates({}, 0.5), IsEmpty());
}

TEST(PlaceDatabase, TellsNothingWhereNeighboursAreUnlike) {
  const PlaceDatabase database = FourPlaces();
  EXPECT_THAT(database.LoopCandidates(kQuery, {7}, 7, {}), IsEmpty());
  LoopCandidateRule rule;
  rule.min_score = 0.0;
  EXPECT_EQ(database.LoopCandidates(kQuery, {7}, 7, rule).size(), 2U);
  // The bound holds for candidates too.
  rule.neighbour_share = 0.1;
  rule.min_score = 0.8;
  EXPECT_THAT(database.LoopCandidates(kQuery, {3}, 7, rule), ElementsAre(PlaceMatch{3, 1.0}));
}

TEST(PlaceDatabase, KeepsTheDirectIndices) {
  PlaceDatabase database(10);
  const DirectIndex index = {{2, {0, 3}}, {5, {1}}};
  database.Add(11, {{{0, 1.0F}}, index});
  database.Add(12, {});
  EXPECT_EQ(database.size(), 2U);
  EXPECT_EQ(database.DirectIndexOf(11), index);
  EXPECT_TRUE(database.DirectIndexOf(12).empty());
}

TEST(PlaceDatabase, HoldsToItsContract) {
  PlaceDatabase database = FourPlaces();
  EXPECT_THROW(database.Add(7, Bag({})), std::logic_error);
  EXPECT_THROW(database.Add(8, Bag({{10, 1.0F}})), std::logic_error);
  EXPECT_THROW(database.Query({{10, 1.0F}}, 100, 0.0), std::logic_error);
  EXPECT_THROW(database.DirectIndexOf(6), std::logic_error);
  EXPECT_THROW(database.LoopCandidates(kQuery, {6}, 100, {}), std::logic_error);
}

TEST(PlaceDatabase, GrowsLinearly) {
  const Vocabulary vocabulary = testing::SmallVocabulary();
  const auto images = testing::SyntheticImages(50, 100, 40, 3);
  PlaceDatabase database(vocabulary.words());
  const std::size_t empty = database.Bytes();
  std::vector<std::size_t> bytes;
  for (KeyframeIndex i = 0; i < 2000; ++i) {
    database.Add(i, vocabulary.Transform(images[static_cast<std::size_t>(i) % 50], 2));
    if (i == 999 || i == 1999) bytes.push_back(database.Bytes() - empty);
  }
  EXPECT_LT(static_cast<double>(bytes[1]), 2.5 * static_cast<double>(bytes[0]));
  // At most 40 words and 40 descriptors a keyframe, and as many nodes.
  EXPECT_LT(bytes[1] / 2000, 40U * (2 * 8 + 4 + 2 * sizeof(NodeMembers)));
}

}  // namespace
}  // namespace drydock::svin2
