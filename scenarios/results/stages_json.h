// What an estimator's stages cost, for timings.json.
#pragma once

#include <nlohmann/json.hpp>

#include "estimator/interface/stage_timings.h"

namespace drydock {

/// {"detection": {"count": …, "total_s": …, "median_ms": …, "p99_ms": …}, …}
inline nlohmann::ordered_json StagesJson(const EstimatorTimings& timings) {
  nlohmann::ordered_json stages = nlohmann::ordered_json::object();
  for (const StageTimings& stage : timings) {
    stages[stage.name] = {{"count", stage.count},
                          {"total_s", stage.total_s},
                          {"median_ms", stage.median_ms},
                          {"p99_ms", stage.p99_ms}};
  }
  return stages;
}

}  // namespace drydock
