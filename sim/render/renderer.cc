#include "sim/render/renderer.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "sensors_models/base/check.h"
#include "sim/world/mujoco_errors.h"

namespace drydock::sim {
namespace {

/// Switches MuJoCo's own lighting off: every surface shows its texture times its colour, nothing
/// else.
void MakeUnlit(mjModel& model) {
  std::fill_n(model.light_active, model.nlight, mjtBool{0});
  auto& headlight = model.vis.headlight;
  headlight.active = 1;
  std::fill_n(headlight.ambient, 3, 1.F);
  std::fill_n(headlight.diffuse, 3, 0.F);
  std::fill_n(headlight.specular, 3, 0.F);
  std::fill_n(model.mat_emission, model.nmat, 0.F);
  std::fill_n(model.mat_specular, model.nmat, 0.F);
  std::fill_n(model.mat_reflectance, model.nmat, 0.F);
}

void DrawGeometryOnly(mjvScene& scene) {
  for (const int flag : {mjRND_SHADOW, mjRND_REFLECTION, mjRND_SKYBOX, mjRND_FOG, mjRND_HAZE,
                         mjRND_WIREFRAME, mjRND_ADDITIVE, mjRND_SEGMENT}) {
    scene.flags[flag] = 0;
  }
  scene.stereo = mjSTEREO_NONE;
}

/// The pinhole's frustum: its edges lie half a pixel outside the outermost pixel centres.
mjvGLCamera ToGlCamera(const Pose& T_WC, const Pinhole& pinhole) {
  const Eigen::Matrix3d R = T_WC.R();
  const auto per_pixel = Renderer::kNear / pinhole.focal;
  mjvGLCamera camera{};
  for (int i = 0; i < 3; ++i) {
    camera.pos[i] = static_cast<float>(T_WC.p()[i]);
    camera.forward[i] = static_cast<float>(R(i, 2));
    camera.up[i] = static_cast<float>(-R(i, 1));
  }
  camera.frustum_near = static_cast<float>(Renderer::kNear);
  camera.frustum_far = static_cast<float>(Renderer::kFar);
  camera.frustum_top = static_cast<float>((pinhole.cy + 0.5) * per_pixel);
  camera.frustum_bottom = static_cast<float>((pinhole.cy + 0.5 - pinhole.height) * per_pixel);
  camera.frustum_center = static_cast<float>((0.5 * (pinhole.width - 1) - pinhole.cx) * per_pixel);
  camera.frustum_width = static_cast<float>(0.5 * pinhole.width * per_pixel);
  return camera;
}

/// Whether a sphere can be seen by the pinhole.
bool IsInView(const Eigen::Vector3d& centre_C, double radius, const Pinhole& pinhole) {
  if (centre_C.z() + radius < Renderer::kNear || centre_C.z() - radius > Renderer::kFar)
    return false;
  // Signed distances to the four side planes through the camera's centre.
  const auto outside = [&](double edge, double x) {
    const double slope = edge / pinhole.focal;  // Plane x = slope * z.
    return (x - slope * centre_C.z()) / std::sqrt(1.0 + slope * slope) * (edge > 0 ? 1.0 : -1.0) >
           radius;
  };
  return !outside(-pinhole.cx - 0.5, centre_C.x()) &&
         !outside(pinhole.width - 0.5 - pinhole.cx, centre_C.x()) &&
         !outside(-pinhole.cy - 0.5, centre_C.y()) &&
         !outside(pinhole.height - 0.5 - pinhole.cy, centre_C.y());
}

}  // namespace

struct Renderer::Mujoco {
  World& world;
  mjvScene scene{};
  mjrContext context{};
  std::vector<mjvGeom> geoms;           ///< Everything that can be drawn.
  std::vector<Eigen::Vector4d> bounds;  ///< Of each: centre (m, in W) and radius.
  std::vector<float> reversed_depth;
  std::vector<unsigned char> rgb;

  Mujoco(World& the_world, int width, int height) : world(the_world) {
    mjModel& model = world.visual_model();
    model.vis.global.offwidth = width;
    model.vis.global.offheight = height;
    model.vis.quality.offsamples = 0;
    model.vis.quality.shadowsize = 0;
    MakeUnlit(model);
    mjv_defaultScene(&scene);
    mjv_makeScene(&model, &scene, model.ngeom + 100);
    mjr_defaultContext(&context);
    mjr_makeContext(&model, &context, mjFONTSCALE_100);
    mjr_setBuffer(mjFB_OFFSCREEN, &context);
    context.readDepthMap = mjDEPTH_ZEROFAR;
    CollectGeoms(model);
  }
  ~Mujoco() {
    mjr_freeContext(&context);
    mjv_freeScene(&scene);
  }
  Mujoco(const Mujoco&) = delete;
  Mujoco& operator=(const Mujoco&) = delete;

