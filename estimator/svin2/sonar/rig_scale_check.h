// Whether the sonar finds the scale of the stereo rig right.
#pragma once

#include <optional>
#include <string>

namespace drydock::svin2 {

/// A rig whose baseline is wrong makes everything too large or too small by the same share, and the
/// window cannot tell: hundreds of points a frame hold to the rig, one ping to the sonar. But over
/// a minute the pings' errors say it plainly. Least squares of
///   innovation = share * range,
/// each weighed by the variances of range and patch.
class RigScaleCheck {
 public:
  struct Config {
    int min_pings = 60;
    double min_share = 0.01;  ///< Less than this is not worth a word.
    double min_sigmas = 5.0;  ///< Of the share's standard deviation: patches err alike for a while.
  };

  struct Finding {
    double share = 0.0;  ///< What ranges are longer by than landmarks have it.
    double sigma = 0.0;
  };

  explicit RigScaleCheck(const Config& config) : config_(config) {}

  /// A ping at `range` that met its patch's plane `innovation` too late [m]; `sigma`: of that [m].
  void Add(double range, double innovation, double sigma);
  std::optional<Finding> Found() const;
  /// The first time that the rig is found to be wrong: what to say of it.
  std::optional<std::string> Complaint();

 private:
  Config config_;
  int pings_ = 0;
  double information_ = 0.0, product_ = 0.0;
  bool said_ = false;
};

}  // namespace drydock::svin2
