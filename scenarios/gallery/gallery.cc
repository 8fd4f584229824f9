#include "scenarios/gallery/gallery.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "scenarios/gallery/bus_views.h"
#include "scenarios/gallery/picture_rows.h"

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

}  // namespace

void WriteGallery(const std::filesystem::path& path) {
  BusViews views;
  std::vector<PictureRow> rows;
  for (const Condition& condition : Conditions()) {
    sim::WaterConfig water = views.water();
    condition.set(water);
    rows.push_back({condition.label, views.LeftImages(water, true, kMoments)});
  }
  WritePictureRows(path, rows);
}

}  // namespace drydock
