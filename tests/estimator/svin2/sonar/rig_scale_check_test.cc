#include "estimator/svin2/sonar/rig_scale_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sensors_models/base/random_stream.h"

namespace drydock::svin2 {
namespace {

constexpr double kSigma = 0.04;

/// `count` pings of 1 to 3 m, by a rig whose world is `share` too small.
void Ping(RigScaleCheck& check, int count, double share) {
  const RandomStream random(1, "pings");
  for (int k = 0; k < count; ++k) {
    const auto i = static_cast<std::uint64_t>(k);
    const double range = 1.0 + 2.0 * random.UniformAt(2 * i);
    check.Add(range, share * range + kSigma * random.GaussianAt(2 * i + 1), kSigma);
  }
}

TEST(RigScaleCheck, FindsTheShareToItsOwnStandardDeviation) {
  RigScaleCheck check({});
  Ping(check, 200, -0.03);
  ASSERT_TRUE(check.Found());
  EXPECT_NEAR(check.Found()->sigma, kSigma / 2.08 / std::sqrt(200.0), 1e-4);
  EXPECT_NEAR(check.Found()->share, -0.03, 3.0 * check.Found()->sigma);
}

TEST(RigScaleCheck, ComplainsOnceAndOnlyOfAWrongRig) {
  RigScaleCheck right({}), wrong({});
  Ping(right, 2000, 0.005);
  EXPECT_FALSE(right.Complaint());
  Ping(wrong, 59, -0.03);
  EXPECT_FALSE(wrong.Complaint()) << "too few pings";
  Ping(wrong, 60, -0.03);
  EXPECT_THAT(wrong.Complaint().value_or("nothing"), ::testing::HasSubstr("-2.8 +- 0.2 %"));
  EXPECT_FALSE(wrong.Complaint());
}

}  // namespace
}  // namespace drydock::svin2
