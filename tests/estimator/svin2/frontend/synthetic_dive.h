// A rig that moves in front of a textured wall, for tests of the visual front end.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "estimator/svin2/frontend/stereo_geometry.h"
#include "sensors_models/measurement/measurement.h"
#include "tests/estimator/svin2/frontend/synthetic_images.h"

namespace drydock::svin2::testing {

/// Half the v3 rig: distorted lenses that are not quite parallel, 0.14 m apart.
inline StereoSheet HalfRig() {
  StereoSheet sheet;
  for (int i = 0; i < 2; ++i) {
    sheet.cameras[i] = {.width = 400,
                        .height = 300,
                        .fx = 288.0 + i,
                        .fy = 287.0,
                        .cx = 199.0 + i,
                        .cy = 144.5,
                        .distortion = {-0.16, 0.10, 1e-3, -5e-4}};
  }
  const Eigen::Quaterniond looking(0.5, -0.5, 0.5, -0.5);
  sheet.T_IC[0] = Pose(looking, {0.04, 0.08, -0.005});
  sheet.T_IC[1] = Pose(ExpSO3({0.01, -0.005, 0.02}) * looking, {0.039, -0.06, -0.007});
  return sheet;
}

/// The wall fills the plane x = distance of W; the rig looks along x.
class WallDive {
 public:
  explicit WallDive(double distance_m = 2.5, std::uint64_t seed = 31)
      : geometry_(HalfRig()), texture_(seed), distance_(distance_m) {}

  const StereoGeometry& geometry() const { return geometry_; }

  /// What both cameras see from a pose of the body; with white noise of one grey level.
  StereoFrame See(const Pose& T_WI) const {
    StereoFrame frame;
    for (int camera = 0; camera < 2; ++camera) {
      frame.images[camera] = Draw(
          400, 300,
          [&](const Eigen::Vector2d& pixel) {
            const Eigen::Vector3d p_W = PointAt(T_WI, camera, pixel);
            return 120.0 + 30.0 * texture_(288.0 / distance_ * p_W.tail<2>());
          },
          1.0, camera + 1);
    }
    return frame;
  }

  /// Where on the wall a pixel looks [m, in W].
  Eigen::Vector3d PointAt(const Pose& T_WI, int camera, const Eigen::Vector2d& pixel) const {
    const Pose T_WC = T_WI * geometry_.T_IC(camera);
    const Eigen::Vector3d ray =
        T_WC.q() * geometry_.camera(camera).Unproject(pixel).value().homogeneous();
    return T_WC.p() + (distance_ - T_WC.p().x()) / ray.x() * ray;
  }

  /// Where a point of W is seen.
  std::optional<Eigen::Vector2d> PixelOf(const Pose& T_WI, int camera,
                                         const Eigen::Vector3d& p_W) const {
    return geometry_.camera(camera).Project((T_WI * geometry_.T_IC(camera)).Inverse() * p_W);
  }

 private:
  StereoGeometry geometry_;
  Texture texture_;
  double distance_;
};

}  // namespace drydock::svin2::testing
