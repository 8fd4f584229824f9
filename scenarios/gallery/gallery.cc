#include "scenarios/gallery/gallery.h"

#include <string>
#include <vector>

#include "scenarios/gallery/dive_views.h"
#include "scenarios/gallery/picture_rows.h"

namespace drydock {
namespace {

struct LabelledViews {
  std::string label;
  DiveViews views;
};

constexpr const char* kColor = "sensors.stereo.color=true";
constexpr const char* kTwoLamps =
    "lamps=[{position_m: [0.1, 0.35, 0.1], yaw_deg: -8, pitch_deg: 10, intensity_cd: 4000}, "
    "{position_m: [0.1, -0.35, 0.1], yaw_deg: 8, pitch_deg: 10, intensity_cd: 4000}]";

/// Along the side of the bus, at its front, inside.
DiveViews Bus(std::vector<std::string> overrides) {
  overrides.emplace_back(kColor);
  return {"bus", std::move(overrides), {2.0, 33.0, 91.0}};
}

void Write(const std::filesystem::path& path, const std::vector<LabelledViews>& all) {
  std::vector<PictureRow> rows;
  rows.reserve(all.size());
  for (const auto& [label, views] : all) rows.push_back({label, LeftImages(views)});
  WritePictureRows(path, rows);
}

}  // namespace

void WriteWaters(const std::filesystem::path& path) {
  Write(path, {{"V = 12 m", Bus({"water.visibility_m=12"})},
               {"V = 6 m", Bus({"water.visibility_m=6"})},
               {"V = 3 m", Bus({"water.visibility_m=3"})},
               {"V = 12 m, dusk: 1/200 of full sun, all from the sky",
                Bus({"water.daylight=0.005", "water.sun_share=0"})}});
}

void WriteDives(const std::filesystem::path& path) {
  Write(path, {{"bus", Bus({})},
               {"cavern1", {"cavern1", {kColor}, {5.0, 60.0, 120.0}}},
               {"cavern2", {"cavern2", {kColor}, {20.0, 100.0, 180.0}}},
               {"cemetery", {"cemetery", {kColor}, {5.0, 45.0, 90.0}}},
               {"cemetery, were its water clear",
                {"cemetery",
                 {kColor, "water.visibility_m=20", "water.jerlov_type=II", "water.daylight=1"},
                 {5.0, 45.0, 90.0}}}});
}

void WriteEffects(const std::filesystem::path& path) {
  Write(path,
        {{"at night, by two lamps", Bus({"water.daylight=0", kTwoLamps})},
         {"the same in a snow storm",
          Bus({"water.daylight=0", kTwoLamps, "water.snow={density_m3: 300}"})},
         {"caustics, 3 m below the surface",
          Bus({"water.surface_z_m=3", "water.visibility_m=20", "water.sun_share=0.65",
               "water.caustics={slope_rms: 0.1}"})},
         {"a cloud of silt",
          Bus({"water.silt=[{position_m: [4.0, -1.2, -0.6], radius_m: 0.8, attenuation_1_m: 8}, "
               "{position_m: [11.5, -3.0, -0.4], radius_m: 0.7, attenuation_1_m: 8}, "
               "{position_m: [6.5, -3.2, 0.0], radius_m: 0.6, attenuation_1_m: 8}]"})},
         {"fish, and the diver's arm",
          Bus({"moving=[{what: fish, count: 12, centre_m: [3.0, -0.8, 0.2], radius_m: 1.0}, "
               "{what: fish, count: 12, centre_m: [11.5, -2.2, 0.6], radius_m: 1.2}, "
               "{what: diver_arm, from_s: 85, to_s: 100}]"})}});
}

}  // namespace drydock
