#include "sim/sensors/stereo_camera.h"

#include <algorithm>
#include <string>
#include <utility>

namespace drydock::sim {

StereoCamera::Eye StereoCamera::MakeEye(std::size_t eye, const StereoSheet& sheet,
                                        const WaterConfig& water, const ImageSensorConfig& image,
                                        DaylightGrid* shadows, std::uint64_t seed) {
  Lens lens(sheet.cameras[eye]);
  UnderwaterOptics optics(water, lens.source(), shadows);
  ImageSensor sensor(sheet.imager, image, sheet.cameras[eye], seed,
                     "cam" + std::to_string(eye) + "/noise");
  return {std::move(lens), std::move(optics), std::move(sensor), {}};
}

StereoCamera::StereoCamera(const Surroundings& surroundings, const StereoSheet& sheet,
                           const WaterConfig& water, const ImageSensorConfig& image,
                           bool depth_images, RendererBackend backend, std::uint64_t seed)
    : motion_(surroundings.motion),
      sheet_(sheet),
      channels_(image.color ? ImageChannels::kColor : ImageChannels::kMonochrome),
      depth_images_(depth_images),
      shadows_(water.shadows
                   ? std::make_optional<DaylightGrid>(surroundings.rays, DirectionToSun(water))
                   : std::nullopt),
      eyes_{MakeEye(0, sheet, water, image, shadows_ ? &*shadows_ : nullptr, seed),
            MakeEye(1, sheet, water, image, shadows_ ? &*shadows_ : nullptr, seed)},
      auto_exposure_(sheet.imager, image.exposure) {
  const Pinhole& left = eyes_[0].lens.source();
  const Pinhole& right = eyes_[1].lens.source();
  renderer_ =
      std::make_unique<Renderer>(surroundings.world, backend, std::max(left.width, right.width),
                                 std::max(left.height, right.height));
}

Observation StereoCamera::Observe() {
  const Time t = NextTime();
  StereoTruth truth;
  const double light = Gather(motion_.At(t).T_WI, depth_images_ ? &truth : nullptr);
  StereoFrame frame = Expose(auto_exposure_.Next(t, light));
  ++next_;
  return {{t, t, std::move(frame)}, std::move(truth)};
}

StereoFrame StereoCamera::Look(const Pose& T_WI, StereoTruth* truth) {
  const double light = Gather(T_WI, truth);
  return Expose(auto_exposure_.Settled(light));
}

double StereoCamera::Gather(const Pose& T_WI, StereoTruth* truth) {
  double light = 0.0;
  for (std::size_t i = 0; i < eyes_.size(); ++i) {
    Eye& eye = eyes_[i];
    const Pose T_WC = T_WI * sheet_.T_IC[i];
    renderer_->Render(T_WC, eye.lens.source(), raw_);
    eye.optics.Apply(raw_, T_WC, channels_, radiance_);
    eye.lens.ApplySmooth(radiance_, eye.light);
    if (truth != nullptr) eye.lens.ApplyNearest(raw_.depth, truth->depth[i]);
    light += MeterLight(eye.light) / static_cast<double>(eyes_.size());
  }
  return light;
}

StereoFrame StereoCamera::Expose(const Exposure& exposure) {
  StereoFrame frame;
  frame.index = next_;
  for (std::size_t i = 0; i < eyes_.size(); ++i)
    eyes_[i].sensor.Expose(eyes_[i].light, exposure, next_, frame.images[i]);
  return frame;
}

}  // namespace drydock::sim
