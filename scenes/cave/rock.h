// The rock around a cave, and the sand on its floor, as functions of the place.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "scenes/cave/plan.h"
#include "scenes/cave/route.h"

namespace drydock::scenes::cave {

/// About how far it is to the rock: positive in the water, negative in the rock [m]. Rooms and
/// passages are joined smoothly and bent by large noise; then beds of unequal hardness make ledges,
/// joints are widened, pockets and scallops are dissolved, the rest is rough.
class RockField {
 public:
  RockField(const CavePlan& plan, std::uint64_t seed);

  /// `p` [m, in W].
  double At(const Eigen::Vector3d& p) const;
  /// Of the rooms alone, without what is smaller than some decimetres.
  double Open(const Eigen::Vector3d& p) const;

  const Route& route() const { return route_; }
  const CavePlan& plan() const { return plan_; }
  /// The first rock above `p`, or below it, within `reach` [m]; p's height plus or minus `reach` if
  /// there is none. `p` is in the water.
  double CeilingOver(const Eigen::Vector3d& p, double reach) const;
  double BottomUnder(const Eigen::Vector3d& p, double reach) const;

 private:
  double Detail(const Eigen::Vector3d& p) const;
  double Beds(const Eigen::Vector3d& p) const;
  double Joints(const Eigen::Vector3d& p) const;
  double FirstRock(Eigen::Vector3d p, double step, double reach) const;

  CavePlan plan_;
  Route route_;
  std::uint64_t key_;
};

/// Sand with ripples that has drifted against the walls.
class SandFloor {
 public:
  /// `rock` must outlive it.
  SandFloor(const RockField& rock, std::uint64_t seed);
  /// [m, in W].
  double Height(double x, double y) const;

 private:
  const RockField& rock_;
  std::uint64_t key_;
};

}  // namespace drydock::scenes::cave
