// The simulated stereo camera.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "sensors_models/measurement/rig.h"
#include "sim/motion/motion.h"
#include "sim/optics/auto_exposure.h"
#include "sim/optics/caustics.h"
#include "sim/optics/daylight_grid.h"
#include "sim/optics/image_sensor.h"
#include "sim/optics/marine_snow.h"
#include "sim/optics/silt.h"
#include "sim/optics/underwater_optics.h"
#include "sim/render/lens.h"
#include "sim/render/stereo_renderer.h"
#include "sim/sensors/sensor.h"
#include "sim/sensors/sensors_config.h"
#include "sim/world/ray_scene.h"

namespace drydock::sim {

/// Renderer, water, lens and sensor of two eyes that look at the same instant. Both expose alike.
/// The next pair is drawn on a thread of its own while this one is worked on.
class StereoCamera final : public Sensor {
 public:
  /// What is around the camera; all of it must outlive the camera.
  struct Surroundings {
    const Motion& motion;
    World& world;
    const RayScene& rays;  ///< Casts the shadows.
    Time end;              ///< Nothing will be observed after this.
  };

  /// InputError if no OpenGL can be had.
  StereoCamera(const Surroundings& surroundings, const StereoSheet& sheet, const WaterConfig& water,
               const std::vector<LampConfig>& lamps, const StereoCameraConfig& config,
               RendererBackend backend, std::uint64_t seed);

  Time NextTime() const override { return SampleTime(Time{}, next_, sheet_.rate_hz); }
  Observation Observe() override;

  /// What the camera sees from any pose with its exposure settled, for calibration and tests; what
  /// moves is where it is at `t`.
  StereoFrame Look(const Pose& T_WI, StereoTruth* truth, Time t = {});

  const StereoRenderer& renderer() const { return renderer_; }

 private:
  struct Eye {
    Lens lens;
    UnderwaterOptics optics;
    std::optional<Silt> silt;
    std::optional<MarineSnow> snow;
    ImageSensor sensor;
    cv::Mat light;  ///< On the sensor.
  };
  Eye MakeEye(std::size_t eye, const WaterConfig& water, const std::vector<LampConfig>& lamps,
              const RayScene& rays, const StereoCameraConfig& config, std::uint64_t seed);
  std::array<Pose, 2> EyePoses(const Pose& T_WI) const;
  /// Has both eyes drawn from `T_WI`, with all that moves where it is at `t`.
  void BeginDrawing(Time t, const Pose& T_WI);
  /// What `eye` sees at `t` from `T_WC`, before its lens.
  void See(Eye& eye, const RawImage& raw, const Pose& T_WC, Time t);
  /// Fills each eye's light from what it sees at `t` and gives their mean.
  double Gather(const RawPair& raw, const Pose& T_WI, Time t, StereoTruth* truth);
  StereoFrame Expose(const Exposure& exposure);

  const Motion& motion_;
  const MovingThings& moving_;
  Time end_;
  StereoSheet sheet_;
  ImageChannels channels_;
  bool depth_images_;
  std::optional<DaylightGrid> shadows_;  ///< These two are shared by the eyes.
  std::optional<Caustics> caustics_;
  std::array<Eye, 2> eyes_;
  AutoExposure auto_exposure_;
  StereoRenderer renderer_;
  std::int64_t next_ = 0;
  cv::Mat radiance_;  ///< Reused from frame to frame.
};

}  // namespace drydock::sim
