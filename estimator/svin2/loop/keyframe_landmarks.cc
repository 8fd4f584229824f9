#include "estimator/svin2/loop/keyframe_landmarks.h"

#include "estimator/svin2/frontend/triangulation.h"

namespace drydock::svin2 {

std::vector<std::optional<Eigen::Vector3d>> LandmarksOf(const StereoGeometry& rig,
                                                        const Keyframe& keyframe) {
  std::vector<std::optional<Eigen::Vector3d>> landmarks;
  landmarks.reserve(keyframe.points.size());
  for (const KeyframePoint& point : keyframe.points) {
    landmarks.push_back(point.p_I);
    if (point.p_I.has_value() || !point.right.has_value()) continue;
    const Triangulation found =
        Triangulate({{&rig.camera(0), rig.T_IC(0), point.left, point.sigma_px},
                     {&rig.camera(1), rig.T_IC(1), *point.right, point.sigma_px}});
    if (found.IsGood()) landmarks.back() = found.p_W;
  }
  return landmarks;
}

std::optional<Eigen::Vector2d> PixelInLeft(const StereoGeometry& rig, const Eigen::Vector3d& p_I) {
  const auto pixel = rig.camera(0).Project(rig.T_IC(0).Inverse() * p_I);
  if (!pixel.has_value() || !rig.camera(0).IsInside(*pixel)) return std::nullopt;
  return pixel;
}

}  // namespace drydock::svin2
