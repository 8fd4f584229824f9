// Creatures of boxes, for tests of what moves.
#pragma once

#include <filesystem>
#include <string>

#include <fmt/format.h>

#include "sensors_models/base/files.h"
#include "sim/world/moving_body.h"

namespace drydock::testing {

/// A box as an .obj file, with its picture's corners.
inline std::string BoxObj(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  std::string obj;
  for (int k = 0; k < 8; ++k) {
    obj += fmt::format("v {} {} {}\n", (k & 1) ? high.x() : low.x(), (k & 2) ? high.y() : low.y(),
                       (k & 4) ? high.z() : low.z());
  }
  obj += "vt 0 0\nvt 1 0\nvt 1 1\n";
  for (const char* face : {"1 3 2", "2 3 4", "5 6 7", "6 8 7", "1 2 5", "2 6 5", "3 7 4", "4 7 8",
                           "1 5 3", "3 5 7", "2 4 6", "4 8 6"}) {
    obj += fmt::format("f {}/1 {}/2 {}/3\n", face[0], face[2], face[4]);
  }
  return obj;
}

/// Fish of three boxes and an arm of one, in the layout of the real ones, with a red picture.
inline sim::Creatures WriteCreatures(const std::filesystem::path& folder) {
  // A PNG of one red pixel.
  const unsigned char png[] = {
      0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48,
      0x44, 0x52, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x08, 0x02, 0x00, 0x00,
      0x00, 0x90, 0x77, 0x53, 0xde, 0x00, 0x00, 0x00, 0x0c, 0x49, 0x44, 0x41, 0x54, 0x78,
      0xda, 0x63, 0xf8, 0xcf, 0xc0, 0x00, 0x00, 0x03, 0x01, 0x01, 0x00, 0xf7, 0x03, 0x41,
      0x43, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};
  WriteFileAtomically(folder / "red.png",
                      std::string_view(reinterpret_cast<const char*>(png), sizeof(png)));
  const auto part = [&](const std::string& name, const Eigen::Vector3d& low,
                        const Eigen::Vector3d& high, double joint) {
    WriteFileAtomically(folder / (name + ".obj"), BoxObj(low, high));
    return sim::CreaturePart{folder / (name + ".obj"), folder / "red.png", joint};
  };
  sim::Creatures creatures;
  for (const char* kind : {"bream", "bass", "perch"}) {
    creatures[kind] = {part("head", {-0.1, -0.06, -0.15}, {0.42, 0.06, 0.15}, 0.42),
                       part("body", {-0.3, -0.04, -0.1}, {-0.1, 0.04, 0.1}, -0.1),
                       part("tail", {-0.58, -0.01, -0.12}, {-0.3, 0.01, 0.12}, -0.3)};
  }
  creatures["arm_left"] =
      creatures["arm_right"] = {part("arm", {0.0, -0.04, -0.04}, {0.45, 0.04, 0.04}, 0.0)};
  return creatures;
}

}  // namespace drydock::testing
