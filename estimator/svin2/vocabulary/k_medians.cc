#include "estimator/svin2/vocabulary/k_medians.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace drydock::svin2 {
namespace {

using Members = std::vector<std::uint32_t>;

/// k-means++: each next centre is a member, drawn by the square of its distance to the nearest
/// centre so far. Fewer than k if all members are among them.
std::vector<Descriptor> FirstCentres(const std::vector<Descriptor>& descriptors,
                                     const Members& members, int k, RandomStream& random) {
  std::vector<double> chances(members.size(), 1.0);
  std::vector<Descriptor> centres;
  while (std::ssize(centres) < k) {
    double sum = 0.0;
    for (const double chance : chances) sum += chance;
    if (sum == 0.0) break;
    double left = random.Uniform() * sum;
    std::size_t drawn = 0;
    // The last with a chance takes what rounding leaves.
    for (std::size_t i = 0; i < chances.size() && left >= 0.0; ++i) {
      if (chances[i] > 0.0) drawn = i;
      left -= chances[i];
    }
    const Descriptor& centre = centres.emplace_back(descriptors[members[drawn]]);
    for (std::size_t i = 0; i < members.size(); ++i) {
      const double distance = HammingDistance(descriptors[members[i]], centre);
      const double chance = distance * distance;
      chances[i] = centres.size() == 1 ? chance : std::min(chances[i], chance);
    }
  }
  return centres;
}

/// The members by their nearest centre; clusters without any are left out.
std::vector<DescriptorCluster> Assign(const std::vector<Descriptor>& descriptors,
                                      const Members& members,
                                      const std::vector<Descriptor>& centres) {
  std::vector<DescriptorCluster> clusters(centres.size());
  for (std::size_t c = 0; c < centres.size(); ++c) clusters[c].centre = centres[c];
  for (const std::uint32_t member : members) {
    const auto nearest = std::ranges::min_element(clusters, {}, [&](const DescriptorCluster& c) {
      return HammingDistance(c.centre, descriptors[member]);
    });
    nearest->members.push_back(member);
  }
  std::erase_if(clusters, [](const DescriptorCluster& c) { return c.members.empty(); });
  return clusters;
}

std::vector<Descriptor> CentresOf(const std::vector<DescriptorCluster>& clusters) {
  std::vector<Descriptor> centres;
  centres.reserve(clusters.size());
  for (const DescriptorCluster& cluster : clusters) centres.push_back(cluster.centre);
  return centres;
}

}  // namespace

Descriptor MajorityOf(const std::vector<Descriptor>& descriptors, const Members& members,
                      const Descriptor& before) {
  constexpr std::size_t kBits = 64;
  std::array<std::size_t, kBits * std::tuple_size_v<Descriptor>> counts{};
  for (const std::uint32_t member : members) {
    for (std::size_t bit = 0; bit < counts.size(); ++bit) {
      counts[bit] += descriptors[member][bit / kBits] >> (bit % kBits) & 1U;
    }
  }
  Descriptor majority = before;
  for (std::size_t bit = 0; bit < counts.size(); ++bit) {
    const std::uint64_t mask = std::uint64_t{1} << (bit % kBits);
    if (2 * counts[bit] > members.size()) majority[bit / kBits] |= mask;
    if (2 * counts[bit] < members.size()) majority[bit / kBits] &= ~mask;
  }
  return majority;
}

std::vector<DescriptorCluster> KMedians(const std::vector<Descriptor>& descriptors,
                                        const Members& members, int k, int iterations,
                                        RandomStream& random) {
  std::vector<Descriptor> centres = FirstCentres(descriptors, members, k, random);
  std::vector<DescriptorCluster> clusters = Assign(descriptors, members, centres);
  for (int i = 0; i < iterations; ++i) {
    for (DescriptorCluster& cluster : clusters) {
      cluster.centre = MajorityOf(descriptors, cluster.members, cluster.centre);
    }
    const std::vector<Descriptor> moved = CentresOf(clusters);
    if (moved == centres) break;
    centres = moved;
    clusters = Assign(descriptors, members, centres);
  }
  return clusters;
}

}  // namespace drydock::svin2
