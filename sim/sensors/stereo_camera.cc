#include "sim/sensors/stereo_camera.h"

#include <algorithm>
#include <string>
#include <utility>

#include "sensors_models/base/check.h"

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
      end_(surroundings.end),
      sheet_(sheet),
      channels_(image.color ? ImageChannels::kColor : ImageChannels::kMonochrome),
      depth_images_(depth_images),
      shadows_(water.shadows
                   ? std::make_optional<DaylightGrid>(surroundings.rays, DirectionToSun(water))
                   : std::nullopt),
      eyes_{MakeEye(0, sheet, water, image, shadows_ ? &*shadows_ : nullptr, seed),
            MakeEye(1, sheet, water, image, shadows_ ? &*shadows_ : nullptr, seed)},
      auto_exposure_(sheet.imager, image.exposure),
      renderer_(surroundings.world, backend, {eyes_[0].lens.source(), eyes_[1].lens.source()},
                std::min(FarthestLight(water), Renderer::kFar)) {}

std::array<Pose, 2> StereoCamera::EyePoses(const Pose& T_WI) const {
  return {T_WI * sheet_.T_IC[0], T_WI * sheet_.T_IC[1]};
}

Observation StereoCamera::Observe() {
  const Time t = NextTime();
  const Pose T_WI = motion_.At(t).T_WI;
  if (!renderer_.HasBegun()) renderer_.Begin(EyePoses(T_WI));
  const RawPair& raw = renderer_.Finish();
  const Time next = SampleTime(Time{}, next_ + 1, sheet_.rate_hz);
  if (next <= end_) renderer_.Begin(EyePoses(motion_.At(next).T_WI));

  StereoTruth truth;
  const double light = Gather(raw, T_WI, depth_images_ ? &truth : nullptr);
  StereoFrame frame = Expose(auto_exposure_.Next(t, light));
  ++next_;
  return {{t, t, std::move(frame)}, std::move(truth)};
}

StereoFrame StereoCamera::Look(const Pose& T_WI, StereoTruth* truth) {
  Check(!renderer_.HasBegun(), "look before the dive or after it");
  renderer_.Begin(EyePoses(T_WI));
  return Expose(auto_exposure_.Settled(Gather(renderer_.Finish(), T_WI, truth)));
}

double StereoCamera::Gather(const RawPair& raw, const Pose& T_WI, StereoTruth* truth) {
  const std::array<Pose, 2> T_WC = EyePoses(T_WI);
  double light = 0.0;
  for (std::size_t i = 0; i < eyes_.size(); ++i) {
    Eye& eye = eyes_[i];
    eye.optics.Apply(raw[i], T_WC[i], channels_, radiance_);
    eye.lens.ApplySmooth(radiance_, eye.light);
    if (truth != nullptr) eye.lens.ApplyNearest(raw[i].depth, truth->depth[i]);
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
