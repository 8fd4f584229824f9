#include "scenarios/scoring/metrics.h"

#include <algorithm>
#include <array>

namespace drydock::score {
namespace {

// clang-format off
constexpr std::array kMetrics = std::to_array<MetricInfo>({
    {"ate_rmse_m", "m", Better::kLower, "RMS position error of the final trajectory after SE(3) alignment", &Metrics::ate_rmse_m},
    {"ate_odometry_rmse_m", "m", Better::kLower, "the same of the odometry as it was published at the time", &Metrics::ate_odometry_rmse_m},
    {"ate_to_odometry", "", Better::kLower, "ate_rmse_m over ate_odometry_rmse_m: under 1 where loops have made it better", &Metrics::ate_to_odometry},
    {"ate_percent", "%", Better::kLower, "ate_rmse_m as a share of the length of the true path", &Metrics::ate_percent},
    {"scale_error_percent", "%", Better::kNearZero, "100 (1/s - 1) with s the scale of Sim(3) alignment; positive: estimate too large", &Metrics::scale_error_percent},
    {"rpe_5m_percent", "%", Better::kLower, "mean position error of steps of 5 m along the estimate, as a share of the step", &Metrics::rpe_5m_percent},
    {"rpe_5m_deg_per_m", "deg/m", Better::kLower, "mean rotation error of steps of 5 m along the estimate, per metre", &Metrics::rpe_5m_deg_per_m},
    {"final_drift_percent", "%", Better::kLower, "position error at the end, aligned by position and yaw at the start, as a share of the true path", &Metrics::final_drift_percent},
    {"yaw_error_deg", "deg", Better::kLower, "RMS heading error after alignment by position and yaw over all poses", &Metrics::yaw_error_deg},
    {"z_rmse_m", "m", Better::kLower, "RMS vertical error after alignment by position and yaw over all poses", &Metrics::z_rmse_m},
    {"continuity_percent", "%", Better::kHigher, "time with valid odometry as a share of the dive after initialisation", &Metrics::continuity_percent},
    {"init_time_s", "s", Better::kLower, "from the start of the dive to the first odometry", &Metrics::init_time_s},
    {"init_scale_error_percent", "%", Better::kNearZero, "as scale_error_percent, of the odometry in the first 5 s of motion", &Metrics::init_scale_error_percent},
    {"false_starts", "", Better::kLower, "initialisations that were given up again within 5 s", &Metrics::false_starts},
    {"anees_position", "", Better::kNearOne, "mean normalised squared position error per degree of freedom", &Metrics::anees_position},
    {"anees_orientation", "", Better::kNearOne, "mean normalised squared rotation error per degree of freedom", &Metrics::anees_orientation},
    {"ate_after_fault_m", "m", Better::kLower, "as ate_rmse_m, of the poses after the last fault has ended", &Metrics::ate_after_fault_m},
    {"recovery_time_s", "s", Better::kLower, "from the end of the last fault to the next odometry", &Metrics::recovery_time_s},
    {"loops_found", "", Better::kHigher, "loops that were closed", &Metrics::loops_found},
    {"loop_precision", "%", Better::kHigher, "share of the closed loops within 0.25 m + 5 % and 5 deg of the truth; 100 of none", &Metrics::loop_precision},
    {"loop_recall", "%", Better::kHigher, "share of the places swum by again (0.5 m apart) at which a true loop was closed", &Metrics::loop_recall},
    {"sonar_map_rmse_m", "m", Better::kLower, "RMS distance of the sonar map to the true surfaces, 1 m at most each", &Metrics::sonar_map_rmse_m},
    {"landmark_map_rmse_m", "m", Better::kLower, "RMS distance of the landmarks to the true surfaces, 1 m at most each", &Metrics::landmark_map_rmse_m},
});
// clang-format on

}  // namespace

std::span<const MetricInfo> AllMetrics() { return kMetrics; }

const MetricInfo* FindMetric(std::string_view name) {
  const auto found = std::find_if(kMetrics.begin(), kMetrics.end(),
                                  [name](const MetricInfo& metric) { return metric.name == name; });
  return found == kMetrics.end() ? nullptr : &*found;
}

}  // namespace drydock::score
