#include "estimator/svin2/pose_graph/loop_consistency.h"

#include <gtest/gtest.h>

#include "tests/estimator/svin2/pose_graph/synthetic_graph.h"

namespace drydock::svin2 {
namespace {

using Eigen::Vector3d;
using testing::Covariance;

constexpr auto kBelieved = LoopVerdict::kBelieved;
constexpr auto kAgainstOdometry = LoopVerdict::kAgainstOdometry;
constexpr auto kAgainstLoops = LoopVerdict::kAgainstLoops;

/// Standard deviations as edges say.
LoopCheckConfig AsEdgesSay() {
  LoopCheckConfig config;
  config.sigma_factor = 1.0;
  config.streak_keyframes = 3;
  return config;
}

/// A straight way along x, a step of 1 m each: after k steps x is known to 0.1 sqrt(k) m.
class LoopConsistencyTest : public ::testing::Test {
 protected:
  void Extend(int count, bool linked = true) {
    for (int k = 0; k < count; ++k) {
      chain_.AddNode();
      if (chain_.size() > 1 && (linked || k > 0))
        chain_.Link(Pose(Eigen::Quaterniond::Identity(), {1, 0, 0}), Covariance(0.1, 1e-4));
    }
  }
  /// A loop that is off by `by`, in x.
  void Loop(std::size_t from, std::size_t to, double by, double base = 0.0) {
    const Vector3d truth(static_cast<double>(to) - static_cast<double>(from) + base + by, 0, 0);
    loops_.Add(chain_, from, to, Pose(Eigen::Quaterniond::Identity(), truth),
               Covariance(0.05, 1e-3));
  }
  std::vector<LoopVerdict> Verdicts() const { return loops_.Verdicts(); }

  OdometryChain chain_;
  LoopConsistency loops_{AsEdgesSay()};
};

TEST_F(LoopConsistencyTest, OdometryAllowsWhatItCanHaveDrifted) {
  // 5.28 sigma: chi2 is 27.9. Over 25 steps sigma is 0.502 m, over 100 steps 1.001 m.
  Extend(101);
  Loop(0, 25, 2.60);
  Loop(0, 100, 5.24);
  EXPECT_EQ(Verdicts(), (std::vector{kBelieved, kBelieved}));
  Loop(0, 25, 2.70);
  EXPECT_EQ(Verdicts().back(), kAgainstOdometry);
  Loop(0, 100, 5.34);
  EXPECT_EQ(Verdicts().back(), kAgainstOdometry);
}

TEST_F(LoopConsistencyTest, LoopsFromNeighboursMustAgree) {
  // Each by itself would do: 3 m is 3 sigma. Of two, the one that odometry likes better stays.
  Extend(101);
  Loop(0, 100, 3.0);
  Loop(1, 99, 0.2);
  EXPECT_EQ(Verdicts(), (std::vector{kAgainstLoops, kBelieved}));
}

TEST_F(LoopConsistencyTest, LoopsThatShareADriftAgree) {
  Extend(101);
  for (std::size_t k = 0; k < 5; ++k) Loop(k, 100 - k, 3.0);
  EXPECT_EQ(Verdicts(), std::vector(5, kBelieved));
}

TEST_F(LoopConsistencyTest, TheHeavierSideIsBelieved) {
  // Odometry likes the first better: it weighs 27.9, others 23.
  Extend(101);
  Loop(0, 100, 0.0);
  Loop(0, 92, 2.0);
  EXPECT_EQ(Verdicts(), (std::vector{kBelieved, kAgainstLoops}));
  Loop(8, 96, 2.0);
  EXPECT_EQ(Verdicts(), (std::vector{kAgainstLoops, kBelieved, kBelieved}));
}

TEST_F(LoopConsistencyTest, SightingsOfOnePlaceCountForLittle) {
  // As before, but all of the same place: together they weigh n^0.1 of 23.8.
  Extend(101);
  Loop(0, 100, 0.0);
  for (std::size_t k = 1; k <= 3; ++k) Loop(k, 97, 2.0);
  std::vector<LoopVerdict> expected(4, kAgainstLoops);
  expected[0] = kBelieved;
  EXPECT_EQ(Verdicts(), expected);
  for (std::size_t k = 1; k <= 3; ++k) Loop(k, 96, 2.0);
  for (std::size_t k = 1; k <= 3; ++k) Loop(k, 95, 2.0);
  expected.assign(10, kBelieved);
  expected[0] = kAgainstLoops;
  EXPECT_EQ(Verdicts(), expected);
}

TEST_F(LoopConsistencyTest, WhoWasOnlyAgainstALiarComesBack) {
  // One liar is at odds with a loop on either side of it, which agree with each other.
  Extend(101);
  Loop(50, 98, 1.5);
  Loop(49, 100, 0.0);
  Loop(51, 96, 0.0);
  EXPECT_EQ(Verdicts(), (std::vector{kAgainstLoops, kBelieved, kBelieved}));
}

TEST_F(LoopConsistencyTest, RingsApartFromEachOtherAreNotCompared) {
  Extend(101);
  Loop(0, 20, 1.0);
  Loop(30, 50, -1.0);
  EXPECT_EQ(Verdicts(), (std::vector{kBelieved, kBelieved}));
}

TEST_F(LoopConsistencyTest, BetweenPiecesLoopsAreHeldAgainstEachOther) {
  // The second piece began 7 m off; nothing says so but the loops, of which one is wrong.
  Extend(50);
  Extend(50, false);
  Loop(0, 99, 0.0, 7.0);
  EXPECT_EQ(Verdicts(), std::vector(1, kBelieved));
  Loop(6, 93, 4.0, 7.0);
  Loop(12, 87, 0.0, 7.0);
  EXPECT_EQ(Verdicts(), (std::vector{kBelieved, kAgainstLoops, kBelieved}));
}

TEST_F(LoopConsistencyTest, StandardDeviationsCountMoreByTheFactor) {
  LoopCheckConfig config;
  config.sigma_factor = 2.0;
  LoopConsistency doubled(config);
  Extend(26);
  doubled.Add(chain_, 0, 25, Pose(Eigen::Quaterniond::Identity(), {25 + 5.2, 0, 0}),
              Covariance(0.05, 1e-3));
  doubled.Add(chain_, 0, 25, Pose(Eigen::Quaterniond::Identity(), {25 + 5.4, 0, 0}),
              Covariance(0.05, 1e-3));
  EXPECT_EQ(doubled.Verdicts(), (std::vector{kBelieved, kAgainstOdometry}));
}

TEST_F(LoopConsistencyTest, LargeTurnsOfThePiecesDoNotMatter) {
  // As the second piece was laid down turned by 2 rad; two loops agree on that.
  Extend(50);
  Extend(50, false);
  const Pose T_PQ(FromYawPitchRoll(2.0, 0, 0), {5, 40, 0});
  for (const auto& [from, to] : {std::pair{0, 60}, std::pair{30, 90}}) {
    const auto a = static_cast<std::size_t>(from), b = static_cast<std::size_t>(to);
    loops_.Add(chain_, a, b, chain_.T_PI(a).Inverse() * T_PQ * chain_.T_PI(b),
               Covariance(0.05, 1e-3));
  }
  EXPECT_EQ(Verdicts(), (std::vector{kBelieved, kBelieved}));
}

}  // namespace
}  // namespace drydock::svin2
