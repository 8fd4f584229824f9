#include "estimator/svin2/frontend/motion_prediction.h"

namespace drydock::svin2 {

TrackPredictor::TrackPredictor(const StereoGeometry& geometry,
                               const std::optional<MotionPrediction>& motion,
                               const LandmarkLookup& landmarks)
    : geometry_(geometry), landmarks_(landmarks), moved_(motion.has_value()) {
  if (!moved_) return;
  T_C0W_before_ = (motion->T_WI_before * geometry.T_IC(0)).Inverse();
  T_now_before_ =
      (motion->T_WI_now * geometry.T_IC(0)).Inverse() * motion->T_WI_before * geometry.T_IC(0);
}

std::optional<double> TrackPredictor::InverseDepthBefore(const FeatureTrack& track) const {
  const auto p_W = landmarks_ ? landmarks_(track.id) : std::nullopt;
  if (p_W.has_value()) {
    const double depth = (T_C0W_before_ * *p_W).z();
    if (depth > 1e-3) return 1.0 / depth;
  }
  return track.inverse_depth;
}

TrackPredictor::Point TrackPredictor::Predict(const FeatureTrack& track) const {
  const Point still{track.left, track.inverse_depth, false};
  if (!moved_) return still;
  const auto ray = geometry_.camera(0).Unproject(track.left);
  if (!ray.has_value()) return still;
  const auto inverse_depth = InverseDepthBefore(track);
  // The point times its inverse depth before: infinity is no exception.
  const Eigen::Vector3d moved =
      T_now_before_.q() * ray->homogeneous() + inverse_depth.value_or(0.0) * T_now_before_.p();
  const auto pixel = geometry_.camera(0).Project(moved);
  if (!pixel.has_value()) return still;
  Point point{*pixel, std::nullopt, inverse_depth.has_value()};
  if (inverse_depth.has_value()) point.inverse_depth = *inverse_depth / moved.z();
  return point;
}

}  // namespace drydock::svin2
