// Jerlov's water types.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

namespace drydock::sim {

/// Inherent optical properties at 650, 555 and 440 nm (red, green, blue) [1/m], as measured by
/// Williamson and Hollins (Applied Optics, 2022).
struct JerlovType {
  std::string_view name;
  Eigen::Array3d absorption;  ///< a
  Eigen::Array3d scattering;  ///< b

  /// c = a + b: how fast a beam of light fades along its way.
  Eigen::Array3d BeamAttenuation() const { return absorption + scattering; }
  /// Kd: how fast daylight fades with depth, by Kirk's formula (Limnology and Oceanography 29,
  /// 1984) for light that falls at a mean cosine of 0.85: sqrt(a^2 + (0.425 mu - 0.19) a b) / mu.
  Eigen::Array3d DiffuseAttenuation() const;
};

/// The type with this name, or nullptr. Types: IB, II, III (ocean), 1C, 3C, 5C (coast).
const JerlovType* FindJerlovType(std::string_view name);
std::vector<std::string> JerlovTypeNames();

}  // namespace drydock::sim
