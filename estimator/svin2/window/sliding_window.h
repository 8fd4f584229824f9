// The states that are being estimated: some keyframes, the most recent frames, and the landmarks
// that they see (paper, "Tightly-coupled non-linear optimisation").
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "estimator/interface/estimator.h"
#include "estimator/svin2/factors/depth_factor.h"
#include "estimator/svin2/factors/prior_factors.h"
#include "estimator/svin2/factors/sonar_range_factor.h"
#include "estimator/svin2/frontend/stereo_geometry.h"
#include "estimator/svin2/frontend/tracked_frame.h"
#include "estimator/svin2/frontend/triangulation.h"
#include "estimator/svin2/graph/factor_graph.h"
#include "estimator/svin2/preintegration/imu_preintegration.h"
#include "estimator/svin2/window/odometry_link.h"
#include "estimator/svin2/window/propagate.h"

namespace drydock::svin2 {

struct WindowConfig {
  int keyframes = 5;      ///< Beside the recent frames.
  int recent_frames = 3;  ///< With velocity and biases.
  /// In view; fewer say too little of a frame. Where the latest sees fewer, those before it stay as
  /// keyframes do: place and speed at the last sight are what inertia goes on from. They are no
  /// keyframes to others.
  int min_landmarks = 6;
  SolverLimits solver;
  double cauchy_scale = 1.0;            ///< Of the robust loss of keypoints and ranges, in sigmas.
  double max_reprojection_chi2 = 16.0;  ///< An observation worse than this is taken away.
  TriangulationConfig triangulation;
};

/// How well the first state is known.
struct StartSigmas {
  double position = 1e-4;      ///< [m]: defines W, whose height is no pressure sensor's.
  double yaw = 1e-4;           ///< [rad]: defines W.
  double roll_pitch = 0.02;    ///< [rad]
  SpeedBiasSigmas speed_bias;  ///< Of velocity and biases.
};

/// Keeps the factor graph of a sliding window. Frames come in order of time.
class SlidingWindow {
 public:
  SlidingWindow(const WindowConfig& config, const StereoGeometry& geometry);

  /// Begins with one state and what its frame saw. `expected_bias`: where the prior holds the
  /// biases, if not at the state's: a state that was found from this and the next frames must not
  /// count for a prior, for the window sees those frames too.
  void Start(const NavState& state, const StartSigmas& sigmas, const TrackedFrame& seen,
             const std::optional<ImuBias>& expected_bias = std::nullopt);
  bool IsStarted() const { return !frames_.empty(); }

  /// Adds the next frame, which `imu` links to the last one, at the state that the IMU predicts.
  void AddFrame(const TrackedFrame& seen, const ImuPreintegration& imu);
  /// Ties a pressure reading that was true at `t`, while the body turned at `rate_I` [rad/s, in I],
  /// to the frame nearest to it. From there the body is taken to rise evenly, which a longer way
  /// makes less sure: observation.sigma is of the reading alone. The first one finds the surface.
  void AddDepth(Time t, DepthObservation observation,
                const Eigen::Vector3d& rate_I = Eigen::Vector3d::Zero());
  /// Height at which the pressure sensor would read 0 [m, in W]; nothing before the first reading.
  std::optional<double> SurfaceHeight() const;
  /// The next reading finds the surface anew. What the readings so far tied to it is left with a
  /// height of its own, which is nobody's any more and so says nothing of the body's.
  void ForgetSurface() { surface_.reset(); }

  /// Expects the latest frame to move with `v_I` [m/s, in I], each component to `sigma` [m/s].
  void AddVelocity(const Eigen::Vector3d& v_I, double sigma);

  /// Ties a ping to the latest frame. Its patch: `estimated` landmarks, which the window has, and
  /// `departed` ones [m, in W], which are held at the window's oldest frame. Where a landmark or
  /// one of the two frames leaves, what is left of the patch is held there too.
  void AddSonar(SonarRangeObservation observation, std::vector<LandmarkId> estimated,
                std::span<const Eigen::Vector3d> departed);

