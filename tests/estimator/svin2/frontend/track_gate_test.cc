#include "estimator/svin2/frontend/track_gate.h"

#include <gtest/gtest.h>

#include "tests/estimator/svin2/frontend/synthetic_dive.h"

namespace drydock::svin2 {
namespace {

const Pose kBefore(Eigen::Quaterniond::Identity(), {0.0, 0.0, 0.0});
const Pose kNow(ExpSO3({0.0, 0.01, 0.02}), {0.02, 0.05, 0.0});

// Twenty points at depths from 2 to 5 m, without flaw.
class Gate : public ::testing::Test {
 protected:
  Gate() {
    for (int i = 0; i < 20; ++i) {
      const Eigen::Vector3d p_W(2.0 + 0.15 * i, 0.8 - 0.4 * (i % 5), 0.5 - 0.3 * (i % 4));
      points_W_.push_back(p_W);
      FeatureTrack track;
      track.id = i;
      track.left_before = Pixel(kBefore, 0, p_W);
      track.left = Pixel(kNow, 0, p_W);
      track.right = Pixel(kNow, 1, p_W);
      tracks_.push_back(track);
    }
  }
  Eigen::Vector2d Pixel(const Pose& T_WI, int camera, const Eigen::Vector3d& p_W) const {
    return geometry_.camera(camera)
        .Project((T_WI * geometry_.T_IC(camera)).Inverse() * p_W)
        .value();
  }
  TrackGate::Verdict Judge(const std::optional<MotionPrediction>& motion,
                           const LandmarkLookup& landmarks) const {
    return TrackGate({}).Judge(geometry_, tracks_, motion, landmarks, 1);
  }

  StereoGeometry geometry_ = StereoGeometry(testing::HalfRig());
  std::vector<Eigen::Vector3d> points_W_;
  std::vector<FeatureTrack> tracks_;
  LandmarkLookup all_ = [this](LandmarkId id) { return std::optional(points_W_[id]); };
};

TEST_F(Gate, LandmarksTellWhichCameraIsWrong) {
  tracks_[3].left.x() += 6.0;
  *tracks_[5].right += Eigen::Vector2d(0.0, 5.0);
  const auto verdict = Judge(std::nullopt, all_);
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    EXPECT_EQ(verdict.left[i], i != 3) << i;
    EXPECT_EQ(verdict.right[i], i != 5) << i;
  }
  EXPECT_LT(verdict.T_WI.value().BoxMinus(kNow).norm(), 1e-3);
}

// Pixels of an octave are larger, and so are errors there.
TEST_F(Gate, CoarsePointsMayErrByMore) {
  tracks_[3].left.x() += 6.0;
  tracks_[3].octave = 2;
  *tracks_[5].right += Eigen::Vector2d(0.0, 15.0);
  tracks_[5].octave = 2;
  const auto verdict = Judge(std::nullopt, all_);
  EXPECT_TRUE(verdict.left[3]);
  EXPECT_FALSE(verdict.right[5]);
}

TEST_F(Gate, WithoutLandmarksTheEpipolarLineDecides) {
  // The body moved to its left, so that lines run nearly along rows: 4 px down are off, 4 px along
  // are another depth.
  tracks_[3].left.y() += 4.0;
  tracks_[4].left.x() += 4.0;
  const auto verdict = Judge(MotionPrediction{kBefore, kNow}, nullptr);
  for (std::size_t i = 0; i < tracks_.size(); ++i) EXPECT_EQ(verdict.left[i], i != 3) << i;
  EXPECT_FALSE(verdict.T_WI.has_value());
}

TEST_F(Gate, WithNothingToGoByEveryTrackPasses) {
  tracks_[3].left.y() += 50.0;
  for (const auto& motion :
       {std::optional<MotionPrediction>(), std::optional(MotionPrediction{kNow, kNow})}) {
    const auto verdict = Judge(motion, nullptr);
    EXPECT_EQ(verdict.left, std::vector<bool>(20, true));
    EXPECT_EQ(verdict.right, std::vector<bool>(20, true));
  }
}

}  // namespace
}  // namespace drydock::svin2
