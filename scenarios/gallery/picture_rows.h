// Pictures side by side, for the docs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

namespace drydock {

struct PictureRow {
  std::string label;              ///< Above the pictures.
  std::vector<cv::Mat> pictures;  ///< CV_8UC1 or CV_8UC3 (BGR), each 4:3.
};

/// Writes a JPEG, all rows as wide as the first. InputError if it cannot be written.
void WritePictureRows(const std::filesystem::path& path, const std::vector<PictureRow>& rows);

}  // namespace drydock
