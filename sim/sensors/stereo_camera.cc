#include "sim/sensors/stereo_camera.h"

#include <algorithm>
#include <string>
#include <utility>

#include "sensors_models/base/check.h"

namespace drydock::sim {
namespace {

/// Beyond this nothing is seen [m].
double FarthestSurface(const WaterConfig& water, const std::vector<LampConfig>& lamps) {
  const double by_day = water.daylight > 0.0 ? FarthestLight(water) : 0.0;
  const double by_lamp = FarthestLampLight(water, lamps);
  return std::clamp(std::max(by_day, by_lamp), 1.0, Renderer::kFar);
}

}  // namespace

StereoCamera::Eye StereoCamera::MakeEye(std::size_t eye, const WaterConfig& water,
                                        const std::vector<LampConfig>& lamps, const RayScene& rays,
                                        const StereoCameraConfig& config, std::uint64_t seed) {
  Lens lens(sheet_.cameras[eye], config.flat_port);
  const Pinhole& view = lens.source();
  std::optional<LampLight> lamp_light;
  if (!lamps.empty())
    lamp_light.emplace(lamps, sheet_.T_IC[eye], water, view, water.shadows ? &rays : nullptr);
  UnderwaterOptics optics(water, view, shadows_ ? &*shadows_ : nullptr, std::move(lamp_light),
                          caustics_ ? &*caustics_ : nullptr);
  std::optional<Silt> silt;
  if (!water.silt.empty()) silt.emplace(water.silt, water, view, seed);
  std::optional<MarineSnow> snow;
  if (water.snow) snow.emplace(*water.snow, water, view, seed);
  ImageSensor sensor(sheet_.imager, config.image, sheet_.cameras[eye], seed,
                     "cam" + std::to_string(eye) + "/noise");
  return {std::move(lens), std::move(optics), std::move(silt),
          std::move(snow), std::move(sensor), {}};
}

StereoCamera::StereoCamera(const Surroundings& surroundings, const StereoSheet& sheet,
                           const WaterConfig& water, const std::vector<LampConfig>& lamps,
                           const StereoCameraConfig& config, RendererBackend backend,
                           std::uint64_t seed)
    : motion_(surroundings.motion),
      moving_(surroundings.world.moving()),
      end_(surroundings.end),
      sheet_(sheet),
      channels_(config.image.color ? ImageChannels::kColor : ImageChannels::kMonochrome),
      depth_images_(config.depth_images),
      shadows_(water.shadows && water.daylight > 0.0
                   ? std::make_optional<DaylightGrid>(surroundings.rays, DirectionToSun(water))
                   : std::nullopt),
      caustics_(water.caustics.slope_rms > 0.0 && water.daylight > 0.0
                    ? std::make_optional<Caustics>(water.caustics, water, seed)
                    : std::nullopt),
      eyes_{MakeEye(0, water, lamps, surroundings.rays, config, seed),
            MakeEye(1, water, lamps, surroundings.rays, config, seed)},
      auto_exposure_(sheet.imager, config.image.exposure),
      renderer_(surroundings.world, backend, {eyes_[0].lens.source(), eyes_[1].lens.source()},
                FarthestSurface(water, lamps)) {}

std::array<Pose, 2> StereoCamera::EyePoses(const Pose& T_WI) const {
  return {T_WI * sheet_.T_IC[0], T_WI * sheet_.T_IC[1]};
}

void StereoCamera::BeginDrawing(Time t, const Pose& T_WI) {
  renderer_.Begin(EyePoses(T_WI), moving_.At(t, T_WI));
}

Observation StereoCamera::Observe() {
  const Time t = NextTime();
  const Pose T_WI = motion_.At(t).T_WI;
  if (!renderer_.HasBegun()) BeginDrawing(t, T_WI);
  const RawPair& raw = renderer_.Finish();
  const Time next = SampleTime(Time{}, next_ + 1, sheet_.rate_hz);
  if (next <= end_) BeginDrawing(next, motion_.At(next).T_WI);

  StereoTruth truth;
  const double light = Gather(raw, T_WI, t, depth_images_ ? &truth : nullptr);
  StereoFrame frame = Expose(auto_exposure_.Next(t, light));
  ++next_;
  return {{t, t, std::move(frame)}, std::move(truth)};
}

StereoFrame StereoCamera::Look(const Pose& T_WI, StereoTruth* truth, Time t) {
  Check(!renderer_.HasBegun(), "look before the dive or after it");
  BeginDrawing(t, T_WI);
  return Expose(auto_exposure_.Settled(Gather(renderer_.Finish(), T_WI, t, truth)));
}

void StereoCamera::See(Eye& eye, const RawImage& raw, const Pose& T_WC, Time t) {
  eye.optics.Apply(raw, T_WC, channels_, radiance_);
  const LightAt light = [&](const Eigen::Vector3d& p_W) {
    return eye.optics.LightOnBall(p_W, T_WC, eye.silt ? eye.silt->DaylightLeft(p_W, t) : 1.0);
  };
  if (eye.silt) eye.silt->AddTo(raw.depth, T_WC, t, channels_, light, radiance_);
  if (eye.snow) {
    eye.snow->AddTo(raw.depth, T_WC, t, channels_, light, radiance_,
                    eye.silt ? &*eye.silt : nullptr);
  }
}

double StereoCamera::Gather(const RawPair& raw, const Pose& T_WI, Time t, StereoTruth* truth) {
  const std::array<Pose, 2> T_WC = EyePoses(T_WI);
  if (caustics_) caustics_->SetTime(t);
  double light = 0.0;
  for (std::size_t i = 0; i < eyes_.size(); ++i) {
    Eye& eye = eyes_[i];
    See(eye, raw[i], T_WC[i], t);
    eye.lens.ApplySmooth(radiance_, raw[i].depth, eye.light);
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
