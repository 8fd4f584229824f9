// Small scenes with known geometry.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

namespace drydock::testing {

/// Writes an MJCF file with the given elements inside <worldbody> and, beside those for markers,
/// inside <asset>, and returns its path.
std::filesystem::path WriteScene(const std::filesystem::path& folder, const std::string& worldbody,
                                 const std::string& assets = "");

/// A square that faces along `normal`, white in the middle and fading to black at its edges: its
/// image's centre of brightness is found to a few hundredths of a pixel.
std::string MarkerElement(const Eigen::Vector3d& centre, const Eigen::Vector3d& normal,
                          double half_size);
/// An asset: a ball around the origin, of triangles so small that it is round to 1e-4 of its
/// radius.
std::string BallMesh(const std::string& name, double radius);
/// An asset: a drum around z from -half_height to half_height, as round as the ball.
std::string DrumMesh(const std::string& name, double radius, double half_height);
/// A mesh on a body of the same name, at `position`.
std::string MeshElement(const std::string& name, const Eigen::Vector3d& position);

/// A white box on the body `name`, turned by yaw [degrees] about z.
std::string BoxElement(const std::string& name, const Eigen::Vector3d& centre,
                       const Eigen::Vector3d& half_size, double yaw_deg = 0.0);

}  // namespace drydock::testing
