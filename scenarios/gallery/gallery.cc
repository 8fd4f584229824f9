#include "scenarios/gallery/gallery.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

#include <opencv2/imgcodecs.hpp>

#include "scenarios/report/canvas.h"
#include "scenarios/runner/scenario.h"
#include "scenes/scene.h"
#include "sensors_models/base/files.h"
#include "sensors_models/base/resources.h"
#include "sim/motion/spline_motion.h"
#include "sim/sensors/stereo_camera.h"

namespace drydock {
namespace {

struct Condition {
  std::string label;
  std::function<void(sim::WaterConfig&)> set;
};

const std::vector<Condition>& Conditions() {
  static const std::vector<Condition> conditions = {
      {"V = 12 m", [](sim::WaterConfig& water) { water.visibility_m = 12.0; }},
      {"V = 6 m", [](sim::WaterConfig& water) { water.visibility_m = 6.0; }},
      {"V = 3 m", [](sim::WaterConfig& water) { water.visibility_m = 3.0; }},
      {"V = 12 m, dusk: 1/200 of full sun, all from the sky",
       [](sim::WaterConfig& water) {
         water.visibility_m = 12.0;
         water.daylight = 0.005;
         water.sun_share = 0.0;
       }},
  };
  return conditions;
}

/// Moments of the dive [s]: along the side, the front, inside.
constexpr std::array<double, 3> kMoments = {2.0, 33.0, 91.0};
constexpr double kTileWidth = 400.0, kTileHeight = 300.0, kGap = 8.0, kLabel = 26.0;

cv::Mat DrawGallery() {
  const Scenario scenario = LoadScenario(DataDirectory() / "scenarios" / "bus.yaml");
  const Rig rig = LoadRig(FindRig(scenario.rig));
  const sim::SplineMotion motion(scenario.motion, scenario.seed);
  sim::World world(
      scenes::PrepareScene(scenario.scene.name, scenario.scene.seed, CacheDirectory()));
  const sim::RayScene rays(world);
  sim::ImageSensorConfig image = scenario.sensors.image;
  image.color = true;

  const double width = kMoments.size() * (kTileWidth + kGap) + kGap;
  const double height =
      static_cast<double>(Conditions().size()) * (kTileHeight + kLabel + kGap) + kGap;
  report::Canvas canvas(static_cast<int>(width), static_cast<int>(height), report::kPaper);
  double y = kGap;
  for (const Condition& condition : Conditions()) {
    sim::WaterConfig water = scenario.water;
    condition.set(water);
    sim::StereoCamera camera({motion, world, rays, motion.End()}, rig.stereo, water, image, false,
                             sim::RendererBackend::kAuto, scenario.seed);
    canvas.Text(condition.label, {kGap, y + 18.0}, 11.0, report::kInk);
    y += kLabel;
    double x = kGap;
    for (const double moment : kMoments) {
      const StereoFrame frame = camera.Look(motion.At(Time::FromSeconds(moment)).T_WI, nullptr);
      canvas.Picture(frame.images[0], {x, y, kTileWidth, kTileHeight});
      x += kTileWidth + kGap;
    }
    y += kTileHeight + kGap;
  }
  return canvas.Finish();
}

}  // namespace

void WriteGallery(const std::filesystem::path& path) {
  std::vector<unsigned char> bytes;
  cv::imencode(".jpg", DrawGallery(), bytes, {cv::IMWRITE_JPEG_QUALITY, 85});
  WriteFileAtomically(path, std::string(bytes.begin(), bytes.end()));
}

}  // namespace drydock
