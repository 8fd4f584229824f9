#include "sim/motion/sway.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/numeric.h"

namespace drydock::sim {
namespace {

using testing::NumericDerivative;

TEST(Sway, DerivativesMatchNumeric) {
  const Sway sway({0.02, 0.03}, 7);
  for (double t = 0.05; t < 30.0; t += 0.37) {
    const Sway::Sample sample = sway.At(t);
    const Sway::Vector rate = NumericDerivative([&](double x) { return sway.At(x).value; }, t);
    const Sway::Vector acceleration =
        NumericDerivative([&](double x) { return sway.At(x).rate; }, t);
    EXPECT_LT((sample.rate - rate).norm(), 1e-8) << t;
    EXPECT_LT((sample.acceleration - acceleration).norm(), 1e-7) << t;
  }
}

TEST(Sway, BeginsAtRest) {
  const Sway sway({0.02, 0.03}, 7);
  for (const double t : {-1.0, 0.0, 1e-4}) {
    EXPECT_LT(sway.At(t).value.norm(), 1e-12);
    EXPECT_LT(sway.At(t).rate.norm(), 1e-9);
    EXPECT_LT(sway.At(t).acceleration.norm(), 1e-6);
  }
}

TEST(Sway, HasTheSizeThatWasAskedFor) {
  const Sway sway({0.02, 0.03}, 3);
  Sway::Vector squares = Sway::Vector::Zero();
  constexpr int kSamples = 20'000;
  for (int i = 0; i < kSamples; ++i) squares += sway.At(10.0 + 0.1 * i).value.cwiseAbs2();
  const Sway::Vector rms = (squares / kSamples).cwiseSqrt();
  for (int axis = 0; axis < 6; ++axis) EXPECT_NEAR(rms[axis], axis < 3 ? 0.02 : 0.03, 0.001);
}

TEST(Sway, DependsOnTheSeedAlone) {
  const SwayConfig config{0.02, 0.03};
  EXPECT_EQ(Sway(config, 1).At(9.0).value, Sway(config, 1).At(9.0).value);
  EXPECT_NE(Sway(config, 1).At(9.0).value, Sway(config, 2).At(9.0).value);
  EXPECT_EQ(Sway({}, 1).At(9.0).value.norm(), 0.0);
}

}  // namespace
}  // namespace drydock::sim
