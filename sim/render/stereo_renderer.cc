#include "sim/render/stereo_renderer.h"

#include <algorithm>

#include "sensors_models/base/check.h"

namespace drydock::sim {

StereoRenderer::StereoRenderer(World& world, RendererBackend backend,
                               const std::array<Pinhole, 2>& pinholes, double far_m)
    : pinholes_(pinholes) {
  worker_.Run([&] {
    renderer_ =
        std::make_unique<Renderer>(world, backend, std::max(pinholes[0].width, pinholes[1].width),
                                   std::max(pinholes[0].height, pinholes[1].height));
    renderer_->SetFar(far_m);
    backend_name_ = renderer_->BackendName();
    device_name_ = renderer_->DeviceName();
  });
}

StereoRenderer::~StereoRenderer() {
  worker_.Submit([this] { renderer_.reset(); }).wait();
}

void StereoRenderer::Begin(const std::array<Pose, 2>& T_WC, const MovingPoses& moving) {
  Check(!HasBegun(), "a pair is being drawn already");
  drawing_ = worker_.Submit([this, T_WC, moving] {
    renderer_->Place(moving);
    for (std::size_t eye = 0; eye < 2; ++eye)
      renderer_->Render(T_WC[eye], pinholes_[eye], pairs_[in_work_][eye]);
  });
}

const RawPair& StereoRenderer::Finish() {
  Check(HasBegun(), "no pair is being drawn");
  drawing_.get();
  const RawPair& pair = pairs_[in_work_];
  in_work_ = 1 - in_work_;
  return pair;
}

}  // namespace drydock::sim
