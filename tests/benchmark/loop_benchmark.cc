// What recognising places costs: loading the vocabulary, an image's words, asking the database.
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "estimator/svin2/places/place_database.h"
#include "estimator/svin2/vocabulary/vocabulary.h"
#include "sensors_models/base/random_stream.h"

namespace drydock::benchmark {
namespace {

using namespace svin2;  // NOLINT(google-build-using-namespace): all that is measured.

constexpr std::size_t kDescriptors = 200;

/// A dive through a scene of as many things as there are words: each keyframe shows 200 of them in
/// a row, 20 of them new.
class Swim {
 public:
  explicit Swim(const Vocabulary& vocabulary) : random_(1, "loop_benchmark") {
    const VocabularyTree& tree = vocabulary.tree();
    for (std::size_t node = 1; node < tree.children.size(); ++node) {
      if (tree.children[node] == 0) things_.push_back(tree.centres[node - 1]);
    }
    for (std::size_t i = things_.size(); i > 1; --i) {
      std::swap(things_[i - 1], things_[random_.Bits() % i]);
    }
  }

  std::vector<Descriptor> See(std::size_t keyframe) const {
    std::vector<Descriptor> seen;
    for (std::size_t i = 0; i < kDescriptors; ++i) {
      seen.push_back(things_[(20 * keyframe + i) % things_.size()]);
    }
    return seen;
  }

 private:
  RandomStream random_;
  std::vector<Descriptor> things_;
};

void VocabularyLoad(::benchmark::State& state) {
  while (state.KeepRunning()) {
    ::benchmark::DoNotOptimize(Vocabulary::Load(Vocabulary::DefaultPath()));
  }
}

/// Items are descriptors.
void VocabularyTransform(::benchmark::State& state) {
  const Vocabulary vocabulary = Vocabulary::Load(Vocabulary::DefaultPath());
  const std::vector<Descriptor> image = Swim(vocabulary).See(0);
  while (state.KeepRunning()) ::benchmark::DoNotOptimize(vocabulary.Transform(image, 2));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kDescriptors));
}

/// A loop query after `keyframes`; the counter is the database's memory.
void PlaceQuery(::benchmark::State& state) {
  const Vocabulary vocabulary = Vocabulary::Load(Vocabulary::DefaultPath());
  const Swim swim(vocabulary);
  PlaceDatabase database(vocabulary.words());
  const std::size_t empty = database.Bytes();
  const auto keyframes = static_cast<std::size_t>(state.range(0));
  for (std::size_t i = 0; i < keyframes; ++i) {
    database.Add(static_cast<KeyframeIndex>(i), vocabulary.Transform(swim.See(i), 2));
  }
  const BowVector words = vocabulary.Transform(swim.See(keyframes), 2).words;
  const KeyframeIndex last = state.range(0) - 1;
  while (state.KeepRunning()) {
    ::benchmark::DoNotOptimize(
        database.LoopCandidates(words, {last, last - 1}, last - 20, LoopCandidateRule{}));
  }
  state.counters["bytes_a_keyframe"] =
      static_cast<double>(database.Bytes() - empty) / static_cast<double>(keyframes);
}

BENCHMARK(VocabularyLoad)->Unit(::benchmark::kMillisecond);
BENCHMARK(VocabularyTransform)->Unit(::benchmark::kMicrosecond);
BENCHMARK(PlaceQuery)->ArgName("keyframes")->Arg(500)->Arg(5000)->Unit(::benchmark::kMicrosecond);

}  // namespace
}  // namespace drydock::benchmark
