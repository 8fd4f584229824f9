// A camera in air behind a flat window: refraction that no calibration of a pinhole takes away.
#pragma once

#include <Eigen/Core>

#include "sensors_models/base/yaml_reader.h"

namespace drydock::sim {

struct FlatPortConfig {
  bool enabled = false;
  double distance_m = 0.03;   ///< From the centre of projection to the window [m].
  double thickness_m = 0.01;  ///< Of the glass.
  double glass_index = 1.5;
  double water_index = 1.333;
  /// From the centre of projection to where the rig's sheet was calibrated, under water.
  double calibration_distance_m = 2.0;
};

/// Reads the `flat_port` mapping of a scenario's stereo camera, which is enabled unless it says
/// otherwise.
FlatPortConfig ReadFlatPort(YamlReader& yaml);

/// Rays bend where they pass from air into glass and from there into water. With a, g and w the
/// angles off the axis, to which the window is perpendicular, sin a = n_g sin g = n_w sin w
/// (Snell), and the ray that leaves the camera at a has come at depth z to the radius
///   r = d tan a + t tan g + (z - d - t) tan w,
/// so that it sees, in the plane z = 1,
///   r / z = tan w + b / z,   b = d (tan a - tan w) + t (tan g - tan w).
/// Each angle seems to come from a point of its own of the axis (an axial camera: Agrawal,
/// Ramalingam, Taguchi and Chari 2012): a pinhole, whatever its distortion, is right at a single
/// distance.
///
/// That is the one at which the rig's sheet was found, z_c. What the sheet says of a pixel holds
/// for the point of its ray there; from that everything else on the ray follows exactly.
class FlatPort {
 public:
  explicit FlatPort(const FlatPortConfig& config);

  /// How the point moves, in the plane z = 1, that is seen through a pixel, by its inverse depth
  /// [m]: it is `calibrated` + (1/z - 1/z_c) ByInverseDepth(calibrated), where `calibrated` is what
  /// the sheet has the pixel look along.
  Eigen::Vector2d ByInverseDepth(const Eigen::Vector2d& calibrated) const;

  /// The other way round: along what the sheet has that pixel look through which a point is seen
  /// that lies at `ideal` in the plane z = 1 and at 1 / `inverse_depth` [1/m]. That is, the image
  /// of p is where the sheet projects Calibrated(p / z, 1 / z).
  Eigen::Vector2d Calibrated(const Eigen::Vector2d& ideal, double inverse_depth) const;

  double calibrated_inverse_depth() const { return 1.0 / config_.calibration_distance_m; }
  /// Of the nearest thing there can be: 0.3 m.
  static constexpr double largest_inverse_depth() { return 1.0 / 0.3; }
  /// Tangent of the largest angle off the axis under water, 46.6 degrees; total reflection ends the
  /// view at 48.6 of a camera that touches the window.
  double widest() const;

 private:
  /// tan w and b of the ray at tan a.
  struct Ray {
    double tangent;
    double by_inverse_depth;
  };
  Ray RayAt(double air_tangent) const;
  /// tan a of the ray that sees, at an inverse depth, the radius `ideal` in the plane z = 1.
  double AirTangent(double ideal, double inverse_depth) const;

  FlatPortConfig config_;
};

}  // namespace drydock::sim
