// Every file of a vocabulary is read or refused with an InputError, and what is read can be used.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "estimator/svin2/vocabulary/vocabulary.h"
#include "estimator/svin2/vocabulary/vocabulary_file.h"
#include "sensors_models/base/check.h"
#include "tests/fuzz/require.h"

namespace drydock::fuzz {
namespace {

std::optional<svin2::VocabularyTree> Parse(std::string_view content) {
  try {
    return svin2::ParseVocabulary(content, "fuzz.vocabulary");
  } catch (const InputError& error) {
    Require(std::string_view(error.what()).starts_with("fuzz.vocabulary: "),
            "an error names its file");
    return std::nullopt;
  }
}

void Use(const svin2::VocabularyTree& tree) {
  Require(svin2::ParseVocabulary(svin2::FormatVocabulary(tree), "again").centres == tree.centres,
          "what is written is what was read");
  const svin2::Vocabulary vocabulary(tree);
  for (const svin2::Descriptor& centre : {svin2::Descriptor{}, tree.centres.back()}) {
    Require(vocabulary.WordOf(centre) < vocabulary.words(), "words are counted");
    double sum = 0.0;
    for (const auto& word : vocabulary.Transform({centre}, 1).words) sum += word.weight;
    Require(sum == 0.0 || std::abs(sum - 1.0) < 1e-6, "weights add up to 1");
  }
}

void Run(std::string_view bytes) {
  if (const auto tree = Parse(bytes)) Use(*tree);
  // Past the checksum, which no fuzzer guesses.
  if (const auto tree = Parse(svin2::PackVocabulary(bytes))) Use(*tree);
}

}  // namespace
}  // namespace drydock::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  drydock::fuzz::Run({reinterpret_cast<const char*>(data), size});
  return 0;
}
