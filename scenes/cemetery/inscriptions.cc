#include "scenes/cemetery/inscriptions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "sensors_models/base/random_stream.h"

namespace drydock::scenes::cemetery {
namespace {

constexpr std::array kFirstNames = {"ADA",      "BRAM",    "CORDULA", "DUNSTAN",  "EDDA",
                                    "FENWIN",   "GILDA",   "HOB",     "ISOLDE",   "JASPER",
                                    "KEZIA",    "LINUS",   "MINNA",   "NEHEMIAH", "OTTILIE",
                                    "PERPETUA", "QUILLAN", "ROWENA",  "SILAS",    "TAMSIN"};
constexpr std::array kSurnames = {"MOSSWELL",  "TARNE",    "REEDLOW",  "PIKEMAN",  "SILTBY",
                                  "OXBOW",     "WEIRLY",   "DRUMLIN",  "FATHOM",   "GRAYLAKE",
                                  "HOLMERE",   "KELPER",   "LOAMSDEN", "MERESTON", "NIXFORD",
                                  "PEBBLETON", "QUAGMOOR", "RUSHBED",  "SEDGELY",  "UNDERWEIR"};
constexpr std::array kEpitaphs = {"AT REST",      "STILL WATERS", "GONE BELOW",   "ASLEEP",
                                  "SADLY MISSED", "HOME AT LAST", "DEEP PEACE",   "BELOVED",
                                  "UNFORGOTTEN",  "LAST ANCHOR",  "SLEEP GENTLY", "FAREWELL"};
constexpr std::array kOrnaments = {Ornament::kCross,  Ornament::kStar, Ornament::kWreath,
                                   Ornament::kAnchor, Ornament::kRays, Ornament::kLeaf,
                                   Ornament::kNone};

/// A random order of 0 ... n - 1 (Fisher and Yates).
std::vector<std::size_t> Shuffled(std::size_t n, RandomStream& random) {
  std::vector<std::size_t> order(n);
  for (std::size_t i = 0; i < n; ++i) order[i] = i;
  for (std::size_t i = n; i > 1; --i) {
    const double u = random.Uniform();
    std::swap(order[i - 1], order[static_cast<std::size_t>(u * static_cast<double>(i))]);
  }
  return order;
}

int Pick(int low, int high, RandomStream& random) {
  return static_cast<int>(std::floor(random.Uniform(low, high + 1)));
}

}  // namespace

std::vector<Inscription> Inscriptions(std::uint64_t seed) {
  static_assert(kFirstNames.size() == kSurnames.size());
  static_assert(kInscriptions <= 2 * static_cast<int>(kFirstNames.size()));
  constexpr std::size_t kNames = kFirstNames.size();
  RandomStream random(seed, "cemetery/inscriptions");
  const std::vector<std::size_t> first = Shuffled(kNames, random);
  const std::vector<std::size_t> last = Shuffled(kNames, random);
  std::vector<Inscription> all;
  all.reserve(kInscriptions);
  for (std::size_t i = 0; i < kInscriptions; ++i) {
    // The second time round the names are paired otherwise.
    const std::size_t shift = 7 * (i / kNames);
    const int born = Pick(1790, 1905, random);
    const int age = Pick(3, 91, random);
    const auto epitaph = static_cast<std::size_t>(Pick(0, kEpitaphs.size() - 1, random));
    const auto ornament = static_cast<std::size_t>(Pick(0, kOrnaments.size() - 1, random));
    all.push_back({kFirstNames[first[i % kNames]], kSurnames[last[(i + shift) % kNames]],
                   fmt::format("{} - {}", born, born + age), kEpitaphs[epitaph],
                   kOrnaments[ornament]});
  }
  return all;
}

}  // namespace drydock::scenes::cemetery
