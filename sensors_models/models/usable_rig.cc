#include "sensors_models/models/usable_rig.h"

#include <fmt/format.h>

#include "sensors_models/base/check.h"
#include "sensors_models/models/camera_model.h"

namespace drydock {

Rig LoadUsableRig(const std::filesystem::path& path, const YamlNode& changes) {
  YamlNode root = LoadYaml(path);
  SetAllYaml(root, changes);
  Rig rig = ReadRig(root);
  const YamlNode& cameras = *root.Find("stereo")->Find("cameras");  // ReadRig insists on both.
  for (std::size_t i = 0; i < rig.stereo.cameras.size(); ++i) {
    const std::string line = cameras.items[i].Find("radtan")->place.ToString();
    RequireUsable(rig.stereo.cameras[i], fmt::format("{}: stereo.cameras.{}.radtan", line, i));
  }
  return rig;
}

void RequireUsable(const CameraIntrinsics& camera, const std::string& place) {
  constexpr int kSteps = 64;  // From border to border, both included.
  const CameraModel model(camera);
  for (int row = 0; row <= kSteps; ++row) {
    for (int column = 0; column <= kSteps; ++column) {
      const double u = (camera.width - 1.0) * column / kSteps;
      const double v = (camera.height - 1.0) * row / kSteps;
      RequireInput(model.Unproject({u, v}).has_value(),
                   "{}: the distortion folds over: it has no inverse at pixel ({:.0f}, {:.0f}), "
                   "must have one everywhere in the image",
                   place, u, v);
    }
  }
}

}  // namespace drydock
