// Clusters of binary descriptors.
#pragma once

#include <cstdint>
#include <vector>

#include "estimator/svin2/frontend/descriptor.h"
#include "sensors_models/base/random_stream.h"

namespace drydock::svin2 {

struct DescriptorCluster {
  Descriptor centre{};
  std::vector<std::uint32_t> members;  ///< Places among all descriptors, rising.
};

/// The bits that most of the members have; where it is half of them, those of `before`.
Descriptor MajorityOf(const std::vector<Descriptor>& descriptors,
                      const std::vector<std::uint32_t>& members, const Descriptor& before);

/// Divides `members` among at most k clusters so that each lies with the centre that differs in the
/// fewest bits (ties: the first), after `iterations` rounds at most. No cluster is empty; there are
/// fewer than k if there are fewer different descriptors.
std::vector<DescriptorCluster> KMedians(const std::vector<Descriptor>& descriptors,
                                        const std::vector<std::uint32_t>& members, int k,
                                        int iterations, RandomStream& random);

}  // namespace drydock::svin2
