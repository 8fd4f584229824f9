#include "scenarios/gallery/bus_views.h"

#include "sensors_models/base/resources.h"

namespace drydock {

BusViews::BusViews()
    : scenario_(LoadScenario(DataDirectory() / "scenarios" / "bus.yaml")),
      rig_(LoadRig(FindRig(scenario_.rig))),
      motion_(scenario_.motion, scenario_.seed),
      world_(scenes::PrepareScene(scenario_.scene.name, scenario_.scene.seed, CacheDirectory())),
      rays_(world_) {}

std::vector<cv::Mat> BusViews::LeftImages(const sim::WaterConfig& water, bool color,
                                          std::span<const double> moments) {
  sim::ImageSensorConfig image = scenario_.sensors.image;
  image.color = color;
  sim::StereoCamera camera({motion_, world_, rays_, motion_.End()}, rig_.stereo, water, image,
                           false, sim::RendererBackend::kAuto, scenario_.seed);
  std::vector<cv::Mat> images;
  for (const double moment : moments)
    images.push_back(camera.Look(motion_.At(Time::FromSeconds(moment)).T_WI, nullptr).images[0]);
  return images;
}

}  // namespace drydock
