// The geometry of a stereo pair, and matches found by it.
#include <Eigen/LU>
#include <cmath>

#include <gtest/gtest.h>

#include "estimator/svin2/frontend/stereo_geometry.h"
#include "estimator/svin2/frontend/stereo_matcher.h"
#include "sensors_models/base/check.h"
#include "tests/estimator/svin2/frontend/synthetic_dive.h"
#include "tests/estimator/svin2/frontend/synthetic_images.h"

namespace drydock::svin2 {
namespace {

using testing::Draw;
using testing::HalfRig;
using testing::Texture;

TEST(StereoGeometry, PointsLieOnTheirEpipolarLines) {
  const StereoGeometry geometry(HalfRig());
  for (const Eigen::Vector3d& p_I :
       {Eigen::Vector3d(2.0, 0.3, 0.2), Eigen::Vector3d(1.0, -0.4, 0.3),
        Eigen::Vector3d(8.0, 3.0, -2.0)}) {
    const auto left = geometry.camera(0).Project(geometry.T_IC(0).Inverse() * p_I).value();
    const auto right = geometry.camera(1).Project(geometry.T_IC(1).Inverse() * p_I).value();
    EXPECT_LT(geometry.EpipolarDistance(left, right).value(), 1e-9);
    // The cameras lie side by side, so that lines run along rows: 2 px down are about 2 px off
    // (distortion changes that by some %).
    EXPECT_NEAR(geometry.EpipolarDistance(left, right + Eigen::Vector2d(0.0, 2.0)).value(), 2.0,
                0.2);
    // Its depth in the left camera leads to the same pixel in the right.
    const double z = (geometry.T_IC(0).Inverse() * p_I).z();
    EXPECT_LT((geometry.Transfer(left, 1.0 / z).value() - right).norm(), 1e-6);
  }
}

// A fisheye's lines are curves; about a point they are straight, and 2 px across one are 2 px, also
// 60 degrees off the axis, where z = 1 is stretched fourfold.
TEST(StereoGeometry, EpipolarDistancesOfAFisheyeArePixels) {
  StereoSheet sheet = HalfRig();
  for (CameraIntrinsics& camera : sheet.cameras) {
    camera.lens = LensModel::kEquidistant;
    camera.distortion = {-0.013, 0.021, -0.012, 0.0024};
  }
  const StereoGeometry geometry(sheet);
  for (const Eigen::Vector3d& p_I :
       {Eigen::Vector3d(2.0, 0.3, 0.2), Eigen::Vector3d(1.0, -1.7, 0.3),
        Eigen::Vector3d(1.0, 1.2, -1.2)}) {
    const auto left = geometry.camera(0).Project(geometry.T_IC(0).Inverse() * p_I).value();
    const auto right = geometry.camera(1).Project(geometry.T_IC(1).Inverse() * p_I).value();
    EXPECT_LT(geometry.EpipolarDistance(left, right).value(), 1e-9);
    // Along the curve, by a slightly different depth.
    const double z = (geometry.T_IC(0).Inverse() * p_I).z();
    const Eigen::Vector2d along = (geometry.Transfer(left, 1.001 / z).value() - right).normalized();
    const Eigen::Vector2d across(-along.y(), along.x());
    EXPECT_NEAR(geometry.EpipolarDistance(left, right + 2.0 * across).value(), 2.0, 0.1);
  }
}

TEST(StereoGeometry, HasNoLineThroughTheOtherCamera) {
  const StereoSheet sheet = HalfRig();
  const CameraModel camera(sheet.cameras[0]);
  // Moved along the axis: the principal point sees the other camera.
  const Pose ahead(Eigen::Quaterniond::Identity(), {0.0, 0.0, 0.5});
  const Eigen::Vector2d principal(sheet.cameras[0].cx, sheet.cameras[0].cy);
  EXPECT_FALSE(EpipolarDistance(camera, principal, camera, {100.0, 100.0}, ahead).has_value());
  EXPECT_TRUE(EpipolarDistance(camera, {20.0, 30.0}, camera, {25.0, 35.0}, ahead).has_value());
}

// Two views of a wall at x = `distance` in I, across the axes.
class Wall {
 public:
  explicit Wall(double distance) : distance_(distance) {}

  // What camera `index` sees; the texture's waves are 8 to 40 px long from the left camera.
  cv::Mat View(const StereoGeometry& geometry, int index) const {
    const Texture texture(31);
    return Draw(
        400, 300,
        [&](const Eigen::Vector2d& pixel) {
          const auto point = PointAt(geometry, index, pixel);
          return 120.0 + 30.0 * texture(288.0 / distance_ * Eigen::Vector2d(point.y(), point.z()));
        },
        1.0, index + 1);
  }

