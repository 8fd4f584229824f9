#include "sim/optics/jerlov.h"

#include <algorithm>
#include <array>

namespace drydock::sim {
namespace {

const std::array<JerlovType, 6>& Types() {
  static const std::array<JerlovType, 6> types = {{
      {"IB", {.346, .071, .042}, {.118, .120, .135}},
      {"II", {.353, .077, .066}, {.164, .184, .195}},
      {"III", {.364, .091, .114}, {.271, .306, .309}},
      {"1C", {.366, .099, .159}, {.412, .447, .435}},
      {"3C", {.375, .118, .231}, {.652, .675, .636}},
      {"5C", {.395, .157, .327}, {1.24, 1.27, 1.07}},
  }};
  return types;
}

}  // namespace

Eigen::Array3d JerlovType::DiffuseAttenuation() const {
  constexpr double kMeanCosine = 0.85;
  return (absorption.square() + (0.425 * kMeanCosine - 0.19) * absorption * scattering).sqrt() /
         kMeanCosine;
}

const JerlovType* FindJerlovType(std::string_view name) {
  const auto& types = Types();
  const auto found = std::find_if(types.begin(), types.end(),
                                  [name](const JerlovType& type) { return type.name == name; });
  return found == types.end() ? nullptr : &*found;
}

std::vector<std::string> JerlovTypeNames() {
  std::vector<std::string> names;
  for (const JerlovType& type : Types()) names.emplace_back(type.name);
  return names;
}

}  // namespace drydock::sim
