// A stereo rig without any peculiarity but its lens.
#pragma once

#include <Eigen/Geometry>

#include "sensors_models/measurement/rig.h"

namespace drydock::svin2::testing {

/// A rig like the v3: 800 x 600 px, 14 cm apart, looking ahead.
inline StereoSheet SyntheticStereo() {
  StereoSheet sheet;
  sheet.rate_hz = 15.0;
  Eigen::Matrix3d R_IC;
  R_IC << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  for (std::size_t k = 0; k < 2; ++k) {
    CameraIntrinsics& camera = sheet.cameras[k];
    camera.width = 800;
    camera.height = 600;
    camera.fx = camera.fy = 575.0;
    camera.cx = 400.0;
    camera.cy = 300.0;
    camera.distortion = {-0.16, 0.102, 0.001, -0.002};
    sheet.T_IC[k] = Pose(Eigen::Quaterniond(R_IC), {0.04, k == 0 ? 0.071 : -0.071, -0.005});
  }
  return sheet;
}

}  // namespace drydock::svin2::testing
