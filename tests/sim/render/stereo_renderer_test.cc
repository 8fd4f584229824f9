#include "sim/render/stereo_renderer.h"

#include <cstring>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"
#include "tests/support/test_scene.h"

namespace drydock::sim {
namespace {

bool Equal(const cv::Mat& a, const cv::Mat& b) {
  return a.type() == b.type() && a.size() == b.size() && a.isContinuous() && b.isContinuous() &&
         std::memcmp(a.data, b.data, a.total() * a.elemSize()) == 0;
}

class StereoRendererTest : public ::testing::Test {
 protected:
  /// Where both eyes are at step `k`: on their way towards a box, looking along x.
  static std::array<Pose, 2> EyesAt(int k) {
    const Eigen::Quaterniond q_WC(0.5, -0.5, 0.5, -0.5);
    return {Pose(q_WC, {0.1 * k, 0.07, 0.0}), Pose(q_WC, {0.1 * k, -0.07, 0.0})};
  }

  static constexpr Pinhole kPinhole{160, 120, 120.0, 79.5, 59.5};
  static constexpr double kFar = 20.0;
  testing::TemporaryFolder folder_;
  World world_{testing::WriteScene(folder_.path(),
                                   testing::BoxElement("box", {3.0, 0.1, 0.0}, {0.3, 0.4, 0.5}))};
};

// A pair in hand stays as it is while the next one is drawn on the other thread.
TEST_F(StereoRendererTest, DrawsAheadWhatARendererDraws) {
  constexpr int kSteps = 5;
  StereoRenderer ahead(world_, RendererBackend::kAuto, {kPinhole, kPinhole}, kFar);
  std::vector<RawPair> drawn;
  ahead.Begin(EyesAt(0));
  for (int k = 0; k < kSteps; ++k) {
    const RawPair& pair = ahead.Finish();
    if (k + 1 < kSteps) ahead.Begin(EyesAt(k + 1));
    RawPair& copy = drawn.emplace_back();
    for (std::size_t eye = 0; eye < 2; ++eye)
      copy[eye] = {pair[eye].albedo.clone(), pair[eye].depth.clone()};
  }
  EXPECT_FALSE(ahead.HasBegun());
  EXPECT_FALSE(Equal(drawn[0][0].depth, drawn[1][0].depth));

  Renderer renderer(world_, RendererBackend::kAuto, kPinhole.width, kPinhole.height);
  renderer.SetFar(kFar);
  for (int k = 0; k < kSteps; ++k) {
    for (std::size_t eye = 0; eye < 2; ++eye) {
      RawImage image;
      renderer.Render(EyesAt(k)[eye], kPinhole, image);
      EXPECT_TRUE(Equal(drawn[static_cast<std::size_t>(k)][eye].albedo, image.albedo)) << k;
      EXPECT_TRUE(Equal(drawn[static_cast<std::size_t>(k)][eye].depth, image.depth)) << k;
    }
  }
}

TEST_F(StereoRendererTest, OnePairAtATime) {
  StereoRenderer renderer(world_, RendererBackend::kAuto, {kPinhole, kPinhole}, kFar);
  EXPECT_THROW(renderer.Finish(), std::logic_error);
  renderer.Begin(EyesAt(0));
  EXPECT_THROW(renderer.Begin(EyesAt(1)), std::logic_error);
}  // What was begun is waited for.

}  // namespace
}  // namespace drydock::sim
