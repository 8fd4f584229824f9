#include "sim/world/moving_things.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sensors_models/base/check.h"
#include "sim/world/closed_curve.h"
#include "sim/world/ray_scene.h"
#include "sim/world/world.h"
#include "tests/sim/world/creature_files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_scene.h"

namespace drydock::sim {
namespace {

using Eigen::Vector3d;
constexpr double kDegrees = std::numbers::pi / 180.0;
constexpr std::size_t kParts = 3;

TEST(ClosedCurve, IsFollowedAtAnEvenPaceAndCloses) {
  const ClosedCurve curve({1, 2, 3}, {{{2.0, 0.0, 0.2}, {0.0, 1.1, 0.0}},
                                      {{0.1, 0.2, 0.0}, {-0.2, 0.1, 0.1}},
                                      {{0.0, 0.06, 0.0}, {0.08, 0.0, 0.05}}});
  constexpr double kStep = 1e-4;
  for (double s = -0.3; s < 1.3 * curve.length(); s += 0.0137) {
    const Vector3d step = curve.At(s + kStep) - curve.At(s - kStep);
    EXPECT_NEAR(step.norm() / (2.0 * kStep), 1.0, 2e-4) << s;
    EXPECT_LT((step.normalized() - curve.Ahead(s)).norm(), 1e-4) << s;
  }
  EXPECT_LT((curve.At(0.0) - curve.At(curve.length())).norm(), 1e-9);
  EXPECT_LT((curve.At(0.7) - curve.At(0.7 - 2.0 * curve.length())).norm(), 1e-9);
}

TEST(ClosedCurve, ACircleIsAsLongAsItIs) {
  const ClosedCurve circle({0, 0, 0}, {{{2, 0, 0}, {0, 2, 0}}});
  EXPECT_NEAR(circle.length(), 4.0 * std::numbers::pi, 1e-9);
  EXPECT_NEAR(circle.FarthestFrom({0, 0, 0}), 2.0, 1e-12);
  EXPECT_LT((circle.At(std::numbers::pi) - Vector3d(0, 2, 0)).norm(), 1e-9);
}

class MovingThingsTest : public ::testing::Test {
 protected:
  static ShoalConfig Config() {
    ShoalConfig shoal;
    shoal.count = 12;
    shoal.centre_m = {3.0, -1.0, 0.5};
    shoal.radius_m = 1.5;
    shoal.speed_m_s = 0.4;
    shoal.size_m = 0.3;
    return shoal;
  }
  MovingThings Shoal(const ShoalConfig& shoal, std::uint64_t seed = 1) const {
    return {{{shoal, 0.0, 1e9}}, creatures_, seed};
  }
  static Pose At(const MovingThings& things, double t, std::size_t body) {
    const MovingPoses poses = things.At(Time::FromSeconds(t), Pose());
    return poses.at(body).value();
  }

  testing::TemporaryFolder folder_;
  Creatures creatures_ = testing::WriteCreatures(folder_.path());
};

TEST_F(MovingThingsTest, FishSwimAsFastAsTheyShouldAndLookWhereTheyGo) {
  const MovingThings things = Shoal(Config());
  ASSERT_EQ(things.bodies().size(), 12 * kParts);
  constexpr double kStep = 0.001;
  double mean = 0.0;
  for (std::size_t fish = 0; fish < 12; ++fish) {
    double slowest = 1e9;
    double fastest = 0.0;
    for (double t = 0.1; t < 40.0; t += 0.531) {
      const Vector3d v =
          (At(things, t + kStep, kParts * fish).p() - At(things, t - kStep, kParts * fish).p()) /
          (2.0 * kStep);
      slowest = std::min(slowest, v.norm());
      fastest = std::max(fastest, v.norm());
      const Eigen::Matrix3d R = At(things, t, kParts * fish).R();
      EXPECT_GT(R.col(0).dot(v.normalized()), std::cos(0.1 * kDegrees)) << fish << " at " << t;
      EXPECT_NEAR(R.col(1).z(), 0.0, 1e-9);  // Upright.
      EXPECT_GT(R.col(2).z(), 0.7);
    }
    EXPECT_LT(fastest - slowest, 1e-3 * fastest) << fish;
    EXPECT_NEAR(fastest, 0.4, 0.08) << fish;
    mean += fastest / 12;
  }
  EXPECT_NEAR(mean, 0.4, 1e-3);
}

TEST_F(MovingThingsTest, EveryPartMovesSmoothly) {
  const MovingThings things = Shoal(Config());
  constexpr double kStep = 1.0 / 500.0;
  for (std::size_t body = 0; body < things.bodies().size(); ++body) {
    Vector6d before = Vector6d::Zero();
    for (double t = 1.0; t < 5.0; t += kStep) {
      const Vector6d step = At(things, t + kStep, body).BoxMinus(At(things, t, body)) / kStep;
      // A tail beats at about 2 Hz by 20 degrees: at most 4 rad/s and 50 rad/s^2.
      if (t > 1.0) {
        EXPECT_LT((step - before).head<3>().norm() / kStep, 8.0) << body << " at " << t;
        EXPECT_LT((step - before).tail<3>().norm() / kStep, 150.0) << body << " at " << t;
      }
      before = step;
    }
  }
}

TEST_F(MovingThingsTest, NoFishLeavesTheBallAndTheyKeepTogetherAndApart) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    const ShoalConfig config = Config();
    const MovingThings things = Shoal(config, seed);
    for (double t = 0.0; t < 200.0; t += 3.7) {
      Vector3d middle = Vector3d::Zero();
      for (std::size_t fish = 0; fish < 12; ++fish) {
        const Vector3d p = At(things, t, kParts * fish).p();
        EXPECT_LT((p - config.centre_m).norm(), config.radius_m);
        middle += p / 12;
        for (std::size_t other = 0; other < fish; ++other)
          EXPECT_GT((p - At(things, t, kParts * other).p()).norm(), 0.03);
      }
      for (std::size_t fish = 0; fish < 12; ++fish)
        EXPECT_LT((At(things, t, kParts * fish).p() - middle).norm(), 1.6);
    }
  }
}

