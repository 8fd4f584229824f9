// What holds of every scene that is made.
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "scenes/mesh/mesh.h"
#include "scenes/model/model.h"
#include "scenes/texture/texture_task.h"
#include "sensors_models/base/files.h"
#include "tests/support/temporary_folder.h"

namespace drydock::testing {

/// What the files below `folder` hold, by their paths in it.
inline std::map<std::string, std::string> FilesOf(const std::filesystem::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file())
      files[std::filesystem::relative(entry.path(), folder).string()] = ReadFile(entry.path());
  }
  return files;
}

/// The files that `generate` writes into a folder, which is then removed.
template <typename Generate>
std::map<std::string, std::string> FilesMadeBy(const Generate& generate) {
  const TemporaryFolder folder;
  generate(folder.path() / "scene");
  return FilesOf(folder.path() / "scene");
}

/// A picture's opposite sides fit: the step across the seam is no more than twice that between the
/// columns, and rows, number `somewhere` and the next.
inline void ExpectMeetsItself(const cv::Mat3b& picture, int somewhere, const std::string& name) {
  const auto step = [](const cv::Mat& a, const cv::Mat& b) {
    return cv::norm(a, b, cv::NORM_L1) / static_cast<double>(3 * a.total());
  };
  EXPECT_LT(step(picture.col(0), picture.col(picture.cols - 1)),
            2.0 * step(picture.col(somewhere), picture.col(somewhere + 1)))
      << name;
  EXPECT_LT(step(picture.row(0), picture.row(picture.rows - 1)),
            2.0 * step(picture.row(somewhere), picture.row(somewhere + 1)))
      << name;
}

/// Every material has a picture, and every picture is some part's.
inline void ExpectEveryMaterialPainted(const scenes::SceneModel& model,
                                       const std::vector<scenes::TextureTask>& pictures) {
  std::set<std::string> used;
  for (const scenes::Part& part : model.parts()) used.insert(part.material);
  std::set<std::string> painted;
  for (const scenes::TextureTask& task : pictures) painted.insert(task.name);
  EXPECT_EQ(used, painted);
}

/// Every part has a name of its own and a mesh with a unit normal and a place in the picture at
/// each corner.
inline void ExpectSoundMeshes(const scenes::SceneModel& model) {
  std::set<std::string> geoms;
  for (const scenes::Part& part : model.parts()) {
    EXPECT_TRUE(geoms.insert(part.geom).second) << part.geom << " twice";
    const scenes::Mesh& mesh = part.mesh;
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size()) << part.geom;
    ASSERT_EQ(mesh.uvs.size(), mesh.positions.size()) << part.geom;
    EXPECT_GT(scenes::SurfaceArea(mesh), 1e-4) << part.geom;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      ASSERT_TRUE(mesh.positions[i].allFinite() && mesh.uvs[i].allFinite()) << part.geom;
      ASSERT_NEAR(mesh.normals[i].norm(), 1.0, 1e-6) << part.geom;
    }
  }
}

/// The gradient is more than a grey level a pixel on average, also of the picture at half its size,
/// at a quarter and so on.
inline void ExpectContrastAtEveryScale(const cv::Mat3b& picture, const std::string& name) {
  cv::Mat1b grey;
  cv::cvtColor(picture, grey, cv::COLOR_RGB2GRAY);
  for (int octave = 0; octave < 5 && std::min(grey.rows, grey.cols) > 40; ++octave) {
    cv::Mat1f x;
    cv::Sobel(grey, x, CV_32F, 1, 0, 3, 0.125);
    EXPECT_GT(cv::mean(cv::abs(x))[0], 1.0) << name << ", octave " << octave;
    cv::resize(grey, grey, {grey.cols / 2, grey.rows / 2}, 0, 0, cv::INTER_AREA);
  }
}

}  // namespace drydock::testing
