// Makes the vocabulary that SVIn2 recognises places by, of recorded dives with ground truth, and
// judges one; see tools/train_vocabulary/train.
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "scenarios/places/judge_places.h"
#include "scenarios/places/make_vocabulary.h"

namespace drydock {
namespace {

struct Arguments {
  std::vector<std::filesystem::path> recordings;
  std::filesystem::path file;
  int max_gap = 10;
  svin2::VocabularyTraining training;
  PlaceJudging judging;
};

void Make(const Arguments& arguments) {
  const VocabularySummary made =
      MakeVocabulary(arguments.recordings, arguments.max_gap, arguments.training, arguments.file);
  fmt::print("{}: {} words of {} descriptors in {} images, {} bytes\n", arguments.file.string(),
             made.words, made.descriptors, made.images, made.bytes);
}

/// The value below which a share of the sorted values lies.
double Quantile(const std::vector<double>& values, double share) {
  if (values.empty()) return std::nan("");
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

void PrintScores(const std::string& what, const std::vector<double>& values) {
  fmt::print("  {:<24} {:>7} pairs, score at 1/5/50/95/99 %: {:.3f} {:.3f} {:.3f} {:.3f} {:.3f}\n",
             what, values.size(), Quantile(values, 0.01), Quantile(values, 0.05),
             Quantile(values, 0.5), Quantile(values, 0.95), Quantile(values, 0.99));
}

void PrintCount(const std::string& what, const CandidateCount& count) {
  fmt::print("  {:<24} {} of the same place, {} of another, {} in between\n", what, count.same,
             count.other, count.between);
}

void Judge(const Arguments& arguments) {
  const svin2::Vocabulary vocabulary = svin2::Vocabulary::Load(arguments.file);
  for (const auto& recording : arguments.recordings) {
    const auto views = ViewKeyframes(recording, {});
    const PlaceJudgement found = JudgePlaces(vocabulary, views, arguments.judging);
    fmt::print("{}: {} keyframes, {} of a place seen before\n", recording.string(), views.size(),
               found.revisits);
    PrintScores("neighbouring keyframes", found.neighbours);
    PrintScores("the same place", found.same);
    PrintScores("another place", found.other);
    PrintCount("best candidates", found.best);
    PrintCount("consistent ones", found.consistent);
  }
}

int Main(int argc, char** argv) {
  CLI::App app("Trains and judges the vocabulary that SVIn2 recognises places by");
  app.require_subcommand(1);
  Arguments arguments;
  std::function<void(const Arguments&)> chosen;
  CLI::App* make = app.add_subcommand("make", "Train on recordings, write a vocabulary file");
  make->add_option("recordings", arguments.recordings, "EuRoC folders")->required();
  make->add_option("-o,--output", arguments.file, "The vocabulary file")->required();
  make->add_option("--branching", arguments.training.branching, "k")->capture_default_str();
  make->add_option("--levels", arguments.training.levels, "L")->capture_default_str();
  make->add_option("--min-members", arguments.training.min_members,
                   "Descriptors of a node that is divided")
      ->capture_default_str();
  make->add_option("--seed", arguments.training.seed, "Of the first centres")
      ->capture_default_str();
  make->add_option("--max-gap", arguments.max_gap, "Frames between keyframes")
      ->capture_default_str();
  make->callback([&] { chosen = Make; });
  CLI::App* judge = app.add_subcommand("judge", "How well a vocabulary tells places apart");
  judge->add_option("vocabulary", arguments.file, "The vocabulary file")->required();
  judge->add_option("recordings", arguments.recordings, "EuRoC folders")->required();
  judge->callback([&] { chosen = Judge; });
  try {
    app.parse(argc, argv);
    chosen(arguments);
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "train_vocabulary: {}\n", error.what());
    return 2;
  }
}

}  // namespace
}  // namespace drydock

int main(int argc, char** argv) { return drydock::Main(argc, argv); }