  /// Moves all states to where measurements agree best, and takes away observations that do not.
  SolverReport Optimise();
  /// Marginalises what is beyond the window's size.
  void Slide();

  NavState Latest() const;
  std::optional<Eigen::Matrix<double, 6, 6>> LatestCovariance() const;
  /// The latest frame as the newest keyframe before it has it; nothing where there is none.
  std::optional<OdometryLink> LinkToKeyframe() const;
  std::optional<Eigen::Vector3d> LandmarkPosition(LandmarkId id) const;
  std::vector<Eigen::Vector3d> LandmarkPositions() const;
  /// Calls `visit` with id and position [m, in W] of each landmark.
  template <typename Visit>
  void ForEachLandmark(Visit visit) const {
    for (const auto& [id, point] : points_)
      if (point.landmark) visit(id, PositionOf(point));
  }
  /// The last positions [m, in W] of the landmarks that left since the last call.
  std::vector<Eigen::Vector3d> TakeDeparted();
  int NumFrames() const { return static_cast<int>(frames_.size()); }
  /// Landmarks that the latest frame sees.
  int LandmarksInView() const;
  bool SeesEnough() const { return LandmarksInView() >= config_.min_landmarks; }

 private:
  struct ImuLink {
    FactorId factor;
    ImuPreintegration preintegration;
  };
  struct Frame {
    std::int64_t index = 0;
    Time t;
    bool is_keyframe = false;
    BlockId pose{};
    std::optional<BlockId> speed_bias;
    std::optional<ImuLink> imu;  // From the frame before.
  };
  struct Observation {
    std::int64_t frame = 0;
    int camera = 0;
    Eigen::Vector2d pixel;
    double sigma_px = 1.0;
    std::optional<FactorId> factor;  // Where the point is a landmark.
  };
  struct Point {
    std::optional<BlockId> landmark;  // Nothing until it can be triangulated.
    std::vector<Observation> observations;
  };

  struct Ping {
    std::int64_t frame = 0;
    std::int64_t anchor = 0;  // A frame before that.
    SonarRangeObservation observation;
    std::vector<LandmarkId> estimated;
    FactorId factor{};
  };

  Frame& AddState(const NavState& state, const TrackedFrame& seen);
  void AddObservations(const Frame& frame, const TrackedFrame& seen);
  void TriangulateNewLandmarks();
  void AddReprojection(Point& point, Observation& observation);
  int LandmarksSeenBy(const Frame& frame) const;
  /// Whether what a frame saw must not be forgotten with it, for the latest frame sees too little.
  bool IsLastSight(const Frame& frame) const;
  void Link(const Frame& before, Frame& frame, const ImuPreintegration& imu);
  void RenewImuFactors();
  void RejectOutliers();
  void DropObservations(std::int64_t frame);
  void DropUnseenPoints();
  void MarginaliseKeyframe(const Frame& frame);
  void Depart(LandmarkId id, const Point& point);
  FactorId AddFactorOf(const Ping& ping);
  void Hold(Ping& ping, const Eigen::Vector3d& p_W) const;
  void HoldLandmarks(Ping& ping, const std::function<bool(LandmarkId)>& which);
  void HoldPingsOf(std::int64_t frame);
  Eigen::Vector3d PositionOf(const Point& point) const;
  const Frame& FrameAt(std::int64_t index) const;
  const Frame& NearestMoving(Time t) const;
  int NumRecent() const;
  NavState StateOf(const Frame& frame) const;

  WindowConfig config_;
  StereoGeometry geometry_;
  FactorGraph graph_;
  std::deque<Frame> frames_;  // The oldest first.
  std::optional<BlockId> surface_;
  std::map<LandmarkId, Point> points_;
  std::vector<Ping> pings_;
  std::vector<Eigen::Vector3d> departed_;
  std::int64_t next_index_ = 0;
};

}  // namespace drydock::svin2
