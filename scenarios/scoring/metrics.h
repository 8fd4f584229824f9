// The figures of a scorecard. To add one: a member here and a line in AllMetrics().
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace drydock::score {

/// What a run was worth; nothing where the figure does not exist for the run. AllMetrics() says
/// what each one is.
struct Metrics {
  std::optional<double> ate_rmse_m;
  std::optional<double> ate_odometry_rmse_m;
  std::optional<double> ate_to_odometry;
  std::optional<double> ate_percent;
  std::optional<double> scale_error_percent;
  std::optional<double> rpe_5m_percent;
  std::optional<double> rpe_5m_deg_per_m;
  std::optional<double> final_drift_percent;
  std::optional<double> yaw_error_deg;
  std::optional<double> z_rmse_m;
  std::optional<double> continuity_percent;
  std::optional<double> init_time_s;
  std::optional<double> init_scale_error_percent;
  std::optional<double> false_starts;
  std::optional<double> anees_position;
  std::optional<double> anees_orientation;
  std::optional<double> ate_after_fault_m;
  std::optional<double> recovery_time_s;
  std::optional<double> loops_found;
  std::optional<double> loop_precision;
  std::optional<double> loop_recall;
  std::optional<double> sonar_map_rmse_m;
  std::optional<double> landmark_map_rmse_m;
};

enum class Better {
  kLower,
  kHigher,
  kNearZero,  ///< Signed: either side is worse.
  kNearOne,
};

/// One kind of figure.
struct MetricInfo {
  std::string_view name;  ///< As in scorecard.json and in criteria.
  std::string_view unit;  ///< "" for a plain number.
  Better better = Better::kLower;
  std::string_view description;  ///< One line.
  std::optional<double> Metrics::*value = nullptr;
};

/// Every metric, in the order of the scorecard.
std::span<const MetricInfo> AllMetrics();

/// The metric of this name, or nullptr.
const MetricInfo* FindMetric(std::string_view name);

}  // namespace drydock::score
