// The rig: where its sensors sit on the body and what their data sheets say. Simulator and
// estimator each read their own copy: the simulator the true one, the estimator what its maker
// believes.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "sensors_models/base/pose.h"
#include "sensors_models/base/yaml_node.h"

namespace drydock {

/// How a lens bends rays before they meet the sensor.
enum class LensModel {
  kRadtan,       ///< Radial and tangential polynomials, as OpenCV and EuRoC have it.
  kEquidistant,  ///< A polynomial in the angle off the axis, as cv::fisheye and Kalibr have it.
};

/// A pinhole behind a lens. Pixel centres lie on integers.
struct CameraIntrinsics {
  int width = 0;              ///< [px]
  int height = 0;             ///< [px]
  double fx = 0.0, fy = 0.0;  ///< Focal lengths [px].
  double cx = 0.0, cy = 0.0;  ///< Principal point [px].
  /// Radtan: k1, k2 (radial), p1, p2 (tangential). Equidistant: k1 to k4.
  std::array<double, 4> distortion = {0.0, 0.0, 0.0, 0.0};
  LensModel lens = LensModel::kRadtan;
};

/// What a camera's sensor makes of light. Radiance 1 is what a white card sends out that lies flat
/// under the full daylight of the surface. The defaults have no flaws.
struct ImagerSheet {
  double gamma = 2.2;               ///< Code = 255 * (share of the full well)^(1/gamma).
  double sensitivity_per_s = 2000;  ///< Share of the full well that radiance 1 fills in a second.
  double shutter_max_s = 0.01;      ///< Longest exposure; beyond it gain makes up.
  double gain_max_db = 24.0;
  double auto_exposure_target = 0.2;  ///< Mean share of the full well that it aims at.
  double auto_exposure_time_s = 0.0;  ///< Time constant of its first-order lag; 0 follows at once.
  double full_well_e = 0.0;           ///< Electrons at saturation without gain; 0: no shot noise.
  double read_noise_e = 0.0;          ///< Standard deviation [electrons]; needs the full well.
  double vignetting = 0.0;            ///< Light falls off as cos^(4 vignetting) of the field angle.
};

struct StereoSheet {
  double rate_hz = 0.0;
  ImagerSheet imager;                       ///< Of both cameras.
  std::array<CameraIntrinsics, 2> cameras;  ///< Left, right.
  std::array<Pose, 2> T_IC;                 ///< Camera (x right, y down, z forward) to body.
};

struct ImuSheet {
  double rate_hz = 0.0;
  double gyro_noise_density = 0.0;   ///< [rad/s/sqrt(Hz)]
  double accel_noise_density = 0.0;  ///< [m/s^2/sqrt(Hz)]
  double gyro_bias_walk = 0.0;       ///< [rad/s^2/sqrt(Hz)]
  double accel_bias_walk = 0.0;      ///< [m/s^3/sqrt(Hz)]
  double gyro_turn_on_bias = 0.0;    ///< Standard deviation of the initial bias [rad/s].
  double accel_turn_on_bias = 0.0;   ///< Standard deviation of the initial bias [m/s^2].
  // Not every sheet says these; 0 is none.
  double gyro_scale_error = 0.0;    ///< Standard deviation, of each axis, as a share.
  double accel_scale_error = 0.0;   ///< Standard deviation, of each axis, as a share.
  double gyro_misalignment = 0.0;   ///< Standard deviation of one axis towards another [rad].
  double accel_misalignment = 0.0;  ///< Standard deviation of one axis towards another [rad].
  double gyro_range = 0.0;          ///< Largest reading [rad/s]; 0: no limit.
  double accel_range = 0.0;         ///< Largest reading [m/s^2]; 0: no limit.
  double gyro_resolution = 0.0;     ///< Step between readings [rad/s].
  double accel_resolution = 0.0;    ///< Step between readings [m/s^2].
};

/// A profiling sonar whose head turns by a fixed step each ping; it scans the x-y plane of S.
///
/// Everything below range_noise_m may be left out: the sonar is then a single exact ray with white
/// noise. Amplitudes are shares of full scale, which is the echo of a face that throws back
/// everything, met squarely by the whole beam within one bin, at the head. The receiver's gain
/// grows with range so as to make up for the spreading of sound.
struct SonarSheet {
  double rate_hz = 0.0;
  Pose T_IS;
  double step_rad = 0.0;  ///< Turn of the head from ping to ping.
  double min_range_m = 0.0;
  double max_range_m = 0.0;
  double range_noise_m = 0.0;  ///< Standard deviation of white noise, without the bins' rounding.

  double beam_width_rad = 0.0;      ///< Of the cone, full, where one way is 3 dB down; 0 is a ray.
  int bins = 0;                     ///< Of equal length up to max_range_m; 0: no echo profile.
  double pulse_length_s = 0.0;      ///< Spreads an echo over c/2 times this.
  double incidence_exponent = 2.0;  ///< Of cos(incidence) in the backscatter of a unit of area.
  double absorption_db_m = 0.0;     ///< By the water, one way.
  double gain_absorption_db_m = 0.0;  ///< How much of it the gain makes up for, one way.
  int speckle_looks = 0;              ///< Independent echoes averaged in a bin; 0: no speckle.
  double noise_floor = 0.0;           ///< RMS amplitude of the noise at max_range_m.
  double dropout_probability = 0.0;   ///< Of losing a whole ping.
  double intensity_floor = 0.0;       ///< Amplitude that an echo must be above to count.
};

struct DepthSheet {
  double rate_hz = 0.0;
  Eigen::Vector3d p_ID = Eigen::Vector3d::Zero();  ///< Position of the pressure port [m], in I.
  double noise_m = 0.0;                            ///< Standard deviation of white noise.
  // Not every sheet says these; 0 is none.
  double offset_m = 0.0;      ///< Standard deviation of the offset, which is constant in a dive.
  double lag_s = 0.0;         ///< Time constant of a lag of first order.
  double resolution_m = 0.0;  ///< Step between readings.
};

/// A rig without sonar or without pressure sensor has rate_hz = 0 there.
struct Rig {
  std::string name;
  StereoSheet stereo;
  ImuSheet imu;
  SonarSheet sonar;
  DepthSheet depth;

  bool HasSonar() const { return sonar.rate_hz > 0.0; }
  bool HasDepth() const { return depth.rate_hz > 0.0; }
};

/// The key of a rig's YAML that has the coefficients of such a lens: "radtan" or "equidistant".
std::string LensKey(LensModel lens);

/// What a coefficient of such a lens may be at most, either way: beyond that it is a slip.
double LargestDistortion(LensModel lens);

/// Reads a rig's YAML strictly; InputError with file, line and key.
Rig ReadRig(const YamlNode& root);
Rig LoadRig(const std::filesystem::path& path);

/// The names of the rigs that come with Drydock, sorted.
std::vector<std::string> KnownRigs();

/// The file of a rig that comes with Drydock ("svin2_v3"), or `name_or_path` itself if it ends in
/// .yaml.
std::filesystem::path FindRig(const std::string& name_or_path);

}  // namespace drydock