  void CollectGeoms(const mjModel& model) {
    mjvOption option;
    mjv_defaultOption(&option);
    mjvCamera camera;
    mjv_defaultCamera(&camera);
    mjv_updateScene(&model, &world.data(), &option, nullptr, &camera, mjCAT_ALL, &scene);
    DrawGeometryOnly(scene);
    geoms.assign(scene.geoms, scene.geoms + scene.ngeom);
    for (const mjvGeom& geom : geoms) {
      const bool is_geom = geom.objtype == mjOBJ_GEOM && geom.objid >= 0;
      const double radius = is_geom ? model.geom_rbound[geom.objid] : 0.0;
      const Eigen::Vector3d centre(geom.pos[0], geom.pos[1], geom.pos[2]);
      // A plane's radius is given as 0: it has no end and is always drawn.
      bounds.emplace_back(centre.x(), centre.y(), centre.z(),
                          radius > 0 ? radius : std::numeric_limits<double>::infinity());
    }
  }

  void KeepWhatIsSeen(const Pose& T_WC, const Pinhole& pinhole) {
    const Pose T_CW = T_WC.Inverse();
    scene.ngeom = 0;
    for (std::size_t i = 0; i < geoms.size(); ++i) {
      if (!IsInView(T_CW * Eigen::Vector3d(bounds[i].head<3>()), bounds[i][3], pinhole)) continue;
      scene.geoms[scene.ngeom++] = geoms[i];
    }
  }
};

Renderer::Renderer(World& world, RendererBackend backend, int largest_width, int largest_height) {
  InstallMujocoErrorHandlers();
  context_ = CreateGlContext(backend);
  mujoco_ = std::make_unique<Mujoco>(world, largest_width, largest_height);
}

Renderer::~Renderer() = default;

std::string Renderer::BackendName() const { return context_->Name(); }
std::string Renderer::DeviceName() const { return GlRendererName(); }

void Renderer::Render(const Pose& T_WC, const Pinhole& pinhole, RawImage& image) {
  Mujoco& mujoco = *mujoco_;
  Check(pinhole.width <= mujoco.context.offWidth && pinhole.height <= mujoco.context.offHeight,
        "a view of {} x {} px is larger than the renderer was made for", pinhole.width,
        pinhole.height);
  mujoco.KeepWhatIsSeen(T_WC, pinhole);
  // Without stereo MuJoCo draws from the mean of its two eyes.
  mujoco.scene.camera[0] = mujoco.scene.camera[1] = ToGlCamera(T_WC, pinhole);

  const mjrRect viewport{0, 0, pinhole.width, pinhole.height};
  mjr_render(viewport, &mujoco.scene, &mujoco.context);
  const auto pixels =
      static_cast<std::size_t>(pinhole.width) * static_cast<std::size_t>(pinhole.height);
  mujoco.rgb.resize(3 * pixels);
  mujoco.reversed_depth.resize(pixels);
  mjr_readPixels(mujoco.rgb.data(), mujoco.reversed_depth.data(), viewport, &mujoco.context);

  image.albedo.create(pinhole.height, pinhole.width, CV_8UC3);
  image.depth.create(pinhole.height, pinhole.width, CV_32FC1);
  const auto row_pixels = static_cast<std::size_t>(pinhole.width);
  for (int row = 0; row < pinhole.height; ++row) {
    // OpenGL's rows run upwards.
    const auto start = static_cast<std::size_t>(pinhole.height - 1 - row) * row_pixels;
    std::copy_n(mujoco.rgb.data() + 3 * start, 3 * row_pixels,
                image.albedo.ptr<unsigned char>(row));
    auto* depth = image.depth.ptr<float>(row);
    for (std::size_t column = 0; column < row_pixels; ++column) {
      // Reversed depth runs from 1 at the near plane to 0 at the far one: 1/z is linear in it.
      constexpr auto kInverseFar = static_cast<float>(1.0 / kFar);
      constexpr auto kInverseSpan = static_cast<float>(1.0 / kNear - 1.0 / kFar);
      const float d = mujoco.reversed_depth[start + column];
      depth[column] =
          d > 0.F ? 1.F / (kInverseFar + d * kInverseSpan) : std::numeric_limits<float>::infinity();
    }
  }
}

}  // namespace drydock::sim
