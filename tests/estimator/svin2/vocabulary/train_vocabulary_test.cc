#include "estimator/svin2/vocabulary/train_vocabulary.h"

#include <cmath>
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
using testing::RandomDescriptor;
using testing::RandomDescriptors;
using testing::SyntheticImages;

VocabularyTraining Small() {
  VocabularyTraining training;
  training.branching = 5;
  training.levels = 3;
  return training;
}

TEST(TrainVocabulary, GivesEachThingWordsOfItsOwn) {
  RandomStream random(7, "test");
  const std::vector<Descriptor> things = RandomDescriptors(25, random);
  std::vector<std::vector<Descriptor>> images(30);
  for (auto& image : images) {
    for (const Descriptor& thing : things) image.push_back(Disturbed(thing, 20, random));
  }
  VocabularyTraining training = Small();
  training.branching = 10;
  training.levels = 2;
  const Vocabulary vocabulary(TrainVocabulary(images, training));
  std::vector<std::set<WordId>> words(things.size());
  std::set<WordId> all;
  std::size_t sum = 0;
  for (std::size_t i = 0; i < things.size(); ++i) {
    // Not those that it was trained on.
    for (int n = 0; n < 20; ++n) {
      words[i].insert(vocabulary.WordOf(Disturbed(things[i], 20, random)));
    }
    all.insert(words[i].begin(), words[i].end());
    sum += words[i].size();
  }
  EXPECT_EQ(all.size(), sum) << "two things share a word";
}

TEST(TrainVocabulary, IsDeterministicBySeed) {
  const auto images = SyntheticImages(10, 50, 30, 1);
  VocabularyTraining training = Small();
  const VocabularyTree tree = TrainVocabulary(images, training);
  EXPECT_EQ(TrainVocabulary(images, training), tree);
  training.seed = 2;
  EXPECT_FALSE(TrainVocabulary(images, training) == tree);
}

// The word of one image in four weighs ln 4, one that all have nothing.
TEST(TrainVocabulary, WeighsWordsByHowRareTheyAre) {
  RandomStream random(8, "test");
  const Descriptor common = RandomDescriptor(random), rare = RandomDescriptor(random);
  const std::vector<std::vector<Descriptor>> images = {
      {common}, {common, rare, rare}, {common, common}, {common}};
  const Vocabulary vocabulary(TrainVocabulary(images, Small()));
  ASSERT_EQ(vocabulary.words(), 2U);
  EXPECT_FLOAT_EQ(vocabulary.tree().weights[vocabulary.WordOf(rare)], std::log(4.0F));
  EXPECT_FLOAT_EQ(vocabulary.tree().weights[vocabulary.WordOf(common)], 0.0F);
}

TEST(TrainVocabulary, KeepsToItsBounds) {
  const auto images = SyntheticImages(10, 100, 60, 2);
  VocabularyTraining training = Small();
  for (const int levels : {1, 2, 3}) {
    training.levels = levels;
    const VocabularyTree tree = TrainVocabulary(images, training);
    EXPECT_EQ(TreeDepth(tree.children), levels);
    EXPECT_LE(tree.weights.size(), std::pow(5.0, levels));
    EXPECT_NO_THROW(RequireTree(tree));
  }
  training.min_members = 100;
  EXPECT_LT(TrainVocabulary(images, training).weights.size(), 50U);
}

void ExpectRefused(const std::vector<std::vector<Descriptor>>& images,
                   const VocabularyTraining& training, const std::string& why) {
  const std::string error = InputErrorOf([&] { TrainVocabulary(images, training); });
  EXPECT_THAT(error, ::testing::HasSubstr(why));
}

TEST(TrainVocabulary, RefusesWhatItCannotUse) {
  const auto images = SyntheticImages(3, 10, 10, 1);
  VocabularyTraining training = Small();
  training.branching = 1;
  ExpectRefused(images, training, "branching is 1");
  training.branching = 256;
  ExpectRefused(images, training, "branching is 256");
  training = Small();
  training.levels = 0;
  ExpectRefused(images, training, "levels is 0");
  training = Small();
  training.iterations = 0;
  ExpectRefused(images, training, "iterations is 0");
  training = Small();
  training.min_members = 1;
  ExpectRefused(images, training, "min_members 1");
  ExpectRefused({}, Small(), "0 descriptors");
  ExpectRefused({{Descriptor{1}, Descriptor{1}}, {Descriptor{1}}}, Small(), "no two that differ");
}

}  // namespace
}  // namespace drydock::svin2
