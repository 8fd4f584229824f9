#include "scenarios/results/estimator_session.h"

#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenarios/results/stages_json.h"

namespace drydock {
namespace {

/// Publishes a pose at each measurement and says what it was told to.
class Talker final : public Estimator {
 public:
  void Start(const std::optional<NavState>&) override {}
  void Add(const Measurement& measurement) override {
    odometry_.push_back({measurement.t, Pose()});
    events_.push_back({measurement.t, odometry_.size() == 1 ? "initialised" : "carried on"});
  }
  void Finish() override { events_.push_back({odometry_.back().t, "optimised"}); }
  std::optional<NavEstimate> Latest() const override {
    NavEstimate estimate;
    estimate.status = TrackingStatus::kTracking;
    // The second pose comes with a covariance, and stays the latest.
    if (odometry_.size() == 2) {
      estimate.state.t = odometry_.back().t;
      estimate.pose_covariance = Eigen::Matrix<double, 6, 6>::Identity();
    }
    return estimate;
  }
  const Trajectory& Odometry() const override { return odometry_; }
  std::vector<LoopClosure> Loops() const override { return {{Time{9}, Time{4}, Pose()}}; }
  EstimatedMap Map() const override { return {{{1.0, 2.0, 3.0}}, {{4.0, 5.0, 6.0}}}; }
  std::vector<EstimatorEvent> TakeEvents() override { return std::exchange(events_, {}); }
  EstimatorTimings Timings() const override { return {{"talking", odometry_.size(), 0.5, 2., 3.}}; }

 private:
  Trajectory odometry_;
  std::vector<EstimatorEvent> events_;
};

TEST(EstimatorSession, KeepsWhatTheEstimatorSays) {
  EstimatorSession session(std::make_unique<Talker>(), Time::FromSeconds(10.0));
  // Taken 0.25 s before they arrive: the status is seen at the arrival.
  for (const double t : {11.0, 12.0}) {
    session.Add({Time::FromSeconds(t), Time::FromSeconds(t + 0.25), ImuSample{}});
  }
  const Results results = session.Finish();
  EXPECT_EQ(results.odometry.size(), 2U);
  EXPECT_EQ(results.corrected.size(), 2U);
  EXPECT_THAT(results.events,
              ::testing::ElementsAre("1.000 s: initialised", "1.250 s: tracking, map 0",
                                     "2.000 s: carried on", "2.000 s: optimised"));
  EXPECT_EQ(results.false_starts, 0);
  ASSERT_EQ(results.loops.size(), 1U);
  EXPECT_EQ(results.loops[0].t_then, Time{4});
  EXPECT_THAT(results.map.landmarks, ::testing::ElementsAre(Eigen::Vector3d(1.0, 2.0, 3.0)));
  EXPECT_THAT(results.map.sonar, ::testing::ElementsAre(Eigen::Vector3d(4.0, 5.0, 6.0)));
  ASSERT_EQ(results.beliefs.size(), 1U);
  EXPECT_EQ(results.beliefs[0].t, Time::FromSeconds(12.0));
  EXPECT_EQ(StagesJson(results.stages).dump(),
            R"({"talking":{"count":2,"total_s":0.5,"median_ms":2.0,"p99_ms":3.0}})");
}

}  // namespace
}  // namespace drydock
