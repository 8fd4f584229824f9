// What the cameras saw, at a glance.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "sensors_models/base/time.h"

namespace drydock::report {

/// One stereo pair of a sheet: left and right, 8-bit grey or BGR.
struct SheetFrame {
  Time t;
  std::array<cv::Mat, 2> images;
};

/// Draws the pairs, left | right, row by row in `columns` columns, each under its time in seconds.
/// 1200 px wide, CV_8UC3. std::logic_error for an empty or otherwise formatted image or columns
/// < 1.
cv::Mat DrawContactSheet(const std::string& title, const std::vector<SheetFrame>& frames,
                         int columns = 2);

/// `count` indices spread evenly over `size` frames, first and last included; all if there are
/// fewer.
std::vector<std::size_t> SpreadEvenly(std::size_t size, std::size_t count);

}  // namespace drydock::report
