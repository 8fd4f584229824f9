#include "scenarios/gallery/dive_views.h"

#include "scenarios/runner/make_world.h"
#include "scenarios/runner/scenario.h"
#include "sensors_models/base/resources.h"
#include "sensors_models/measurement/rig.h"
#include "sim/motion/spline_motion.h"
#include "sim/sensors/stereo_camera.h"

namespace drydock {

std::vector<cv::Mat> LeftImages(const DiveViews& views) {
  const Scenario scenario =
      LoadScenario(DataDirectory() / "scenarios" / (views.scenario + ".yaml"), views.overrides);
  const Rig rig = LoadRig(FindRig(scenario.rig));
  const sim::SplineMotion motion(scenario.motion, scenario.seed);
  sim::World world = MakeWorld(scenario);
  const sim::RayScene rays(world);
  sim::StereoCamera camera({motion, world, rays, motion.End()}, rig.stereo, scenario.water,
                           scenario.lamps, scenario.sensors.camera, sim::RendererBackend::kAuto,
                           scenario.seed);
  std::vector<cv::Mat> images;
  for (const double moment : views.moments) {
    const Time t = Time::FromSeconds(moment);
    images.push_back(camera.Look(motion.At(t).T_WI, nullptr, t).images[0]);
  }
  return images;
}

}  // namespace drydock
