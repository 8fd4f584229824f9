#include "scenarios/compare/compare.h"

#include <algorithm>
#include <ctime>
#include <future>
#include <memory>
#include <thread>

#include <fmt/format.h>

#include "scenarios/compare/plan.h"
#include "scenarios/compare/tables.h"
#include "scenarios/results/estimator_session.h"
#include "scenarios/runner/dive.h"
#include "scenarios/runner/run_files.h"
#include "scenarios/runner/score_dive.h"
#include "scenarios/runner/start_estimator.h"
#include "sensors_models/base/files.h"
#include "sensors_models/base/worker.h"

namespace drydock::compare {
namespace {

/// CPU time of the calling thread [s]: what an estimator costs, however many run beside it.
double ThreadSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// One estimator that takes part in a dive.
class Lane {
 public:
  Lane(const Scenario& scenario, const Dive& dive)
      : scenario_(scenario), session_(StartEstimator(scenario, dive.InitialState())) {}

  void Add(const Measurement& measurement) {
    const double start = ThreadSeconds();
    session_.Add(measurement);
    seconds_ += ThreadSeconds() - start;
  }
  void Finish() {
    const double start = ThreadSeconds();
    results_ = session_.Finish();
    seconds_ += ThreadSeconds() - start;
  }
  Finished Score(const Dive& dive, const Trajectory& truth, std::size_t frames) const {
    return {ScoreDive(scenario_, dive, truth, results_), seconds_, frames, results_.stages};
  }

 private:
  const Scenario& scenario_;
  EstimatorSession session_;
  Results results_;
  double seconds_ = 0.0;
};

/// Some threads that share the lanes: each lane stays on one.
class Crew {
 public:
  explicit Crew(std::vector<std::unique_ptr<Lane>>& lanes) : lanes_(lanes) {
    const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
    workers_.reserve(std::min(cores, lanes.size()));
    while (workers_.size() < std::min(cores, lanes.size()))
      workers_.push_back(std::make_unique<Worker>());
  }

  /// Waits for what was begun before, and begins `work` on each lane.
  void Begin(const std::function<void(Lane&)>& work) {
    Wait();
    begun_.reserve(lanes_.size());
    for (std::size_t i = 0; i < lanes_.size(); ++i) {
      Lane& lane = *lanes_[i];
      begun_.push_back(workers_[i % workers_.size()]->Submit([work, &lane] { work(lane); }));
    }
  }
  void Wait() {
    for (std::future<void>& one : begun_) one.get();
    begun_.clear();
  }

 private:
  std::vector<std::unique_ptr<Lane>>& lanes_;
  std::vector<std::future<void>> begun_;
  std::vector<std::unique_ptr<Worker>> workers_;
};

/// Swims a dive with some estimators and says what each was worth. While they work on one
/// measurement the next is simulated; nobody sees a second before all have seen the first.
std::vector<Finished> Swim(const std::vector<Scenario>& scenarios, const CompareOptions& options) {
  Dive dive(scenarios.front(), options.renderer);
  const auto progress = options.progress();
  std::vector<std::unique_ptr<Lane>> lanes;
  lanes.reserve(scenarios.size());
  for (const Scenario& scenario : scenarios)
    lanes.push_back(std::make_unique<Lane>(scenario, dive));
  Crew crew(lanes);
  std::size_t frames = 0;
  while (auto observation = dive.Next()) {
    const auto measurement =
        std::make_shared<const Measurement>(std::move(observation->measurement));
    if (std::holds_alternative<StereoFrame>(measurement->reading)) ++frames;
    crew.Begin([measurement](Lane& lane) { lane.Add(*measurement); });
    progress(measurement->t_arrival, dive.End());
  }
  crew.Begin([](Lane& lane) { lane.Finish(); });
  crew.Wait();
  const Trajectory truth = dive.Truth();
  std::vector<Finished> finished;
  finished.reserve(lanes.size());
  for (const auto& lane : lanes) finished.push_back(lane->Score(dive, truth, frames));
  return finished;
}

class Runner {
 public:
  explicit Runner(const CompareOptions& options)
      : options_(options),
        kept_(options.output / "finished"),
        program_(HashText(ReadFile("/proc/self/exe"))) {}

  CaseOutcome RunCase(const PlannedCase& planned) const {
    CaseOutcome outcome{planned.name, planned.seeds, {}};
    outcome.finished.resize(planned.scenarios.size());
    for (const std::uint64_t seed : planned.seeds) {
      const std::vector<Finished> finished = RunSeed(planned, seed);
      for (std::size_t i = 0; i < finished.size(); ++i) outcome.finished[i].push_back(finished[i]);
    }
    return outcome;
  }

 private:
  std::vector<Finished> RunSeed(const PlannedCase& planned, std::uint64_t seed) const {
    std::vector<std::string> hashes;
    std::vector<std::optional<Finished>> found;
    std::vector<Scenario> missing;
    for (const Scenario& scenario : planned.scenarios) {
      const Scenario seeded = WithSeed(scenario, seed);
      hashes.push_back(HashOf(seeded));
      found.push_back(kept_.Find(hashes.back()));
      if (!found.back()) missing.push_back(seeded);
    }
    std::vector<Finished> swum;
    if (!missing.empty()) swum = Swim(missing, options_);
    std::vector<Finished> all;
    auto next = swum.begin();
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (!found[i]) kept_.Keep(hashes[i], *next);
      all.push_back(found[i] ? *found[i] : *next++);
    }
    options_.report(fmt::format("{}, seed {}: {}", planned.name, seed,
                                missing.empty()
                                    ? "finished before"
                                    : fmt::format("{} of {} estimators simulated", missing.size(),
                                                  planned.scenarios.size())));
    return all;
  }

  std::string HashOf(const Scenario& scenario) const {
    return HashText(fmt::format("{} {} {}", ConfigHash(scenario), program_,
                                static_cast<int>(options_.renderer)));
  }

  const CompareOptions& options_;
  FinishedCases kept_;
  std::string program_;
};

}  // namespace

Comparison RunComparison(const Suite& suite, const CompareOptions& options) {
  RequireReplaceable(options.output, {"finished"});
  const std::vector<PlannedCase> plan = MakePlan(suite, options.overrides);
  const Runner runner(options);
  Comparison comparison{suite, {}, {}};
  for (const PlannedCase& planned : plan) comparison.cases.push_back(runner.RunCase(planned));
  comparison.criteria = JudgeAll(suite, comparison.cases);
  WriteFileAtomically(options.output / "comparison.md", ToMarkdown(comparison));
  WriteFileAtomically(options.output / "comparison.json", ToJson(comparison));
  WriteFileAtomically(options.output / "timings.json", CostsToJson(comparison));
  return comparison;
}

}  // namespace drydock::compare
