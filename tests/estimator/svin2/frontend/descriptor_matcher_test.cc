#include "estimator/svin2/frontend/descriptor_matcher.h"

#include <gtest/gtest.h>

#include "sensors_models/base/check.h"

namespace drydock::svin2 {
namespace {

// The first `bits` bits are set: two of these differ in the difference of their numbers.
Descriptor Bits(int bits) {
  Descriptor descriptor{};
  for (int i = 0; i < bits; ++i) descriptor[i / 64] |= std::uint64_t{1} << (i % 64);
  return descriptor;
}

using Matches = std::vector<std::optional<std::size_t>>;
const DescriptorMatcher kMatcher({.max_distance = 80, .max_ratio = 0.8, .radius_px = 25.0});

TEST(DescriptorMatcher, TakesTheNearestWithinTheRadius) {
  const std::vector<DescribedPoint> corners = {
      {{100.0, 100.0}, Bits(150)}, {{110.0, 100.0}, Bits(20)}, {{130.0, 100.0}, Bits(0)}};
  // 20 bits from the second, 150 from the first; the third would fit but is too far.
  EXPECT_EQ(kMatcher.Match({{{100.0, 100.0}, Bits(0)}}, corners), Matches{1});
}

TEST(DescriptorMatcher, RefusesWhatIsUnlikeOrAmbiguous) {
  EXPECT_EQ(kMatcher.Match({{{0.0, 0.0}, Bits(0)}}, {{{0.0, 0.0}, Bits(81)}}),
            Matches{std::nullopt});
  EXPECT_EQ(kMatcher.Match({{{0.0, 0.0}, Bits(0)}}, {{{0.0, 0.0}, Bits(80)}}), Matches{0});
  // 41 > 0.8 * 50.
  EXPECT_EQ(
      kMatcher.Match({{{0.0, 0.0}, Bits(0)}}, {{{0.0, 0.0}, Bits(41)}, {{1.0, 0.0}, Bits(50)}}),
      Matches{std::nullopt});
  EXPECT_EQ(kMatcher.Match({{{0.0, 0.0}, std::nullopt}}, {{{0.0, 0.0}, Bits(0)}}),
            Matches{std::nullopt});
}

TEST(DescriptorMatcher, GivesACornerToTheBetterOfTwo) {
  const std::vector<DescribedPoint> expected = {
      {{0.0, 0.0}, Bits(30)}, {{0.0, 0.0}, Bits(10)}, {{0.0, 0.0}, Bits(20)}};
  EXPECT_EQ(kMatcher.Match(expected, {{{0.0, 0.0}, Bits(0)}}),
            (Matches{std::nullopt, 0, std::nullopt}));
}

TEST(DescriptorMatcher, RefusesBadConfigurations) {
  EXPECT_THROW(DescriptorMatcher({.max_distance = 513}), InputError);
  EXPECT_THROW(DescriptorMatcher({.max_ratio = 0.0}), InputError);
  EXPECT_THROW(DescriptorMatcher({.radius_px = 0.0}), InputError);
}

}  // namespace
}  // namespace drydock::svin2
