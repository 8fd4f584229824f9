// What an estimator might say, for tests of those who listen.
#pragma once

#include "estimator/interface/estimator.h"

namespace drydock::testing {

inline NavEstimate Estimate(TrackingStatus status, int map_id) {
  NavEstimate estimate;
  estimate.status = status;
  estimate.map_id = map_id;
  return estimate;
}

}  // namespace drydock::testing
