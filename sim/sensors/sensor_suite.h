// All sensors of the rig, in order of arrival.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "sensors_models/measurement/rig.h"
#include "sim/optics/water_config.h"
#include "sim/render/gl_context.h"
#include "sim/sensors/imu.h"
#include "sim/sensors/sensor.h"
#include "sim/sensors/sensors_config.h"
#include "sim/sensors/stereo_camera.h"
#include "sim/world/ray_scene.h"

namespace drydock::sim {

/// Lets each sensor fire at its instants and hands the measurements out as the robot's computer
/// gets them. Order: arrival, then the sensors' rank (IMU, depth, sonar, stereo), then time of
/// measurement.
class SensorSuite {
 public:
  /// Everything passed by reference must outlive the suite. `rig` is the true one; sensors that it
  /// lacks or that the configuration switches off stay silent. Nothing is measured after `end`.
  SensorSuite(const Motion& motion, World& world, const RayScene& rays, const Rig& rig,
              const SensorsConfig& config, const WaterConfig& water,
              const std::vector<LampConfig>& lamps, RendererBackend backend, std::uint64_t seed,
              Time end);

  /// The next observation to arrive; nothing when there are no more.
  std::optional<Observation> Next();

  /// The IMU's biases now; zero if it is off.
  ImuTruth imu_truth() const { return imu_ == nullptr ? ImuTruth{} : imu_->truth(); }
  /// nullptr if the camera is off.
  const StereoCamera* camera() const { return camera_; }

 private:
  struct Slot {
    std::unique_ptr<Sensor> sensor;
    Duration latency;
  };
  struct Pending {
    std::size_t rank = 0;
    Observation observation;
  };
  void Insert(Pending pending);

  Time end_;
  std::vector<Slot> slots_;       ///< By rank.
  std::vector<Pending> pending_;  ///< Taken, not yet arrived; the next to arrive last.
  const Imu* imu_ = nullptr;
  const StereoCamera* camera_ = nullptr;
};

}  // namespace drydock::sim
