// Descriptors that crowd around known centres.
#pragma once

#include <vector>

#include "estimator/svin2/frontend/descriptor.h"
#include "estimator/svin2/vocabulary/train_vocabulary.h"
#include "estimator/svin2/vocabulary/vocabulary.h"
#include "sensors_models/base/random_stream.h"

namespace drydock::svin2::testing {

inline Descriptor RandomDescriptor(RandomStream& random) {
  Descriptor descriptor;
  for (std::uint64_t& bits : descriptor) bits = random.Bits();
  return descriptor;
}

inline std::vector<Descriptor> RandomDescriptors(std::size_t count, RandomStream& random) {
  std::vector<Descriptor> descriptors(count);
  for (Descriptor& descriptor : descriptors) descriptor = RandomDescriptor(random);
  return descriptors;
}

/// `descriptor` with about `flips` bits changed.
inline Descriptor Disturbed(Descriptor descriptor, int flips, RandomStream& random) {
  for (int i = 0; i < flips; ++i) {
    const std::uint64_t bit = random.Bits() % 512;
    descriptor[bit / 64] ^= std::uint64_t{1} << (bit % 64);
  }
  return descriptor;
}

/// Images of a world of `centres` things, each showing `seen` of them, disturbed by 20 bits.
inline std::vector<std::vector<Descriptor>> SyntheticImages(std::size_t images, std::size_t centres,
                                                            std::size_t seen, std::uint64_t seed) {
  RandomStream random(seed, "synthetic_descriptors");
  const std::vector<Descriptor> things = RandomDescriptors(centres, random);
  std::vector<std::vector<Descriptor>> all(images);
  for (auto& image : all) {
    for (std::size_t i = 0; i < seen; ++i) {
      image.push_back(Disturbed(things[random.Bits() % centres], 20, random));
    }
  }
  return all;
}

/// Of some 100 words.
inline Vocabulary SmallVocabulary() {
  VocabularyTraining training;
  training.branching = 5;
  training.levels = 3;
  return Vocabulary(TrainVocabulary(SyntheticImages(20, 100, 40, 5), training));
}

}  // namespace drydock::svin2::testing
