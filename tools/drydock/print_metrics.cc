#include "tools/drydock/print_metrics.h"

#include <optional>

#include <fmt/format.h>

namespace drydock::cli {

void PrintMetrics(const score::Metrics& metrics) {
  for (const score::MetricInfo& metric : score::AllMetrics()) {
    const std::optional<double>& value = metrics.*metric.value;
    if (value) fmt::print("  {:<24} {:>10.4f} {}\n", metric.name, *value, metric.unit);
  }
}

}  // namespace drydock::cli