// The parts hang together at their joints, and the tail's tip swings by about 0.2 lengths.
TEST_F(MovingThingsTest, TheTailBeats) {
  ShoalConfig config = Config();
  config.count = 1;
  config.radius_m = 40.0;  // As good as straight.
  const MovingThings things = Shoal(config);
  const double size = things.bodies().front().scale;
  double left = 0.0;
  double right = 0.0;
  int crossings = 0;
  double before = 0.0;
  constexpr double kSpan = 20.0;
  for (double t = 0.0; t < kSpan; t += 0.01) {
    const Pose head = At(things, t, 0);
    const Pose tail = At(things, t, 2);
    const Vector3d joint(-0.3 * size, 0, 0);
    EXPECT_LT((tail * joint - At(things, t, 1) * joint).norm(), 1e-9);
    const double swing = (head.Inverse() * (tail * Vector3d(-0.58 * size, 0, 0))).y() / size;
    left = std::max(left, swing);
    right = std::min(right, swing);
    if (before < 0.0 && swing >= 0.0) ++crossings;
    before = swing;
  }
  EXPECT_GT(left - right, 0.14);
  EXPECT_LT(left - right, 0.28);
  EXPECT_NEAR(crossings / kSpan, 0.4 / (0.7 * size), 0.15 * 0.4 / (0.7 * size));
}

TEST_F(MovingThingsTest, TheSeedAloneChooses) {
  const MovingThings one = Shoal(Config(), 1);
  const MovingThings same = Shoal(Config(), 1);
  const MovingThings other = Shoal(Config(), 2);
  for (std::size_t body = 0; body < one.bodies().size(); ++body) {
    EXPECT_EQ(At(one, 7.3, body).p(), At(same, 7.3, body).p());
    EXPECT_EQ(At(one, 7.3, body).q().coeffs(), At(same, 7.3, body).q().coeffs());
  }
  EXPECT_GT((At(one, 7.3, 0).p() - At(other, 7.3, 0).p()).norm(), 0.01);
  // A second shoal changes nothing of the first, and swims in another way.
  const MovingThings two({{Config(), 0.0, 1e9}, {Config(), 0.0, 1e9}}, creatures_, 1);
  EXPECT_EQ(At(two, 7.3, 0).p(), At(one, 7.3, 0).p());
  EXPECT_GT((At(two, 7.3, 36).p() - At(one, 7.3, 0).p()).norm(), 0.01);
}

TEST_F(MovingThingsTest, ThingsAreThereFromThenToThen) {
  const MovingThings things({{Config(), 5.0, 8.0}, {DiverArmConfig(), 6.0, 7.0}}, creatures_, 1);
  ASSERT_EQ(things.bodies().size(), 37U);
  const auto there = [&](double t, std::size_t body) {
    return things.At(Time::FromSeconds(t), Pose()).at(body).has_value();
  };
  for (const auto& [t, fish, arm] :
       {std::tuple(4.9, false, false), std::tuple(5.1, true, false), std::tuple(6.5, true, true),
        std::tuple(7.5, true, false), std::tuple(8.1, false, false)}) {
    EXPECT_EQ(there(t, 0), fish) << t;
    EXPECT_EQ(there(t, 35), fish) << t;
    EXPECT_EQ(there(t, 36), arm) << t;
  }
}

class ArmTest : public MovingThingsTest {
 protected:
  /// The finger tips in I at `t`.
  static Vector3d Tips(const MovingThings& things, double t, const Pose& T_WI = {}) {
    const Pose T_WB = *things.At(Time::FromSeconds(t), T_WI).at(0);
    return T_WI.Inverse() * (T_WB * Vector3d(0.45, 0, 0));
  }
};

