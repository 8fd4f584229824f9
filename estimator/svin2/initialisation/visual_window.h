// Stereo odometry over the last few frames, without inertial help but for a first guess.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <deque>
#include <map>
#include <optional>
#include <vector>

#include "estimator/svin2/frontend/rig_ransac.h"
#include "estimator/svin2/frontend/stereo_geometry.h"
#include "estimator/svin2/frontend/tracked_frame.h"
#include "estimator/svin2/frontend/triangulation.h"
#include "estimator/svin2/initialisation/bundle_adjustment.h"

namespace drydock::svin2 {

struct VisualWindowConfig {
  int min_landmarks = 15;            ///< That a frame shares with the ones before it.
  double min_inlier_share = 0.5;     ///< Of the pixels of known landmarks.
  double max_turn_error_rad = 0.02;  ///< Between vision and gyro, from one frame to the next.
  int max_adjusted_landmarks = 80;   ///< In the bundle adjustment, the longest seen first.
  int adjustment_iterations = 5;
  TriangulationConfig stereo = {.min_parallax_rad = 0.01};  ///< 14 m from the v3 rig.
  RigRansacConfig ransac;
};

enum class FrameVerdict { kAdded, kTooFewLandmarks, kNoPose, kTurnDisagrees };

/// Where the body was, by vision alone: V is fixed, its scale is that of the rig's baseline.
struct VisualMotion {
  std::vector<Time> t;
  std::vector<Pose> T_VI;
  Eigen::MatrixXd information;  ///< As in AdjustedBundle.
  double mean_chi2 = 0.0;
};

class VisualWindow {
 public:
  VisualWindow(const StereoSheet& sheet, const VisualWindowConfig& config);

  /// `turn` is the rotation R_I,last_I,now by the gyro. A frame that is not added leaves the window
  /// as it was. Times must rise.
  FrameVerdict Add(const TrackedFrame& frame, const Eigen::Quaterniond& turn);
  void DropOldest();
  void Clear();

  bool IsEmpty() const { return frames_.empty(); }
  int Size() const { return static_cast<int>(frames_.size()); }
  const TrackedFrame& At(int k) const { return frames_[k].tracked; }

  /// Adjusts all poses and landmarks to each other. Nothing if that fails; the window is then as it
  /// was.
  std::optional<VisualMotion> Adjust();

 private:
  struct Seen {
    LandmarkId id = 0;
    int camera = 0;
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
    double sigma_px = 1.0;
  };
  struct Frame {
    TrackedFrame tracked;
    Pose T_VI;
    std::vector<Seen> seen;  ///< Of landmarks, outliers left out.
  };
  struct Landmark {
    Eigen::Vector3d p_V = Eigen::Vector3d::Zero();
    int misses = 0;  ///< How often it was an outlier.
  };
  struct StereoPoint {
    const TrackedPoint* point = nullptr;
    Eigen::Vector3d p_I = Eigen::Vector3d::Zero();
  };

  std::vector<StereoPoint> TriangulateFrame(const TrackedFrame& frame) const;
  Pose Predict(const Eigen::Quaterniond& turn) const;
  std::vector<Seen> KnownIn(const TrackedFrame& frame) const;
  std::optional<Frame> Locate(const TrackedFrame& frame, const Pose& prior);
  void AddLandmarks(Frame& frame, const std::vector<StereoPoint>& points);
  std::vector<LandmarkId> ChooseLandmarks() const;

  StereoGeometry rig_;
  VisualWindowConfig config_;
  std::deque<Frame> frames_;
  std::map<LandmarkId, Landmark> landmarks_;
};

}  // namespace drydock::svin2
