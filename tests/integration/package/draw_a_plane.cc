// Draws a plane 2 m ahead and looks at how far away its middle is drawn. Fails to draw unless the
// program exports the OpenGL look-up that MuJoCo calls: the package has to ask the linker for that.
// Usage: draw_a_plane FILE, where the scene is written to.
#include <cmath>
#include <cstdio>
#include <fstream>

#include "sim/render/renderer.h"

int main(int argc, char** argv) {
  using namespace drydock;
  if (argc != 2) return 2;
  const char* scene = argv[1];
  std::ofstream(scene) << R"(<mujoco><worldbody>
    <geom type="plane" pos="0 0 2" zaxis="0 0 -1" size="5 5 0.1"/>
  </worldbody></mujoco>)";
  sim::World world(scene);
  sim::Renderer renderer(world, sim::RendererBackend::kAuto, 64, 48);
  sim::RawImage image;
  renderer.Render(Pose::Identity(), {64, 48, 50.0, 31.5, 23.5}, image);
  const float depth = image.depth.at<float>(24, 32);
  std::printf("%s: %.4f m\n", renderer.BackendName().c_str(), depth);
  return std::abs(depth - 2.0F) < 0.01F ? 0 : 1;
}