TEST_F(ArmTest, GoesAlongWithTheBodyAndSwaysALittle) {
  const MovingThings things({{DiverArmConfig(), 0.0, 1e9}}, creatures_, 1);
  const Pose T_WI(FromYawPitchRoll(2.0, 0.3, -0.2), {4, 5, 6});
  double farthest = 0.0;
  for (double t = 0.0; t < 60.0; t += 0.37) {
    EXPECT_LT((Tips(things, t) - Tips(things, t, T_WI)).norm(), 1e-9);
    const Vector3d tips = Tips(things, t);
    EXPECT_NEAR(tips.x(), 0.5, 0.1);
    EXPECT_LT(tips.y(), 0.0);  // The right one.
    EXPECT_LT(tips.z(), 0.0);
    farthest = std::max(farthest, (tips - Tips(things, 0.0)).norm());
  }
  EXPECT_GT(farthest, 0.01);
  EXPECT_LT(farthest, 0.12);
}

TEST_F(ArmTest, IsStretchedOutAndDrawnBackSmoothly) {
  DiverArmConfig left;
  left.left = true;
  const MovingThings things({{left, 3.0, 9.0}}, creatures_, 1);
  EXPECT_LT(Tips(things, 3.0).x(), 0.1);  // Not yet in view.
  EXPECT_NEAR(Tips(things, 6.0).x(), 0.5, 0.1);
  EXPECT_GT(Tips(things, 6.0).y(), 0.0);
  EXPECT_LT(Tips(things, 9.0).x(), 0.1);
  Vector3d before = Vector3d::Zero();
  for (double t = 3.0; t < 8.99; t += 0.01) {
    const Vector3d v = (Tips(things, t + 0.01) - Tips(things, t)) / 0.01;
    if (t > 3.0) {
      EXPECT_LT((v - before).norm(), 0.05) << t;
    }
    before = v;
  }
}

class MovingWorldTest : public MovingThingsTest {
 protected:
  std::filesystem::path Scene() const {
    return testing::WriteScene(folder_.path(),
                               testing::BoxElement("rock", {3, 1, 0}, {0.5, 0.4, 0.3}, 20.0) +
                                   "<geom type=\"plane\" pos=\"0 0 -2\" size=\"9 9 1\"/>");
  }
};

TEST_F(MovingWorldTest, TheSceneStaysAsItIs) {
  const World still(Scene());
  const World moving(Scene(), Shoal(Config()));
  EXPECT_TRUE(still.moving().bodies().empty());
  const int n = still.model().ngeom;
  ASSERT_EQ(moving.model().ngeom, n + static_cast<int>(12 * kParts));
  for (int geom = 0; geom < n; ++geom) {
    EXPECT_EQ(moving.BodyOfGeom(geom), still.BodyOfGeom(geom));
    EXPECT_FALSE(moving.IsMoving(geom));
    for (int i = 0; i < 3; ++i)
      EXPECT_EQ(moving.data().geom_xpos[3 * geom + i], still.data().geom_xpos[3 * geom + i]);
    for (int i = 0; i < 9; ++i)
      EXPECT_EQ(moving.data().geom_xmat[9 * geom + i], still.data().geom_xmat[9 * geom + i]);
  }
  ASSERT_EQ(moving.moving_geoms().size(), 12 * kParts);
  for (std::size_t i = 0; i < moving.moving_geoms().size(); ++i) {
    const int geom = moving.moving_geoms()[i];
    EXPECT_TRUE(moving.IsMoving(geom));
    EXPECT_EQ(moving.BodyOfGeom(geom), moving.moving().bodies()[i].name);
  }
}

TEST_F(MovingWorldTest, RaysPassThroughWhatMoves) {
  // Where MuJoCo itself has all moving bodies: around the origin.
  const World still(Scene());
  const World moving(Scene(), Shoal(Config()));
  const RayScene a(still);
  const RayScene b(moving);
  EXPECT_EQ(a.Bounds().min(), b.Bounds().min());
  EXPECT_EQ(a.Bounds().max(), b.Bounds().max());
  EXPECT_FALSE(b.Nearest({0, 0, 0}, 0.5).has_value());
  for (double yaw = 0.0; yaw < 6.2; yaw += 0.05) {
    const Vector3d direction(std::cos(yaw), std::sin(yaw), 0.0);
    const auto hit = a.Cast({-1, 0, 0}, direction, 20.0);
    const auto same = b.Cast({-1, 0, 0}, direction, 20.0);
    ASSERT_EQ(hit.has_value(), same.has_value());
    if (!hit) continue;
    EXPECT_EQ(hit->range, same->range);
    EXPECT_EQ(hit->geom, same->geom);
  }
}

TEST_F(MovingWorldTest, AMissingFileIsNamed) {
  Creatures broken = creatures_;
  broken["bream"][0].mesh = folder_.path() / "gone.obj";
  EXPECT_THROW(World(Scene(), MovingThings({{Config(), 0.0, 1.0}}, broken, 1)), InputError);
}

}  // namespace
}  // namespace drydock::sim
