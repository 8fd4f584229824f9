// The graves in their rows: which stone stands where, and what lies around it.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "scenes/cemetery/site.h"
#include "scenes/cemetery/stones.h"
#include "scenes/model/model.h"

namespace drydock::scenes::cemetery {

/// What is in front of a stone.
enum class Bed { kNone, kMound, kKerb };

struct Grave {
  Eigen::Vector2d foot = Eigen::Vector2d::Zero();  ///< [m], in W
  /// 0: the inscription looks to -y; counter-clockwise [rad].
  double yaw = 0.0;
  Shape shape = Shape::kRoundTop;
  int inscription = 0;  ///< in the atlas
  /// Forwards about the stone's foot [rad]; a fallen one about a quarter turn.
  double tip = 0.0;
  double lean = 0.0;  ///< sideways [rad]
  bool fallen = false;
  double sunk = 0.0;  ///< into the silt [m]
  Bed bed = Bed::kNone;
  bool urn = false;
};

/// The graves of a seed. The nearer to the way one lies, the earlier it gets an inscription: the
/// first kInscriptions all differ.
std::vector<Grave> LayOutGraves(std::uint64_t seed);

void AddGraves(SceneModel& model, const Ground& ground, const std::vector<Grave>& graves,
               std::uint64_t seed);

/// Iron railings around some of the graves.
void AddRailings(SceneModel& model, const Ground& ground, std::uint64_t seed);

}  // namespace drydock::scenes::cemetery
