// SVIn2 on a simulated dive whose measurements are spoilt on their way. One dive for all tests:
// they run in one process.
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "estimator/registry/registry.h"
#include "scenarios/scoring/scorecard.h"
#include "sensors_models/base/random_stream.h"
#include "tests/integration/recorded_dive.h"

namespace drydock {
namespace {

using testing::RecordedDive;

/// What a fault makes of one measurement: none, itself, or several.
using Fault = std::function<std::vector<Measurement>(const Measurement&)>;

struct Outcome {
  score::Metrics metrics;
  Trajectory odometry;
  std::vector<std::string> events;
  std::vector<TrackingStatus> statuses;  ///< Each as it was entered.
  int map_id = 0;

  bool Says(const std::string& part) const {
    for (const std::string& event : events)
      if (event.find(part) != std::string::npos) return true;
    return false;
  }
};

class Svin2Faults : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    dive_ = std::make_unique<RecordedDive>(testing::RecordBus({"duration_s=15"}));
  }
  static void TearDownTestSuite() { dive_.reset(); }

  static Outcome Run(const Fault& fault) {
    const auto estimator = FindEstimator("svin2-noloop").make(dive_->rig, NoOptions());
    estimator->Start(dive_->start);
    Outcome outcome;
    for (const Measurement& measurement : dive_->measurements) {
      for (const Measurement& spoilt : fault(measurement)) {
        estimator->Add(spoilt);
        Note(*estimator, outcome);
      }
    }
    estimator->Finish();
    Note(*estimator, outcome);
    outcome.odometry = estimator->Odometry();
    outcome.metrics =
        score::Score({}, dive_->truth, outcome.odometry, outcome.odometry, {}).metrics;
    std::printf("ATE %.4f m, z %.4f m\n", outcome.metrics.ate_rmse_m.value_or(-1),
                outcome.metrics.z_rmse_m.value_or(-1));
    for (const StampedPose& pose : outcome.odometry) {
      if (pose.T_WI.p().allFinite() && pose.T_WI.q().coeffs().allFinite()) continue;
      ADD_FAILURE() << "not a pose at " << pose.t.Seconds() << " s";
      break;
    }
    return outcome;
  }

  static const Outcome& Clean() {
    static const Outcome clean = Run([](const Measurement& m) { return std::vector{m}; });
    return clean;
  }

 private:
  static void Note(Estimator& estimator, Outcome& outcome) {
    for (EstimatorEvent& event : estimator.TakeEvents())
      outcome.events.push_back(std::move(event.message));
    const auto latest = estimator.Latest();
    if (!latest) return;
    outcome.map_id = latest->map_id;
    if (outcome.statuses.empty() || outcome.statuses.back() != latest->status)
      outcome.statuses.push_back(latest->status);
  }

  static inline std::unique_ptr<RecordedDive> dive_;
};

bool IsBetween(Time t, double from_s, double to_s) {
  return t >= Time::FromSeconds(from_s) && t < Time::FromSeconds(to_s);
}

template <typename Reading>
bool Is(const Measurement& measurement) {
  return std::holds_alternative<Reading>(measurement.reading);
}

/// The readings of one sensor are missing for a while.
template <typename Reading>
Fault Missing(double from_s, double to_s) {
  return [=](const Measurement& m) -> std::vector<Measurement> {
    if (Is<Reading>(m) && IsBetween(m.t, from_s, to_s)) return {};
    return {m};
  };
}

TEST_F(Svin2Faults, NoneAtAll) {
  EXPECT_LT(*Clean().metrics.ate_rmse_m, 0.02);
  EXPECT_LT(*Clean().metrics.z_rmse_m, 0.01);
  EXPECT_EQ(Clean().statuses, std::vector{TrackingStatus::kTracking});
}

TEST_F(Svin2Faults, FiveSecondsOfBlackImages) {
  const Outcome outcome = Run([](const Measurement& m) {
    return std::vector{IsBetween(m.t, 5, 10) ? testing::Blackened(m) : m};
  });
  // 0.03 m/s^2 of bias, known to a tenth, moves the body by 4 cm in 5 s; tilt adds its share.
  EXPECT_LT(*outcome.metrics.ate_rmse_m, 0.15);
  EXPECT_LT(*outcome.metrics.z_rmse_m, 0.02);
  EXPECT_EQ(outcome.statuses,
            (std::vector{TrackingStatus::kTracking, TrackingStatus::kDeadReckoning,
                         TrackingStatus::kTracking}));
  EXPECT_EQ(outcome.map_id, 0);
  EXPECT_EQ(outcome.odometry.size(), Clean().odometry.size());
}

