#include "scenarios/scoring/alignment.h"

#include <gtest/gtest.h>

#include "sensors_models/base/check.h"
#include "tests/scenarios/scoring/support.h"

namespace drydock::score {
namespace {

std::vector<PosePair> Pairs(const Trajectory& truth, const Trajectory& estimate) {
  std::vector<PosePair> pairs;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    pairs.push_back({estimate[i].t, truth[i].T_WI, estimate[i].T_WI});
  }
  return pairs;
}

/// How far `similarity` is from undoing `moved_by`.
double Miss(const Similarity& similarity, const Pose& moved_by) {
  return (similarity.rigid * moved_by).BoxMinus(Pose()).norm();
}

TEST(Align, Se3UndoesAnyRigidMotion) {
  const Pose by(FromYawPitchRoll(2.0, 0.7, -1.1), {5.0, -3.0, 2.0});
  const auto result = Align(Pairs(Helix(), Moved(Helix(), by)), Alignment::kSe3);
  ASSERT_TRUE(result.has_value());
  EXPECT_EQ(result->scale, 1.0);
  EXPECT_LT(Miss(*result, by), 1e-13);
}

TEST(Align, Sim3FindsPureScale) {
  const auto result = Align(Pairs(Helix(), Moved(Helix(), Pose(), 2.0)), Alignment::kSim3);
  ASSERT_TRUE(result.has_value());
  EXPECT_NEAR(result->scale, 0.5, 1e-14);
  EXPECT_LT(Miss({1.0, result->rigid}, Pose()), 1e-13);
}

TEST(Align, YawUndoesYawAndTranslationAlone) {
  const Pose by(FromYawPitchRoll(-2.5, 0.0, 0.0), {1.0, 2.0, 3.0});
  const auto result = Align(Pairs(Helix(), Moved(Helix(), by)), Alignment::kYaw);
  ASSERT_TRUE(result.has_value());
  EXPECT_LT(Miss(*result, by), 1e-13);
}

TEST(Align, YawLeavesTilt) {
  const Pose tilted(FromYawPitchRoll(0.0, 0.0, 0.3), {0.0, 0.0, 0.0});
  const auto result = Align(Pairs(Helix(), Moved(Helix(), tilted)), Alignment::kYaw);
  ASSERT_TRUE(result.has_value());
  EXPECT_LT((result->rigid.q() * Eigen::Vector3d::UnitZ() - Eigen::Vector3d::UnitZ()).norm(),
            1e-13);
}

TEST(Align, OriginLaysTheFirstPosesUponEachOther) {
  const Pose by(FromYawPitchRoll(2.0, 0.7, -1.1), {5.0, -3.0, 2.0});
  auto pairs = Pairs(Helix(), Moved(Helix(), by));
  pairs.resize(1);
  const auto result = Align(pairs, Alignment::kOrigin);
  ASSERT_TRUE(result.has_value());
  EXPECT_LT(Miss(*result, by), 1e-13);
}

TEST(Align, NoneIsIdentity) {
  const auto result = Align({}, Alignment::kNone);
  ASSERT_TRUE(result.has_value());
  EXPECT_LT(Miss(*result, Pose()), 1e-15);
}

TEST(Align, NeverMirrors) {
  Trajectory mirrored = Helix();
  for (StampedPose& pose : mirrored) {
    Eigen::Vector3d p = pose.T_WI.p();
    p.z() = -p.z();
    pose.T_WI = Pose(pose.T_WI.q(), p);
  }
  for (const Alignment alignment : {Alignment::kSe3, Alignment::kSim3}) {
    const auto result = Align(Pairs(Helix(), mirrored), alignment);
    ASSERT_TRUE(result.has_value());
    EXPECT_NEAR(result->rigid.R().determinant(), 1.0, 1e-14);
  }
}

TEST(Align, FlatPathsAreAligned) {
  const Trajectory flat = MakeTrajectory(
      100, 0.1, [](double t) { return Eigen::Vector3d(std::cos(t), std::sin(t), 0.0); });
  const Pose by(FromYawPitchRoll(1.0, 0.5, 0.2), {1.0, 1.0, 1.0});
  const auto result = Align(Pairs(flat, Moved(flat, by)), Alignment::kSe3);
  ASSERT_TRUE(result.has_value());
  EXPECT_LT(Miss(*result, by), 1e-12);
}

TEST(Align, DegenerateOnesGiveNothing) {
  const Trajectory line =
      MakeTrajectory(100, 0.1, [](double t) { return Eigen::Vector3d(t, 0.0, 0.0); });
  const Trajectory point =
      MakeTrajectory(100, 0.1, [](double) { return Eigen::Vector3d(1.0, 2.0, 3.0); });
  const Trajectory vertical =
      MakeTrajectory(100, 0.1, [](double t) { return Eigen::Vector3d(1.0, 0.0, t); });
  EXPECT_FALSE(Align(Pairs(line, line), Alignment::kSe3).has_value());
  EXPECT_FALSE(Align(Pairs(line, line), Alignment::kSim3).has_value());
  EXPECT_TRUE(Align(Pairs(line, line), Alignment::kYaw).has_value());
  EXPECT_FALSE(Align(Pairs(point, point), Alignment::kSim3).has_value());
  EXPECT_FALSE(Align(Pairs(point, point), Alignment::kYaw).has_value());
  EXPECT_FALSE(Align(Pairs(vertical, vertical), Alignment::kYaw).has_value());
  EXPECT_TRUE(Align(Pairs(point, point), Alignment::kOrigin).has_value());
}

TEST(Align, TooFewPosesGiveNothing) {
  auto pairs = Pairs(Helix(), Helix());
  pairs.resize(2);
  EXPECT_FALSE(Align(pairs, Alignment::kSe3).has_value());
  EXPECT_TRUE(Align(pairs, Alignment::kYaw).has_value());
  pairs.resize(1);
  EXPECT_FALSE(Align(pairs, Alignment::kYaw).has_value());
  EXPECT_TRUE(Align(pairs, Alignment::kOrigin).has_value());
  EXPECT_FALSE(Align({}, Alignment::kOrigin).has_value());
}

TEST(Align, PositionAndYawOfOnePose) {
  const PosePair pair{Time{0}, Pose(FromYawPitchRoll(1.0, 0.1, 0.0), {1.0, 2.0, 3.0}),
                      Pose(FromYawPitchRoll(-0.5, 0.0, 0.2), {-1.0, 0.0, 5.0})};
  const Similarity result = AlignPositionAndYaw(pair);
  const Pose aligned = result * pair.estimate;
  EXPECT_LT((aligned.p() - pair.truth.p()).norm(), 1e-14);
  // No further turn about z brings it nearer.
  for (const double turn : {-1e-3, 1e-3}) {
    EXPECT_GT((FromYawPitchRoll(turn, 0, 0) * aligned.q()).angularDistance(pair.truth.q()),
              aligned.q().angularDistance(pair.truth.q()));
  }
  EXPECT_LT((result.rigid.q() * Eigen::Vector3d::UnitZ() - Eigen::Vector3d::UnitZ()).norm(), 1e-14);
}

TEST(Alignment, NamesGoBothWays) {
  for (const Alignment alignment :
       {Alignment::kNone, Alignment::kOrigin, Alignment::kYaw, Alignment::kSe3, Alignment::kSim3}) {
    EXPECT_EQ(ParseAlignment(ToString(alignment)), alignment);
  }
  EXPECT_THROW(ParseAlignment("SE3"), InputError);
}

}  // namespace
}  // namespace drydock::score
