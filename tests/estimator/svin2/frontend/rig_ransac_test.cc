#include "estimator/svin2/frontend/rig_ransac.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "sensors_models/base/random_stream.h"

namespace drydock::svin2 {
namespace {

/// Two eyes of one kind, mounted as SVIn2's are.
StereoGeometry RigOf(const CameraIntrinsics& camera) {
  StereoSheet sheet;
  for (int i = 0; i < 2; ++i) {
    sheet.cameras[i] = camera;
    sheet.T_IC[i] =
        Pose(Eigen::Quaterniond(0.5, -0.5, 0.5, -0.5), {0.04, i == 0 ? 0.084 : -0.059, 0.0});
  }
  return StereoGeometry(sheet);
}

StereoGeometry Rig() {
  return RigOf({.width = 800,
                .height = 600,
                .fx = 575.0,
                .fy = 574.0,
                .cx = 399.0,
                .cy = 289.0,
                .distortion = {-0.16, 0.10, 0.0, 0.0}});
}

/// Fisheyes, whose corners look 66 degrees aside.
StereoGeometry WideRig() {
  return RigOf({.width = 800,
                .height = 600,
                .fx = 430.0,
                .fy = 431.0,
                .cx = 399.0,
                .cy = 289.0,
                .distortion = {-0.013, 0.021, -0.012, 0.0024},
                .lens = LensModel::kEquidistant});
}

struct Scene {
  Pose T_WI;
  std::vector<LandmarkObservation> observations;
  std::vector<std::size_t> right_ones;  // Indices of those that are not outliers.
};

// 60 landmarks 1 to 6 m ahead, each seen by one camera to 0.5 px; of these `outliers` are seen
// anywhere in the image instead.
Scene MakeScene(const StereoGeometry& rig, std::uint64_t seed, double outliers,
                double spread = 1.0) {
  RandomStream random(seed, "scene");
  Scene scene;
  scene.T_WI = Pose(FromYawPitchRoll(random.Uniform(-3.0, 3.0), random.Uniform(-0.5, 0.5), 0.1),
                    {random.Uniform(-5.0, 5.0), 2.0, -1.0});
  while (scene.observations.size() < 60) {
    const double x = random.Uniform(1.0, 6.0);
    const Eigen::Vector3d p_I(x, x * random.Uniform(-0.6 * spread, 0.6 * spread),
                              x * random.Uniform(-0.45 * spread, 0.45 * spread));
    const int camera = random.Uniform() < 0.5 ? 0 : 1;
    auto pixel = rig.camera(camera).Project(rig.T_IC(camera).Inverse() * p_I);
    if (!pixel.has_value() || !rig.camera(camera).IsInside(*pixel)) continue;
    *pixel += 0.5 * Eigen::Vector2d(random.Gaussian(), random.Gaussian());
    if (random.Uniform() < outliers) {
      *pixel = Eigen::Vector2d(random.Uniform(0.0, 800.0), random.Uniform(0.0, 600.0));
    } else {
      scene.right_ones.push_back(scene.observations.size());
    }
    scene.observations.push_back({scene.T_WI * p_I, camera, *pixel});
  }
  return scene;
}

// With some 36 good observations of sigma 0.5 px at 575 px and 3 m, orientation is known to about
// 0.5 / 575 / sqrt(36) = 1.5e-4 rad and position to some 3 m times that; five to ten times as much
// is allowed, since turning and moving look alike.
TEST(RigRansac, FindsThePoseWith40PercentOutliersForEverySeed) {
  const StereoGeometry rig = Rig();
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const Scene scene = MakeScene(rig, seed, 0.4);
    const auto found = EstimateRigPose(rig, scene.observations, std::nullopt, seed);
    ASSERT_TRUE(found.has_value()) << seed;
    const Vector6d error = found->T_WI.BoxMinus(scene.T_WI);
    EXPECT_LT(error.head<3>().norm(), 0.01) << seed;
    EXPECT_LT(error.tail<3>().norm(), 0.003) << seed;
    // All good ones but a rare one beyond 3 px (6 sigma: none), and hardly any other.
    EXPECT_TRUE(std::includes(found->inliers.begin(), found->inliers.end(),
                              scene.right_ones.begin(), scene.right_ones.end()))
        << seed;
    EXPECT_LE(found->inliers.size(), scene.right_ones.size() + 2) << seed;
  }
}

// Points up to 62 degrees off the axis; the radii there are shrunk four times.
TEST(RigRansac, FindsThePoseThroughFisheyes) {
  const StereoGeometry rig = WideRig();
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const Scene scene = MakeScene(rig, seed, 0.4, 2.5);
    const auto found = EstimateRigPose(rig, scene.observations, std::nullopt, seed);
    ASSERT_TRUE(found.has_value()) << seed;
    const Vector6d error = found->T_WI.BoxMinus(scene.T_WI);
    EXPECT_LT(error.head<3>().norm(), 0.01) << seed;
    EXPECT_LT(error.tail<3>().norm(), 0.003) << seed;
    EXPECT_TRUE(std::includes(found->inliers.begin(), found->inliers.end(),
                              scene.right_ones.begin(), scene.right_ones.end()))
        << seed;
  }
}

TEST(RigRansac, IsDeterministic) {
  const StereoGeometry rig = Rig();
  const Scene scene = MakeScene(rig, 7, 0.4);
  const auto first = EstimateRigPose(rig, scene.observations, std::nullopt, 3);
  const auto second = EstimateRigPose(rig, scene.observations, std::nullopt, 3);
  EXPECT_EQ(first->T_WI.p(), second->T_WI.p());
  EXPECT_EQ(first->T_WI.q().coeffs(), second->T_WI.q().coeffs());
  EXPECT_EQ(first->inliers, second->inliers);
}

// A prior that is nearly right needs no sample.
TEST(RigRansac, TakesAPriorIntoAccount) {
  const StereoGeometry rig = Rig();
  const Scene scene = MakeScene(rig, 9, 0.4);
  Vector6d off;
  off << 0.001, -0.001, 0.001, 5e-4, -5e-4, 5e-4;
  const RigRansacConfig config{.max_iterations = 0};
  EXPECT_FALSE(EstimateRigPose(rig, scene.observations, std::nullopt, 1, config).has_value());
  const auto found = EstimateRigPose(rig, scene.observations, scene.T_WI.BoxPlus(off), 1, config);
  ASSERT_TRUE(found.has_value());
  EXPECT_LT(found->T_WI.BoxMinus(scene.T_WI).head<3>().norm(), 0.01);
}

TEST(RigRansac, GivesNoPoseWhereTooFewAgree) {
  const StereoGeometry rig = Rig();
  Scene scene = MakeScene(rig, 5, 1.0);
  EXPECT_FALSE(EstimateRigPose(rig, scene.observations, std::nullopt, 1).has_value());
  EXPECT_FALSE(EstimateRigPose(rig, {}, std::nullopt, 1).has_value());
  scene = MakeScene(rig, 5, 0.0);
  scene.observations.resize(9);
  EXPECT_FALSE(EstimateRigPose(rig, scene.observations, std::nullopt, 1).has_value());
}

}  // namespace
}  // namespace drydock::svin2
