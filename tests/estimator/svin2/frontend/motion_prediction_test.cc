#include "estimator/svin2/frontend/motion_prediction.h"

#include <gtest/gtest.h>

#include "tests/estimator/svin2/frontend/synthetic_dive.h"

namespace drydock::svin2 {
namespace {

const Pose kBefore(ExpSO3({0.01, 0.02, 0.3}), {1.0, 2.0, -1.0});
const Pose kNow(ExpSO3({0.03, -0.01, 0.33}), {1.05, 2.03, -0.98});

class TrackPrediction : public ::testing::Test {
 protected:
  Eigen::Vector3d InLeft(const Pose& T_WI) const {
    return (T_WI * geometry_.T_IC(0)).Inverse() * p_W_;
  }
  Eigen::Vector2d PixelAt(const Pose& T_WI) const {
    return geometry_.camera(0).Project(InLeft(T_WI)).value();
  }
  FeatureTrack TrackBefore() const {
    FeatureTrack track;
    track.id = 7;
    track.left = PixelAt(kBefore);
    return track;
  }

  StereoGeometry geometry_ = StereoGeometry(testing::HalfRig());
  Eigen::Vector3d p_W_ = kBefore * Eigen::Vector3d(2.0, 0.3, 0.2);
  std::optional<MotionPrediction> motion_ = MotionPrediction{kBefore, kNow};
  LandmarkLookup landmark_ = [this](LandmarkId id) {
    return id == 7 ? std::optional(p_W_) : std::nullopt;
  };
  LandmarkLookup nothing_;
};

TEST_F(TrackPrediction, LandmarksAndStereoGiveTheDepth) {
  FeatureTrack track = TrackBefore();
  const auto by_landmark = TrackPredictor(geometry_, motion_, landmark_).Predict(track);
  track.inverse_depth = 1.0 / InLeft(kBefore).z();
  const auto by_stereo = TrackPredictor(geometry_, motion_, nothing_).Predict(track);
  for (const auto& point : {by_landmark, by_stereo}) {
    EXPECT_LT((point.left - PixelAt(kNow)).norm(), 1e-6);
    EXPECT_NEAR(point.inverse_depth.value(), 1.0 / InLeft(kNow).z(), 1e-9);
  }
}

// 1 px off before, about 1 px off now: where a landmark is across the line of sight is no motion.
TEST_F(TrackPrediction, StartsFromThePixelNotFromTheLandmark) {
  FeatureTrack track = TrackBefore();
  track.left.x() += 1.0;
  const auto point = TrackPredictor(geometry_, motion_, landmark_).Predict(track);
  EXPECT_NEAR((point.left - PixelAt(kNow)).norm(), 1.0, 0.1);
}

TEST_F(TrackPrediction, WithoutADepthThePointIsFarAway) {
  const FeatureTrack track = TrackBefore();
  const auto point = TrackPredictor(geometry_, motion_, nothing_).Predict(track);
  EXPECT_FALSE(point.inverse_depth.has_value());
  // The direction before, in the camera now.
  const Eigen::Vector3d direction = (kNow * geometry_.T_IC(0)).q().conjugate() *
                                    ((kBefore * geometry_.T_IC(0)).q() * InLeft(kBefore));
  EXPECT_LT((point.left - geometry_.camera(0).Project(direction).value()).norm(), 1e-6);
}

TEST_F(TrackPrediction, WithoutAMotionThePointStays) {
  FeatureTrack track = TrackBefore();
  track.inverse_depth = 0.5;
  const auto point = TrackPredictor(geometry_, std::nullopt, landmark_).Predict(track);
  EXPECT_EQ(point.left, track.left);
  EXPECT_EQ(point.inverse_depth, 0.5);
}

}  // namespace
}  // namespace drydock::svin2