  Eigen::Vector3d PointAt(const StereoGeometry& geometry, int index,
                          const Eigen::Vector2d& pixel) const {
    const Pose& T_IC = geometry.T_IC(index);
    const Eigen::Vector3d ray =
        T_IC.q() * geometry.camera(index).Unproject(pixel).value().homogeneous();
    return T_IC.p() + (distance_ - T_IC.p().x()) / ray.x() * ray;
  }

 private:
  double distance_;
};

TEST(StereoGeometry, InverseDepthUndoesTransfer) {
  const StereoGeometry geometry(HalfRig());
  const Eigen::Vector2d left(230.0, 120.0);
  for (const double inverse_depth : {0.0, 0.1, 1.0, 2.5}) {
    const auto right = geometry.Transfer(left, inverse_depth).value();
    EXPECT_NEAR(geometry.InverseDepth(left, right).value(), inverse_depth, 1e-6);
  }
}

struct StereoCase {
  double distance_m;
  int octave;
};

class StereoMatches : public ::testing::TestWithParam<StereoCase> {};

TEST_P(StereoMatches, FindsTheOtherPixelWithoutKnowingTheDepth) {
  const StereoGeometry geometry(HalfRig());
  const Wall wall(GetParam().distance_m);
  // At 0.7 m the two views differ by more than a shift.
  const PatchTracker tracker({.affine = true});
  const auto left = tracker.MakePyramid(wall.View(geometry, 0));
  const auto right = tracker.MakePyramid(wall.View(geometry, 1));
  std::vector<SoughtInRight> points;
  for (int y = 40; y < 270; y += 40) {
    for (int x = 120; x < 370; x += 40)
      points.push_back({Eigen::Vector2d(x, y), std::nullopt, GetParam().octave});
  }
  const StereoMatcher matcher({}, geometry, tracker);
  const auto tracks = matcher.Match(left, right, points);
  std::size_t found = 0;
  double squares = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!tracks[i].IsTracked()) continue;
    ++found;
    const Eigen::Vector3d p_I = wall.PointAt(geometry, 0, points[i].left);
    const auto truth = geometry.camera(1).Project(geometry.T_IC(1).Inverse() * p_I).value();
    squares += (tracks[i].pixel - truth).squaredNorm();
  }
  EXPECT_GE(found, points.size() * 9 / 10);
  EXPECT_LT(std::sqrt(squares / static_cast<double>(found)), 0.1 * OctaveScale(GetParam().octave));
}

INSTANTIATE_TEST_SUITE_P(Distances, StereoMatches,
                         ::testing::Values(StereoCase{0.7, 0}, StereoCase{2.0, 0},
                                           StereoCase{20.0, 0}, StereoCase{2.0, 1},
                                           StereoCase{20.0, 1}));

// The right camera has been knocked: what it sees no longer lies where the calibration says.
TEST(StereoMatcher, RejectsWhatLiesOffTheLine) {
  const StereoGeometry geometry(HalfRig());
  StereoSheet knocked_sheet = HalfRig();
  knocked_sheet.T_IC[1] = Pose(ExpSO3({0.0, 0.015, 0.0}) * knocked_sheet.T_IC[1].q(),
                               knocked_sheet.T_IC[1].p());  // Pitched: 4 px up or down.
  const StereoGeometry knocked(knocked_sheet);
  const Wall wall(2.0);
  const PatchTracker tracker({});
  const StereoMatcher matcher({}, geometry, tracker);
  const std::vector<SoughtInRight> points = {
      {{150.0, 100.0}, 0.5, 0}, {{200.0, 150.0}, 0.5, 0}, {{250.0, 200.0}, std::nullopt, 0}};
  const auto tracks = matcher.Match(tracker.MakePyramid(wall.View(geometry, 0)),
                                    tracker.MakePyramid(wall.View(knocked, 1)), points);
  for (const PatchTrack& track : tracks) EXPECT_EQ(track.status, TrackStatus::kOffEpipolar);
}

TEST(StereoMatcher, RefusesBadConfigurations) {
  EXPECT_THROW(StereoMatcher({.min_depth_m = 0.0}, StereoGeometry(HalfRig()), PatchTracker({})),
               InputError);
}

}  // namespace
}  // namespace drydock::svin2
