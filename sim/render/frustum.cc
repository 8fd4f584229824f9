#include "sim/render/frustum.h"

namespace drydock::sim {

BoxCorners CornersOfBox(const Eigen::Vector3d& centre, const Eigen::Matrix3d& R,
                        const Eigen::Vector3d& half_sizes) {
  BoxCorners corners;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d signs((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1,
                                (i & 4) != 0 ? 1 : -1);
    corners.col(i) = centre + R * half_sizes.cwiseProduct(signs);
  }
  return corners;
}

Frustum::Frustum(const Pose& T_WC, const Pinhole& pinhole, double near, double far)
    : T_CW_(T_WC.Inverse()), near_(near), far_(far) {
  // A face holds the points with x / z equal to the slope of the image's edge, half a pixel outside
  // the outermost pixel centres.
  const double left = (-0.5 - pinhole.cx) / pinhole.focal;
  const double right = (pinhole.width - 0.5 - pinhole.cx) / pinhole.focal;
  const double top = (-0.5 - pinhole.cy) / pinhole.focal;
  const double bottom = (pinhole.height - 0.5 - pinhole.cy) / pinhole.focal;
  sides_ << 1, 0, -left, -1, 0, right, 0, 1, -top, 0, -1, bottom;
}

std::optional<double> Frustum::FarthestDepth(const BoxCorners& box) const {
  const BoxCorners corners_C = (T_CW_.R() * box).colwise() + T_CW_.p();
  const double farthest = corners_C.row(2).maxCoeff();
  if (farthest < near_ || corners_C.row(2).minCoeff() > far_) return std::nullopt;
  if (((sides_ * corners_C).rowwise().maxCoeff().array() < 0).any()) return std::nullopt;
  return farthest;
}

}  // namespace drydock::sim
