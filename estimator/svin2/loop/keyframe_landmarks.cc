#include "estimator/svin2/loop/keyframe_landmarks.h"

#include "estimator/svin2/frontend/triangulation.h"

namespace drydock::svin2 {

void TriangulateByStereo(const StereoGeometry& rig, Keyframe& keyframe) {
  for (KeyframePoint& point : keyframe.points) {
    if (point.p_I.has_value() || !point.right.has_value()) continue;
    const Triangulation found =
        Triangulate({{&rig.camera(0), rig.T_IC(0), point.left, point.sigma_px},
                     {&rig.camera(1), rig.T_IC(1), *point.right, point.sigma_px}});
    if (!found.IsGood()) continue;
    point.p_I = found.p_W;
    point.by_stereo = true;
  }
}

std::optional<Eigen::Vector2d> PixelInLeft(const StereoGeometry& rig, const Eigen::Vector3d& p_I) {
  const auto pixel = rig.camera(0).Project(rig.T_IC(0).Inverse() * p_I);
  if (!pixel.has_value() || !rig.camera(0).IsInside(*pixel)) return std::nullopt;
  return pixel;
}

}  // namespace drydock::svin2
