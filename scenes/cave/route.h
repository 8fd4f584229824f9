// The way that stays free, as a line that distances can be asked of.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace drydock::scenes::cave {

class Route {
 public:
  /// Two points or more [m, in W].
  explicit Route(std::vector<Eigen::Vector3d> points);

  /// From `p` to the line [m].
  double Distance(const Eigen::Vector3d& p) const;
  struct Below {
    double distance = 0.0;  ///< horizontally [m]
    double z = 0.0;         ///< of the line where it is nearest horizontally [m, in W]
  };
  /// What passes over (or under) a place.
  Below Over(double x, double y) const;
  /// Whether `p` is farther than `distance` [m] from the line; cheaper than the distance itself.
  bool IsFarther(const Eigen::Vector3d& p, double distance) const;

  const std::vector<Eigen::Vector3d>& points() const { return points_; }

 private:
  std::vector<Eigen::Vector3d> points_;
  double longest_ = 0.0;  ///< stretch between points [m]
};

}  // namespace drydock::scenes::cave
