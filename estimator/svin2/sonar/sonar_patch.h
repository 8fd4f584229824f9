// The landmarks that lie where a ping's echo came from (paper, "Sonar range error").
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "estimator/svin2/frontend/tracked_frame.h"

namespace drydock::svin2 {

/// A ping, in W.
struct PingRay {
  Eigen::Vector3d head_W = Eigen::Vector3d::Zero();        ///< The sonar's head [m].
  Eigen::Vector3d direction_W = Eigen::Vector3d::UnitX();  ///< Of the beam's axis, length 1.
  double range = 0.0;                                      ///< [m]
};

struct PatchCandidate {
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();  ///< [m]
  std::optional<LandmarkId> id;                   ///< Of a landmark that is being estimated.
};

struct SonarPatch {
  std::vector<PatchCandidate> members;
  /// What to add to the ping's range so that it is that of the members' mean, which seldom lies on
  /// the beam: the mean's distance from the head, less that of the patch's plane along the beam
  /// [m].
  double range_correction = 0.0;
  double sigma = 0.0;       ///< Of the plane along the beam [m].
  double innovation = 0.0;  ///< The ping's range less the plane's [m].
};

struct SonarPatchConfig {
  double radius_m = 0.15;          ///< About the echo, at range 0.
  double radius_per_range = 0.05;  ///< Its growth: the beam's footprint and the pose's error.
  int min_landmarks = 4;
  int max_landmarks = 8;           ///< The nearest to the echo.
  double min_spread_m = 0.03;      ///< Of the patch in its plane, in its narrower direction (RMS).
  double max_roughness_m = 0.05;   ///< Of the patch across its plane (RMS).
  double min_incidence_cos = 0.5;  ///< Of the beam and the plane's normal.
  double max_innovation_m = 0.2;   ///< A ping further off met something else.
  /// What patches lie off the true face, beside what their scatter shows [m].
  double surface_sigma_m = 0.03;
};

/// The patch that a ping met: a plane through the landmarks about its echo. Nothing where they are
/// too few, lie in line, do not make a plane, or the beam grazes it.
std::optional<SonarPatch> FindSonarPatch(const PingRay& ping,
                                         std::span<const PatchCandidate> candidates,
                                         const SonarPatchConfig& config);

/// How far about a ping's echo FindSonarPatch() looks [m].
double PatchRadius(const PingRay& ping, const SonarPatchConfig& config);

}  // namespace drydock::svin2
