// What loop closing remembers of a keyframe.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "estimator/svin2/factors/sonar_range_factor.h"
#include "estimator/svin2/frontend/descriptor_extractor.h"
#include "estimator/svin2/frontend/tracked_frame.h"
#include "estimator/svin2/window/odometry_link.h"
#include "sensors_models/base/pose.h"
#include "sensors_models/base/time.h"

namespace drydock::svin2 {

/// A point that the front end tracked into a keyframe.
struct KeyframePoint {
  LandmarkId id = 0;
  Eigen::Vector2d left = Eigen::Vector2d::Zero();  ///< Pixel of the distorted image.
  std::optional<Eigen::Vector2d> right = std::nullopt;
  double sigma_px = 1.0;  ///< Standard deviation of each coordinate.
  Descriptor descriptor = {};
  /// The landmark [m, in the body's frame at the keyframe]: as the window estimated it, or else,
  /// for loop closing, as TriangulateByStereo has it.
  std::optional<Eigen::Vector3d> p_I = std::nullopt;
  bool by_stereo = false;  ///< Whether the keyframe's own two pixels are all that p_I rests on.

  bool IsEstimated() const { return p_I.has_value() && !by_stereo; }  ///< By the window.
};

/// By how much a point's errors are larger than those that bounds in pixels are made for: coarse
/// points are known to some pixels, and found again to some more.
inline double ErrorScale(const KeyframePoint& point) { return std::max(1.0, point.sigma_px); }

/// One sonar range that met landmarks of the keyframe.
struct KeyframePing {
  SonarRangeObservation observation;  ///< It holds no landmarks: the keyframe sees all of them.
  std::vector<std::size_t> points;    ///< Indices of the keyframe's points that made its patch.
};

struct Keyframe {
  int index = 0;
  /// A frame between keyframes, of which the index is that of the keyframe before: it looks for its
  /// place, and is not remembered.
  bool is_glimpse = false;
  Time t;
  Pose T_WI;       ///< As odometry has it.
  int map_id = 0;  ///< Of the odometry's map; poses of different maps do not compare.
  std::vector<KeyframePoint> points;  ///< Sorted by id.
  std::vector<KeyframePing> pings;
  std::optional<OdometryLink> link;  ///< Nothing at the first keyframe of a map.
  /// Of T_WI, as odometry believes: [m, rad], left perturbation, in W.
  std::optional<Eigen::Matrix<double, 6, 6>> covariance;
};

}  // namespace drydock::svin2
