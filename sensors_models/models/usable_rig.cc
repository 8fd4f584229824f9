#include "sensors_models/models/usable_rig.h"

#include <fmt/format.h>

#include "sensors_models/base/check.h"
#include "sensors_models/models/camera_model.h"
#include "sensors_models/models/equidistant.h"

namespace drydock {

Rig LoadUsableRig(const std::filesystem::path& path, const YamlNode& changes) {
  YamlNode root = LoadYaml(path);
  SetAllYaml(root, changes);
  Rig rig = ReadRig(root);
  const YamlNode& cameras = *root.Find("stereo")->Find("cameras");  // ReadRig insists on both.
  for (std::size_t i = 0; i < rig.stereo.cameras.size(); ++i) {
    const CameraIntrinsics& camera = rig.stereo.cameras[i];
    const std::string key = LensKey(camera.lens);
    const std::string line = cameras.items[i].Find(key)->place.ToString();
    RequireUsable(camera, fmt::format("{}: stereo.cameras.{}.{}", line, i, key));
  }
  return rig;
}

void RequireUsable(const CameraIntrinsics& camera, const std::string& place) {
  constexpr int kSteps = 64;  // From border to border, both included.
  const CameraModel model(camera);
  if (camera.lens == LensModel::kEquidistant &&
      EquidistantLens::Reach(camera.distortion) == EquidistantLens::kWidest) {
    const Eigen::Vector2d middle(0.5 * (camera.width - 1.0), 0.5 * (camera.height - 1.0));
    RequireInput(model.Unproject(middle).has_value(),
                 "{}: the middle of the image looks more than 85 degrees off the lens's axis, must "
                 "look ahead",
                 place);
    return;
  }
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
