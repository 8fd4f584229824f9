#include "estimator/registry/registry.h"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sensors_models/base/check.h"

namespace drydock {
namespace {

TEST(Registry, EveryEstimatorCanBeMade) {
  std::set<std::string_view> names;
  for (const EstimatorEntry& entry : Estimators()) {
    EXPECT_NE(entry.make(Rig{}), nullptr) << entry.name;
    EXPECT_FALSE(entry.summary.empty());
    EXPECT_TRUE(names.insert(entry.name).second) << "twice: " << entry.name;
  }
}

TEST(Registry, UnknownNamesAreRefusedWithTheKnownOnes) {
  try {
    FindEstimator("orb-slam");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("dead-reckoning"));
  }
}

}  // namespace
}  // namespace drydock
