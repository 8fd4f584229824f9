// What the front end makes of a recording, for training and judging the recognition of places.
#pragma once

#include <filesystem>
#include <vector>

#include "estimator/svin2/frontend/descriptor.h"
#include "estimator/svin2/frontend/feature_tracker.h"
#include "sensors_models/base/pose.h"
#include "sensors_models/base/time.h"

namespace drydock {

struct KeyframeView {
  Time t;
  Pose T_WI;                                   ///< The true one.
  std::vector<svin2::Descriptor> descriptors;  ///< Of the points that the front end follows.
};

/// Goes through an EuRoC folder with SVIn2's front end. Motion is predicted by the recording's true
/// poses; where it has none the frame is left out. InputError if nothing is left.
std::vector<KeyframeView> ViewKeyframes(const std::filesystem::path& recording,
                                        const svin2::FeatureTracker::Config& config);

}  // namespace drydock
