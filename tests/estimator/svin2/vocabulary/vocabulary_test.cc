#include "estimator/svin2/vocabulary/vocabulary.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sensors_models/base/check.h"
#include "tests/estimator/svin2/vocabulary/synthetic_descriptors.h"
#include "tests/support/input_error.h"

namespace drydock::svin2 {
namespace {

using drydock::testing::InputErrorOf;

using testing::Disturbed;
using testing::SmallVocabulary;
using testing::SyntheticImages;

double SumOf(const BowVector& words) {
  double sum = 0.0;
  for (const WeightedWord& word : words) sum += word.weight;
  return sum;
}

// Two levels: 0 -> {1: 1111, 2: 0}, 2 -> {3: 0, 4: 1}.
VocabularyTree HandMade() {
  return {.branching = 2,
          .levels = 2,
          .children = {2, 0, 2, 0, 0},
          .centres = {{0b1111}, {0}, {0}, {1}},
          .weights = {1.0F, 2.0F, 0.0F}};
}

TEST(Vocabulary, GoesDownByTheFewestBits) {
  const Vocabulary vocabulary(HandMade());
  EXPECT_EQ(vocabulary.WordOf({0b0111}), 0U);
  EXPECT_EQ(vocabulary.WordOf({0b0010}), 1U);
  EXPECT_EQ(vocabulary.WordOf({0b0001}), 2U);
  // Not the best at the first turn, but in the end.
  EXPECT_EQ(vocabulary.WordOf({0b0011}), 2U);
  // As near to two: the first.
  EXPECT_EQ(vocabulary.WordOf({0b0110}), 0U);
}

TEST(Vocabulary, WeighsByFrequencyInTheImageTimesRarity) {
  const Vocabulary vocabulary(HandMade());
  const BagOfWords bag = vocabulary.Transform({{0b0010}, {0b1111}, {0b0111}, {1}}, 2);
  // Word 0 twice with weight 1, word 1 once with weight 2; word 2 weighs nothing.
  EXPECT_THAT(bag.words, ::testing::ElementsAre(WeightedWord{0, 0.5F}, WeightedWord{1, 0.5F}));
  EXPECT_THAT(bag.index, ::testing::ElementsAre(NodeMembers{1, {1, 2}}, NodeMembers{3, {0}},
                                                NodeMembers{4, {3}}));
}

TEST(Vocabulary, IndexesAtTheLevelAskedFor) {
  const Vocabulary vocabulary(HandMade());
  const std::vector<Descriptor> descriptors = {{0b0010}, {0b1111}, {1}};
  EXPECT_THAT(vocabulary.Transform(descriptors, 0).index,
              ::testing::ElementsAre(NodeMembers{0, {0, 1, 2}}));
  EXPECT_THAT(vocabulary.Transform(descriptors, 1).index,
              ::testing::ElementsAre(NodeMembers{1, {1}}, NodeMembers{2, {0, 2}}));
  EXPECT_EQ(vocabulary.Transform(descriptors, 9).index, vocabulary.Transform(descriptors, 2).index);
}

TEST(Vocabulary, TransformIsSortedNormalisedAndComplete) {
  const Vocabulary vocabulary = SmallVocabulary();
  for (const auto& image : SyntheticImages(10, 100, 40, 9)) {
    const BagOfWords bag = vocabulary.Transform(image, 2);
    EXPECT_TRUE(std::ranges::is_sorted(bag.words, {}, &WeightedWord::word));
    EXPECT_NEAR(SumOf(bag.words), 1.0, 1e-6);
    EXPECT_TRUE(std::ranges::is_sorted(bag.index, {}, &NodeMembers::node));
    std::set<std::uint32_t> members;
    for (const NodeMembers& node : bag.index) {
      members.insert(node.descriptors.begin(), node.descriptors.end());
    }
    EXPECT_EQ(members.size(), image.size());
    EXPECT_NEAR(Score(bag.words, bag.words), 1.0, 1e-6);
  }
}

TEST(Vocabulary, OrderOfDescriptorsChangesNoWord) {
  const Vocabulary vocabulary = SmallVocabulary();
  std::vector<Descriptor> image = SyntheticImages(1, 100, 40, 9)[0];
  const BowVector words = vocabulary.Transform(image, 2).words;
  std::ranges::reverse(image);
  const BowVector reversed = vocabulary.Transform(image, 2).words;
  ASSERT_EQ(reversed.size(), words.size());
  EXPECT_NEAR(Score(reversed, words), 1.0, 1e-6);
}

TEST(Vocabulary, NothingSeenIsAnEmptyBag) {
  const BagOfWords bag = SmallVocabulary().Transform({}, 2);
  EXPECT_TRUE(bag.words.empty());
  EXPECT_TRUE(bag.index.empty());
  // Only what says nothing.
  EXPECT_TRUE(Vocabulary(HandMade()).Transform({{1}}, 2).words.empty());
}

// The same things seen anew are more alike than other things.
TEST(Vocabulary, TellsPlacesApart) {
  RandomStream random(10, "test");
  const Vocabulary vocabulary = SmallVocabulary();
  const auto places = SyntheticImages(12, 100, 40, 5);
  for (std::size_t i = 0; i < places.size(); ++i) {
    std::vector<Descriptor> again;
    for (const Descriptor& d : places[i]) again.push_back(Disturbed(d, 20, random));
    const BowVector words = vocabulary.Transform(again, 2).words;
    const double same = Score(words, vocabulary.Transform(places[i], 2).words);
    for (std::size_t j = 0; j < places.size(); ++j) {
      if (j == i) continue;
      EXPECT_GT(same, 1.3 * Score(words, vocabulary.Transform(places[j], 2).words));
    }
  }
}

void ExpectRefused(const VocabularyTree& tree, const std::string& why) {
  const std::string error = InputErrorOf([&] { const Vocabulary vocabulary(tree); });
  EXPECT_THAT(error, ::testing::HasSubstr(why));
}

TEST(Vocabulary, RefusesWhatIsNoTree) {
  EXPECT_NO_THROW(Vocabulary{HandMade()});
  const auto change = [](auto edit) {
    VocabularyTree tree = HandMade();
    edit(tree);
    return tree;
  };
  ExpectRefused({}, "branching factor is 0");
  ExpectRefused(change([](auto& t) { t.branching = 256; }), "branching factor is 256");
  ExpectRefused(change([](auto& t) { t.levels = 11; }), "levels is 11");
  ExpectRefused(change([](auto& t) { t.levels = 1; }), "2 levels deep; 1 are allowed");
  ExpectRefused(change([](auto& t) { t.children[0] = 3; }), "a node has 3 children");
  ExpectRefused(change([](auto& t) { t.children[0] = 1; }), "hang together");
  ExpectRefused(change([](auto& t) { t.children[1] = 2; }), "children for more");
  ExpectRefused(change([](auto& t) { t.children = {0, 1}; }), "1 of 2 nodes hang together");
  ExpectRefused(change([](auto& t) { t.children = {0}; }), "1 nodes");
  ExpectRefused(change([](auto& t) { t.centres.pop_back(); }), "3 centres do not fit 5 nodes");
  ExpectRefused(change([](auto& t) { t.weights.pop_back(); }), "2 weights do not fit 3 words");
  ExpectRefused(change([](auto& t) { t.weights[1] = -1.0F; }), "weight is -1");
  ExpectRefused(change([](auto& t) { t.weights[1] = std::nanf(""); }), "weight is nan");
}

// The file that comes with Drydock, as docs/models.md has it.
TEST(Vocabulary, ShippedOneCanBeUsed) {
  const std::filesystem::path path = Vocabulary::DefaultPath();
  EXPECT_LT(std::filesystem::file_size(path), 4'000'000U);
  const Vocabulary vocabulary = Vocabulary::Load(path);
  EXPECT_EQ(vocabulary.tree().branching, 10);
  EXPECT_EQ(vocabulary.levels(), 5);
  EXPECT_GT(vocabulary.words(), 50000U);
  RandomStream random(1, "test");
  EXPECT_NEAR(SumOf(vocabulary.Transform(testing::RandomDescriptors(100, random), 2).words), 1.0,
              1e-5);
}

}  // namespace
}  // namespace drydock::svin2
