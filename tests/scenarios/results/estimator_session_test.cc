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
    return estimate;
  }
  const Trajectory& Odometry() const override { return odometry_; }
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
              testing::ElementsAre("1.000 s: initialised", "1.250 s: tracking, map 0",
                                   "2.000 s: carried on", "2.000 s: optimised"));
  EXPECT_EQ(StagesJson(results.stages).dump(),
            R"({"talking":{"count":2,"total_s":0.5,"median_ms":2.0,"p99_ms":3.0}})");
}

}  // namespace
}  // namespace drydock
