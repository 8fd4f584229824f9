#include "estimator/svin2/places/candidate_consistency.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sensors_models/base/check.h"

namespace drydock::svin2 {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(CandidateConsistency, PassesThePlaceThatIsProposedThreeTimes) {
  CandidateConsistency filter({.max_gap = 3, .required = 3});
  EXPECT_THAT(filter.Update({{10, 0.5}}), IsEmpty());
  EXPECT_THAT(filter.Update({{12, 0.4}}), IsEmpty());
  EXPECT_THAT(filter.Update({{13, 0.3}}), ElementsAre(PlaceMatch{13, 0.3}));
  EXPECT_THAT(filter.Update({{10, 0.2}}), ElementsAre(PlaceMatch{10, 0.2}));
}

TEST(CandidateConsistency, GapOrOtherPlaceBeginsAnew) {
  CandidateConsistency filter({.max_gap = 3, .required = 2});
  filter.Update({{10, 0.5}});
  EXPECT_THAT(filter.Update({{14, 0.5}}), IsEmpty());
  EXPECT_THAT(filter.Update({}), IsEmpty());
  EXPECT_THAT(filter.Update({{14, 0.5}}), IsEmpty());
  EXPECT_THAT(filter.Update({{11, 0.5}}), ElementsAre(PlaceMatch{11, 0.5}));
  filter.Restart();
  EXPECT_THAT(filter.Update({{11, 0.5}}), IsEmpty());
}

// 10, 13 and 15 hang together; 20 is a place of its own.
TEST(CandidateConsistency, NeighboursMakeAnIsland) {
  CandidateConsistency filter({.max_gap = 3, .required = 2});
  filter.Update({{8, 0.1}, {22, 0.1}});
  EXPECT_THAT(filter.Update({{15, 0.2}, {20, 0.3}, {10, 0.2}, {13, 0.6}}),
              ElementsAre(PlaceMatch{13, 0.6}, PlaceMatch{20, 0.3}));
}

TEST(CandidateConsistency, EquallyGoodOnesGoByAge) {
  CandidateConsistency filter({.max_gap = 1, .required = 1});
  EXPECT_THAT(filter.Update({{31, 0.5}, {11, 0.5}, {21, 0.5}, {10, 0.5}}),
              ElementsAre(PlaceMatch{10, 0.5}, PlaceMatch{21, 0.5}, PlaceMatch{31, 0.5}));
}

TEST(CandidateConsistency, RefusesWhatItCannotUse) {
  EXPECT_THROW(CandidateConsistency({.max_gap = 0, .required = 1}), InputError);
  EXPECT_THROW(CandidateConsistency({.max_gap = 1, .required = 0}), InputError);
}

}  // namespace
}  // namespace drydock::svin2
