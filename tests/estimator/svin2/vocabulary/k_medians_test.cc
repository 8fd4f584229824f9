#include "estimator/svin2/vocabulary/k_medians.h"

#include <numeric>
#include <set>

#include <gtest/gtest.h>

#include "tests/estimator/svin2/vocabulary/synthetic_descriptors.h"

namespace drydock::svin2 {
namespace {

using testing::Disturbed;
using testing::RandomDescriptor;
using testing::RandomDescriptors;

std::vector<std::uint32_t> AllOf(const std::vector<Descriptor>& descriptors) {
  std::vector<std::uint32_t> all(descriptors.size());
  std::iota(all.begin(), all.end(), 0U);
  return all;
}

TEST(Majority, CountsBitsAndKeepsWhatIsUndecided) {
  const std::vector<Descriptor> descriptors = {{0b0011}, {0b0101}, {0b1001, 7}};
  EXPECT_EQ(MajorityOf(descriptors, {0, 1, 2}, {}), Descriptor{0b0001});
  EXPECT_EQ(MajorityOf(descriptors, {0, 1}, {}), Descriptor{0b0001});
  EXPECT_EQ(MajorityOf(descriptors, {0, 1}, {0b1110}), Descriptor{0b0111});
}

// Eight centres, some 256 bits apart, and 30 members of each within 30 bits.
TEST(KMedians, SeparatesClusters) {
  RandomStream random(3, "test");
  const std::vector<Descriptor> centres = RandomDescriptors(8, random);
  std::vector<Descriptor> descriptors;
  descriptors.reserve(240);
  for (int i = 0; i < 240; ++i) descriptors.push_back(Disturbed(centres[i % 8], 30, random));
  const auto clusters = KMedians(descriptors, AllOf(descriptors), 8, 20, random);
  ASSERT_EQ(clusters.size(), 8U);
  std::set<std::uint32_t> found;
  for (const DescriptorCluster& cluster : clusters) {
    ASSERT_EQ(cluster.members.size(), 30U);
    const std::uint32_t which = cluster.members.front() % 8;
    found.insert(which);
    EXPECT_EQ(cluster.centre, centres[which]);
    for (const std::uint32_t member : cluster.members) EXPECT_EQ(member % 8, which);
  }
  EXPECT_EQ(found.size(), 8U);
}

// Where there is no structure to be found the clusters still are what they claim to be.
TEST(KMedians, PutsEachMemberWithItsNearestCentre) {
  RandomStream random(4, "test");
  const std::vector<Descriptor> descriptors = RandomDescriptors(300, random);
  for (const int iterations : {1, 2, 50}) {
    const auto clusters = KMedians(descriptors, AllOf(descriptors), 10, iterations, random);
    std::size_t members = 0;
    for (const DescriptorCluster& cluster : clusters) {
      EXPECT_FALSE(cluster.members.empty());
      members += cluster.members.size();
      for (const std::uint32_t member : cluster.members) {
        const int own = HammingDistance(cluster.centre, descriptors[member]);
        for (const DescriptorCluster& other : clusters) {
          EXPECT_LE(own, HammingDistance(other.centre, descriptors[member]));
        }
      }
    }
    EXPECT_EQ(members, descriptors.size());
  }
}

TEST(KMedians, MakesNoMoreClustersThanThereAreDifferentDescriptors) {
  RandomStream random(5, "test");
  const Descriptor a = RandomDescriptor(random), b = RandomDescriptor(random);
  const std::vector<Descriptor> descriptors = {a, b, a, a, b};
  EXPECT_EQ(KMedians(descriptors, AllOf(descriptors), 4, 20, random).size(), 2U);
  EXPECT_EQ(KMedians(descriptors, {0, 2, 3}, 4, 20, random).size(), 1U);
}

}  // namespace
}  // namespace drydock::svin2
