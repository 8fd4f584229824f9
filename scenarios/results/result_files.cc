#include "scenarios/results/result_files.h"

#include <cstdint>
#include <utility>

#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>

#include "scenarios/dataset/tum.h"
#include "scenarios/report/trajectory_plot.h"
#include "scenarios/scoring/json.h"
#include "scenarios/scoring/loops.h"
#include "sensors_models/base/check.h"
#include "sensors_models/base/files.h"

namespace drydock {
namespace {

std::string LoopsCsv(const std::vector<LoopClosure>& loops) {
  std::string csv =
      "#timestamp_now [ns],timestamp_then [ns],p_x [m],p_y [m],p_z [m],q_w [],q_x [],q_y [],q_z "
      "[]\n";
  for (const LoopClosure& loop : loops) {
    const Eigen::Vector3d& p = loop.T_then_now.p();
    const Eigen::Quaterniond& q = loop.T_then_now.q();
    csv += fmt::format("{},{},{},{},{},{},{},{},{}\n", loop.t_now.ns, loop.t_then.ns, p.x(), p.y(),
                       p.z(), q.w(), q.x(), q.y(), q.z());
  }
  return csv;
}

void FillLoops(const Trajectory& truth, const std::vector<LoopClosure>& closures,
               score::Metrics& metrics) {
  std::vector<score::Loop> loops;
  loops.reserve(closures.size());
  for (const LoopClosure& closure : closures)
    loops.push_back({closure.t_now, closure.t_then, closure.T_then_now});
  const score::LoopScore score = score::ScoreLoops(truth, loops);
  metrics.loops_found = static_cast<double>(loops.size());
  metrics.loop_precision = score.PrecisionPercent();
  metrics.loop_recall = score.RecallPercent();
}

/// `trajectory` where the scorecard's alignment puts it upon the truth.
Trajectory Aligned(Trajectory trajectory, const score::Scorecard& card) {
  if (!card.alignment) return trajectory;
  for (StampedPose& pose : trajectory) pose.T_WI = *card.alignment * pose.T_WI;
  return trajectory;
}

}  // namespace

score::Metrics KnownMetrics(const Trajectory& truth, const Results& results) {
  score::Metrics metrics;
  if (const auto anees = score::ComputeAnees(truth, results.beliefs)) {
    metrics.anees_position = anees->position;
    metrics.anees_orientation = anees->orientation;
  }
  if (results.false_starts) metrics.false_starts = *results.false_starts;
  FillLoops(truth, results.loops, metrics);
  return metrics;
}

void WriteResults(const std::filesystem::path& folder, const Results& results) {
  dataset::WriteTum(folder / "odometry.tum", results.odometry);
  dataset::WriteTum(folder / "trajectory.tum", results.corrected);
  WriteFileAtomically(folder / "loops.csv", LoopsCsv(results.loops));
  std::string events;
  for (const std::string& event : results.events) events += event + "\n";
  WriteFileAtomically(folder / "events.log", events);
}

void WriteScore(const std::filesystem::path& folder, const std::string& title,
                const Trajectory& truth, const Trajectory& trajectory,
                const score::Scorecard& card) {
  dataset::WriteTum(folder / "truth.tum", truth);
  WriteFileAtomically(folder / "scorecard.json", score::ToJson(card));
  const std::string picture = (folder / "trajectory.png").string();
  const cv::Mat drawing =
      report::DrawTrajectories(title, truth, {{card.run.estimator, Aligned(trajectory, card)}});
  RequireInput(cv::imwrite(picture, drawing), "{}: cannot be written", picture);
}

std::string HashText(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  return fmt::format("{:016x}", hash);
}

}  // namespace drydock
