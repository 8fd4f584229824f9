#include "scenarios/scoring/errors.h"

#include <algorithm>
#include <cmath>

#include "sensors_models/base/check.h"

namespace drydock::score {
namespace {

/// Neumaier's sum: as if added in twice the precision, so that order does not show.
class Sum {
 public:
  void Add(double value) {
    const double total = total_ + value;
    rest_ +=
        std::abs(total_) >= std::abs(value) ? (total_ - total) + value : (value - total) + total_;
    total_ = total;
  }
  double Total() const { return total_ + rest_; }

 private:
  double total_ = 0.0;
  double rest_ = 0.0;
};

double Angle(const Eigen::Quaterniond& q) { return LogSO3(q).norm(); }

const Pose& PoseAlong(const PosePair& pair, StepOptions::Along along) {
  return along == StepOptions::Along::kTruth ? pair.truth : pair.estimate;
}

/// Path lengths from the first pose [m].
std::vector<double> PathFromStart(const std::vector<PosePair>& pairs, StepOptions::Along along) {
  std::vector<double> path(pairs.size(), 0.0);
  for (std::size_t i = 1; i < pairs.size(); ++i) {
    const Eigen::Vector3d& from = PoseAlong(pairs[i - 1], along).p();
    path[i] = path[i - 1] + (PoseAlong(pairs[i], along).p() - from).norm();
  }
  return path;
}

using Steps = std::vector<std::pair<std::size_t, std::size_t>>;

Steps StepsByFrames(std::size_t count, std::size_t step, bool all_pairs) {
  Steps steps;
  for (std::size_t i = 0; i + step < count; i += all_pairs ? 1 : step) {
    steps.emplace_back(i, i + step);
  }
  return steps;
}

Steps AllStepsByMetres(const std::vector<double>& path, double step, double tolerance) {
  Steps steps;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const auto miss = [&](std::size_t j) { return std::abs(path[j] - path[i] - step); };
    const auto from = path.begin() + static_cast<std::ptrdiff_t>(i) + 1;
    const auto reached =
        std::partition_point(from, path.end(), [&](double s) { return s - path[i] < step; });
    auto best = static_cast<std::size_t>(reached - path.begin());
    if (best == path.size() || (best > i + 1 && miss(best - 1) <= miss(best))) --best;
    while (best > i + 1 && miss(best - 1) <= miss(best)) --best;
    if (miss(best) <= tolerance * step) steps.emplace_back(i, best);
  }
  return steps;
}

Steps ConsecutiveStepsByMetres(const std::vector<PosePair>& pairs, const StepOptions& options) {
  Steps steps;
  std::optional<std::size_t> last;
  double since_last = 0.0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (i > 0) {
      since_last +=
          (PoseAlong(pairs[i], options.along).p() - PoseAlong(pairs[i - 1], options.along).p())
              .norm();
    }
    if (since_last < options.step) continue;
    if (last) steps.emplace_back(*last, i);
    last = i;
    since_last = 0.0;
  }
  return steps;
}

}  // namespace

std::optional<Statistics> Summarize(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  Statistics statistics;
  const std::size_t n = values.size();
  statistics.count = n;
  Sum sum;
  Sum squares;
  for (const double value : values) {
    sum.Add(value);
    squares.Add(value * value);
  }
  const auto count = static_cast<double>(n);
  statistics.mean = sum.Total() / count;
  statistics.sse = squares.Total();
  statistics.rmse = std::sqrt(statistics.sse / count);
  Sum deviations;
  for (const double value : values) deviations.Add(std::pow(value - statistics.mean, 2));
  statistics.standard_deviation = std::sqrt(deviations.Total() / count);
  std::sort(values.begin(), values.end());
  statistics.min = values.front();
  statistics.max = values.back();
  statistics.median = n % 2 == 1 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
  return statistics;
}

PoseErrors AbsoluteErrors(const std::vector<PosePair>& pairs, const Similarity& alignment) {
  PoseErrors errors;
  for (const PosePair& pair : pairs) {
    const Pose aligned = alignment * pair.estimate;
    errors.translation.push_back((aligned.p() - pair.truth.p()).norm());
    errors.rotation.push_back(Angle(aligned.q().conjugate() * pair.truth.q()));
  }
  return errors;
}

Steps SelectSteps(const std::vector<PosePair>& pairs, const StepOptions& options) {
  if (options.unit == StepOptions::Unit::kFrames) {
    RequireInput(options.step >= 1.0 && options.step == std::floor(options.step),
                 "a step of {} frames: must be a whole number of at least 1", options.step);
    return StepsByFrames(pairs.size(), static_cast<std::size_t>(options.step), options.all_pairs);
  }
  RequireInput(options.step > 0.0, "a step of {} m: must be above 0", options.step);
  if (!options.all_pairs) return ConsecutiveStepsByMetres(pairs, options);
  return AllStepsByMetres(PathFromStart(pairs, options.along), options.step, options.tolerance);
}

PoseErrors RelativeErrors(const std::vector<PosePair>& pairs, const StepOptions& options) {
  PoseErrors errors;
  for (const auto& [i, j] : SelectSteps(pairs, options)) {
    const Pose truth = pairs[i].truth.Inverse() * pairs[j].truth;
    const Pose estimate = pairs[i].estimate.Inverse() * pairs[j].estimate;
    const Pose error = truth.Inverse() * estimate;
    errors.translation.push_back(error.p().norm());
    errors.rotation.push_back(Angle(error.q()));
  }
  return errors;
}

}  // namespace drydock::score
