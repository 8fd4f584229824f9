#include "sensors_models/models/pressure_model.h"

namespace drydock {

double DepthBelowSurface(const Pose& T_WI, const Eigen::Vector3d& p_ID, double surface_z) {
  return surface_z - (T_WI * p_ID).z();
}

}  // namespace drydock
