#include "sim/sensors/stereo_camera.h"

#include <algorithm>

namespace drydock::sim {

StereoCamera::StereoCamera(const Motion& motion, World& world, const StereoSheet& sheet,
                           const WaterConfig& water, const ImageSensorConfig& image,
                           bool depth_images, RendererBackend backend)
    : motion_(motion),
      sheet_(sheet),
      channels_(image.color ? ImageChannels::kColor : ImageChannels::kMonochrome),
      depth_images_(depth_images),
      eyes_{Eye(sheet.cameras[0], water), Eye(sheet.cameras[1], water)},
      image_sensor_(image) {
  const Pinhole& left = eyes_[0].lens.source();
  const Pinhole& right = eyes_[1].lens.source();
  renderer_ = std::make_unique<Renderer>(world, backend, std::max(left.width, right.width),
                                         std::max(left.height, right.height));
}

Observation StereoCamera::Observe() {
  const Time t = NextTime();
  StereoTruth truth;
  StereoFrame frame = Look(motion_.At(t).T_WI, depth_images_ ? &truth : nullptr);
  frame.index = next_++;
  return {{t, t, std::move(frame)}, std::move(truth)};
}

StereoFrame StereoCamera::Look(const Pose& T_WI, StereoTruth* truth) {
  StereoFrame frame;
  for (std::size_t eye = 0; eye < eyes_.size(); ++eye) {
    frame.images[eye] =
        LookWith(eye, T_WI * sheet_.T_IC[eye], truth == nullptr ? nullptr : &truth->depth[eye]);
  }
  return frame;
}

cv::Mat StereoCamera::LookWith(std::size_t eye, const Pose& T_WC, cv::Mat* depth) {
  const Lens& lens = eyes_[eye].lens;
  renderer_->Render(T_WC, lens.source(), raw_);
  eyes_[eye].optics.Apply(raw_, T_WC, channels_, radiance_);
  lens.ApplySmooth(radiance_, through_lens_);
  cv::Mat image;
  image_sensor_.Expose(through_lens_, image);
  if (depth != nullptr) lens.ApplyNearest(raw_.depth, *depth);
  return image;
}

}  // namespace drydock::sim
