#include "estimator/svin2/initialisation/bundle_adjustment.h"

#include <Eigen/LU>
#include <cmath>

#include <gtest/gtest.h>

#include "sensors_models/base/random_stream.h"
#include "tests/estimator/svin2/initialisation/synthetic_dive.h"

namespace drydock::svin2 {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

Vector3d GaussianVector(RandomStream& random) {
  const double x = random.Gaussian(), y = random.Gaussian(), z = random.Gaussian();
  return {x, y, z};
}

struct Scene {
  Bundle truth;
  Bundle disturbed;  // Poses by 2 cm and 0.01 rad, landmarks by 10 cm; the first pose is right.
};

// 40 landmarks 1.5 to 5 m ahead of 4 frames some 0.2 m apart.
Scene MakeScene(const StereoGeometry& rig, std::uint64_t seed, double sigma_px) {
  RandomStream random(seed, "bundle");
  Scene scene;
  for (int k = 0; k < 4; ++k) {
    scene.truth.T_VI.emplace_back(FromYawPitchRoll(0.05 * k, -0.03 * k, 0.0),
                                  Vector3d(0.2 * k, 0.1 * k, -0.05 * k));
  }
  while (scene.truth.landmarks.size() < 40) {
    const double x = random.Uniform(1.5, 5.0);
    const Vector3d l(x, x * random.Uniform(-0.4, 0.4), x * random.Uniform(-0.3, 0.3));
    const int index = static_cast<int>(scene.truth.landmarks.size());
    scene.truth.landmarks.push_back(l);
    for (int k = 0; k < 4; ++k) {
      for (int camera = 0; camera < 2; ++camera) {
        const auto pixel =
            rig.camera(camera).Project((scene.truth.T_VI[k] * rig.T_IC(camera)).Inverse() * l);
        const Vector2d noise(random.Gaussian(), random.Gaussian());
        if (!pixel.has_value()) continue;
        scene.truth.observations.push_back(
            {index, k, camera, *pixel + sigma_px * noise, std::max(sigma_px, 0.1)});
      }
    }
  }
  scene.disturbed = scene.truth;
  for (std::size_t k = 1; k < 4; ++k) {
    Vector6d by;
    by << 0.02 * GaussianVector(random), 0.01 * GaussianVector(random);
    scene.disturbed.T_VI[k] = scene.truth.T_VI[k].BoxPlus(by);
  }
  for (Vector3d& l : scene.disturbed.landmarks) l += 0.1 * GaussianVector(random);
  return scene;
}

TEST(BundleAdjustment, FindsTheTruthWithoutNoise) {
  const StereoGeometry rig(testing::V3Stereo());
  const Scene scene = MakeScene(rig, 1, 0.0);
  const auto adjusted = AdjustBundle(rig, scene.disturbed, 20);
  ASSERT_TRUE(adjusted.has_value());
  for (int k = 0; k < 4; ++k) {
    EXPECT_LT(adjusted->T_VI[k].BoxMinus(scene.truth.T_VI[k]).norm(), 1e-6) << k;
  }
  EXPECT_LT((adjusted->landmarks[7] - scene.truth.landmarks[7]).norm(), 1e-5);
  EXPECT_LT(adjusted->mean_chi2, 1e-6);
}

// The normalised squared error has the mean of its 18 dimensions; the mean of 100 of them a
// standard deviation of sqrt(2 * 18 / 100) = 0.6. Cauchy's loss weighs good pixels down by some
// 1 / (1 + 2/4): it knows a little less than it could, and says even less.
TEST(BundleAdjustment, KnowsHowWellItKnows) {
  const StereoGeometry rig(testing::V3Stereo());
  double mean = 0.0, mean_chi2 = 0.0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const Scene scene = MakeScene(rig, seed, 0.5);
    const auto adjusted = AdjustBundle(rig, scene.disturbed, 20);
    ASSERT_TRUE(adjusted.has_value());
    Eigen::Matrix<double, 18, 1> error;
    for (int k = 1; k < 4; ++k) {
      error.segment<6>(6 * (k - 1)) = adjusted->T_VI[k].BoxMinus(scene.truth.T_VI[k]);
    }
    mean += error.dot(adjusted->information * error) / 100.0;
    mean_chi2 += adjusted->mean_chi2 / 100.0;
  }
  EXPECT_LT(mean, 18.0 + 2.0);
  EXPECT_GT(mean, 18.0 / 2.0);
  EXPECT_LT(mean_chi2, 2.0);
}

TEST(BundleAdjustment, WrongSigmasLowerTheInformation) {
  const StereoGeometry rig(testing::V3Stereo());
  Scene scene = MakeScene(rig, 3, 0.5);
  const auto honest = AdjustBundle(rig, scene.disturbed, 20);
  for (BundleObservation& seen : scene.disturbed.observations) seen.sigma_px = 0.25;
  const auto boasting = AdjustBundle(rig, scene.disturbed, 20);
  ASSERT_TRUE(honest.has_value() && boasting.has_value());
  // Half the sigma would be four times the information.
  EXPECT_LT(boasting->information.trace(), 1.2 * honest->information.trace());
  EXPECT_GT(boasting->information.trace(), 0.6 * honest->information.trace());
}

TEST(BundleAdjustment, OutliersHardlyMatter) {
  const StereoGeometry rig(testing::V3Stereo());
  Scene scene = MakeScene(rig, 5, 0.3);
  for (std::size_t i = 0; i < scene.disturbed.observations.size(); i += 13) {
    scene.disturbed.observations[i].pixel += Vector2d(15.0, -10.0);
  }
  const auto adjusted = AdjustBundle(rig, scene.disturbed, 30);
  ASSERT_TRUE(adjusted.has_value());
  for (int k = 1; k < 4; ++k) {
    const Vector6d error = adjusted->T_VI[k].BoxMinus(scene.truth.T_VI[k]);
    EXPECT_LT(error.head<3>().norm(), 0.01) << k;
    EXPECT_LT(error.tail<3>().norm(), 0.004) << k;
  }
}

TEST(BundleAdjustment, SaysNothingWhereAPoseIsFree) {
  const StereoGeometry rig(testing::V3Stereo());
  Bundle bundle = MakeScene(rig, 1, 0.0).truth;
  std::erase_if(bundle.observations, [](const auto& seen) { return seen.frame == 2; });
  EXPECT_FALSE(AdjustBundle(rig, bundle, 5).has_value());
  EXPECT_FALSE(AdjustBundle(rig, {}, 5).has_value());
}

}  // namespace
}  // namespace drydock::svin2
