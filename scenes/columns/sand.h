// The sand that the stones stand on, and the rubble in it.
#pragma once

#include <cstdint>

#include "scenes/model/model.h"

namespace drydock::scenes::columns {

inline constexpr double kSandTile = 6.0;  ///< One tile, one repetition of the texture [m].

/// The sand's shape, in world coordinates.
class Sand {
 public:
  explicit Sand(std::uint64_t seed);
  /// [m], in W.
  double Height(double x, double y) const;

 private:
  std::uint64_t key_;
};

void AddSand(SceneModel& model, const Sand& sand);
/// Low stones of one form, half buried, everywhere.
void AddRubble(SceneModel& model, const Sand& sand, std::uint64_t seed);

}  // namespace drydock::scenes::columns
