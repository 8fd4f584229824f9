// The simulated stereo camera.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "sensors_models/measurement/rig.h"
#include "sim/motion/motion.h"
#include "sim/optics/image_sensor.h"
#include "sim/optics/underwater_optics.h"
#include "sim/render/lens.h"
#include "sim/render/renderer.h"
#include "sim/sensors/sensor.h"

namespace drydock::sim {

/// Renderer, water, lens and sensor of two eyes that look at the same instant.
class StereoCamera final : public Sensor {
 public:
  /// `motion` and `world` must outlive the camera. InputError if no OpenGL can be had.
  StereoCamera(const Motion& motion, World& world, const StereoSheet& sheet,
               const WaterConfig& water, const ImageSensorConfig& image, bool depth_images,
               RendererBackend backend);

  Time NextTime() const override { return SampleTime(Time{}, next_, sheet_.rate_hz); }
  Observation Observe() override;

  /// What the camera sees from any pose, for calibration and tests.
  StereoFrame Look(const Pose& T_WI, StereoTruth* truth);

  const Renderer& renderer() const { return *renderer_; }

 private:
  struct Eye {
    Lens lens;
    UnderwaterOptics optics;
    Eye(const CameraIntrinsics& camera, const WaterConfig& water)
        : lens(camera), optics(water, lens.source()) {}
  };
  cv::Mat LookWith(std::size_t eye, const Pose& T_WC, cv::Mat* depth);

  const Motion& motion_;
  StereoSheet sheet_;
  ImageChannels channels_;
  bool depth_images_;
  std::array<Eye, 2> eyes_;
  ImageSensor image_sensor_;
  std::unique_ptr<Renderer> renderer_;
  std::int64_t next_ = 0;
  RawImage raw_;  ///< Reused from frame to frame, as are the next two.
  cv::Mat radiance_;
  cv::Mat through_lens_;
};

}  // namespace drydock::sim