TEST_F(Svin2Faults, TenSecondsWithoutSonar) {
  const Outcome outcome = Run(Missing<SonarPing>(3, 13));
  EXPECT_LT(*outcome.metrics.ate_rmse_m, 0.02);
}

TEST_F(Svin2Faults, TenSecondsWithoutDepth) {
  const Outcome outcome = Run(Missing<DepthSample>(3, 13));
  EXPECT_LT(*outcome.metrics.ate_rmse_m, 0.03);
}

TEST_F(Svin2Faults, ThirtyPercentOfFramesDropped) {
  const RandomStream random(1, "dropped frames");
  std::uint64_t count = 0;
  const Outcome outcome = Run([&](const Measurement& m) -> std::vector<Measurement> {
    if (Is<StereoFrame>(m) && random.UniformAt(count++) < 0.3) return {};
    return {m};
  });
  EXPECT_LT(outcome.odometry.size(), 9 * Clean().odometry.size() / 10);
  EXPECT_LT(*outcome.metrics.ate_rmse_m, 0.03);
}

TEST_F(Svin2Faults, HalfASecondWithoutImu) {
  const Outcome outcome = Run(Missing<ImuSample>(7, 7.5));
  EXPECT_LT(*outcome.metrics.ate_rmse_m, 0.05);
  EXPECT_EQ(outcome.odometry.size(), Clean().odometry.size());
}

TEST_F(Svin2Faults, ADepthSpikeOfFiveMetres) {
  const Outcome outcome = Run([](const Measurement& m) {
    Measurement spiked = m;
    if (auto* depth = std::get_if<DepthSample>(&spiked.reading); depth && IsBetween(m.t, 7.5, 8.5))
      depth->depth += 5.0;
    return std::vector{spiked};
  });
  EXPECT_TRUE(outcome.Says("was not believed"));
  EXPECT_LT(*outcome.metrics.z_rmse_m, 0.01);
}

TEST_F(Svin2Faults, DuplicateAndSwappedStampsAreRefusedAndCounted) {
  // Each tenth measurement comes twice; each tenth frame is followed by one from a second ago.
  int count = 0;
  const Outcome outcome = Run([&](const Measurement& m) {
    std::vector<Measurement> spoilt = {m};
    if (++count % 10 == 0) spoilt.push_back(m);
    if (count % 10 == 5) {
      spoilt.push_back(m);
      spoilt.back().t = m.t - Duration{1'000'000'000};
    }
    return spoilt;
  });
  EXPECT_TRUE(outcome.Says("refused a stereo frame"));
  EXPECT_TRUE(outcome.Says("refused in all:"));
  ASSERT_EQ(outcome.odometry.size(), Clean().odometry.size());
  for (std::size_t k = 0; k < outcome.odometry.size(); ++k)
    ASSERT_EQ(outcome.odometry[k].T_WI.p(), Clean().odometry[k].T_WI.p()) << k;
}

TEST_F(Svin2Faults, ReadingsThatAreNoNumbersAndImagesThatAreNone) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  int count = 0;
  const Outcome outcome = Run([&](const Measurement& m) {
    Measurement spoilt = m;
    if (++count % 50 != 0) return std::vector{spoilt};
    if (auto* imu = std::get_if<ImuSample>(&spoilt.reading)) imu->angular_rate.x() = kNaN;
    if (auto* depth = std::get_if<DepthSample>(&spoilt.reading)) depth->depth = kNaN;
    if (auto* ping = std::get_if<SonarPing>(&spoilt.reading)) ping->range = kNaN;
    if (auto* frame = std::get_if<StereoFrame>(&spoilt.reading)) {
      frame->images[0] = count % 100 == 0 ? cv::Mat() : cv::Mat(3, 5, CV_8UC1, cv::Scalar(0));
    }
    return std::vector{spoilt};
  });
  EXPECT_TRUE(outcome.Says("refused an IMU sample"));
  EXPECT_LT(*outcome.metrics.ate_rmse_m, 0.05);
}

}  // namespace
}  // namespace drydock
