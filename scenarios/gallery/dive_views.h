// What a diver's left eye sees on a dive.
#pragma once

#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

namespace drydock {

struct DiveViews {
  std::string scenario;                ///< Of those that come with Drydock: "bus".
  std::vector<std::string> overrides;  ///< "key.path=value", as on the command line.
  std::vector<double> moments;         ///< Of the dive [s].
};

/// The left image (CV_8UC3 if the scenario wants colour, else CV_8UC1) at each moment, with its
/// exposure settled. InputError as Dive has it.
std::vector<cv::Mat> LeftImages(const DiveViews& views);

}  // namespace drydock
