#include "sim/render/renderer.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "sensors_models/base/check.h"
#include "sim/render/frustum.h"
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

/// Looks every pixel up in the one mipmap level that fits best instead of between two, as MuJoCo
/// asks for. On a software renderer that is a fifth of all its time; the pictures change by half a
/// grey level.
void UseOneMipmapLevel(const mjrContext& context) {
  using BindTexture = void(unsigned target, unsigned texture);
  using SetParameter = void(unsigned target, unsigned parameter, int value);
  constexpr unsigned kTexture2d = 0x0DE1, kMinFilter = 0x2801;
  constexpr int kLinearMipmapNearest = 0x2701;
  auto* bind = reinterpret_cast<BindTexture*>(FindGlFunction("glBindTexture"));
  auto* set = reinterpret_cast<SetParameter*>(FindGlFunction("glTexParameteri"));
  Check(bind != nullptr && set != nullptr, "OpenGL lacks textures");
  for (int i = 0; i < context.ntexture; ++i) {
    if (context.textureType[i] != mjTEXTURE_2D) continue;
    bind(kTexture2d, context.texture[i]);
    set(kTexture2d, kMinFilter, kLinearMipmapNearest);
  }
  bind(kTexture2d, 0);
}

/// The pinhole's frustum: its edges lie half a pixel outside the outermost pixel centres.
mjvGLCamera ToGlCamera(const Pose& T_WC, const Pinhole& pinhole, double far) {
  const Eigen::Matrix3d R = T_WC.R();
  const auto per_pixel = Renderer::kNear / pinhole.focal;
  mjvGLCamera camera{};
  for (int i = 0; i < 3; ++i) {
    camera.pos[i] = static_cast<float>(T_WC.p()[i]);
    camera.forward[i] = static_cast<float>(R(i, 2));
    camera.up[i] = static_cast<float>(-R(i, 1));
  }
  camera.frustum_near = static_cast<float>(Renderer::kNear);
  camera.frustum_far = static_cast<float>(far);
  camera.frustum_top = static_cast<float>((pinhole.cy + 0.5) * per_pixel);
  camera.frustum_bottom = static_cast<float>((pinhole.cy + 0.5 - pinhole.height) * per_pixel);
  camera.frustum_center = static_cast<float>((0.5 * (pinhole.width - 1) - pinhole.cx) * per_pixel);
  camera.frustum_width = static_cast<float>(0.5 * pinhole.width * per_pixel);
  return camera;
}

using RowMajorMatrix = Eigen::Matrix<mjtNum, 3, 3, Eigen::RowMajor>;

/// Something that can be drawn.
struct Drawable {
  mjvGeom geom;
  std::optional<BoxCorners> box;  ///< Around it; none if it has no end.
  bool is_there = true;
};

/// The box around geom `id` with its frame at `position`, turned by `R`.
BoxCorners BoxAt(int id, const mjModel& model, const Eigen::Vector3d& position,
                 const Eigen::Matrix3d& R) {
  const Eigen::Map<const Eigen::Vector3d> centre(model.geom_aabb + 6 * id);
  const Eigen::Map<const Eigen::Vector3d> half_sizes(model.geom_aabb + 6 * id + 3);
  return CornersOfBox(position + R * centre, R, half_sizes);
}

/// The box around what `geom` draws.
std::optional<BoxCorners> BoxOf(const mjvGeom& geom, const mjModel& model, const mjData& data) {
  if (geom.objtype != mjOBJ_GEOM || geom.objid < 0) return std::nullopt;
  if (model.geom_rbound[geom.objid] <= 0) return std::nullopt;  // An infinite plane.
  const Eigen::Map<const Eigen::Vector3d> position(data.geom_xpos + 3 * geom.objid);
  const Eigen::Map<const RowMajorMatrix> R(data.geom_xmat + 9 * geom.objid);
  return BoxAt(geom.objid, model, position, R);
}

/// Of a geom in its body.
Pose GeomInBody(int id, const mjModel& model) {
  const mjtNum* q = model.geom_quat + 4 * id;
  return {Eigen::Quaterniond(q[0], q[1], q[2], q[3]), Eigen::Vector3d(model.geom_pos + 3 * id)};
}

}  // namespace

struct Renderer::Mujoco {
  World& world;
  mjvScene scene{};
  mjrContext context{};
  double far = kFar;
  std::vector<Drawable> drawables;
  std::vector<std::size_t> moving;  ///< Those of the world's moving bodies, in their order.
  std::vector<std::pair<double, std::size_t>> seen;  ///< Depth and index of each drawable in view.
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
    UseOneMipmapLevel(context);
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
    for (int i = 0; i < scene.ngeom; ++i) {
      drawables.push_back({scene.geoms[i], BoxOf(scene.geoms[i], model, world.data())});
    }
    for (const int geom : world.moving_geoms()) {
      const auto drawn =
          std::find_if(drawables.begin(), drawables.end(), [geom](const Drawable& d) {
            return d.geom.objtype == mjOBJ_GEOM && d.geom.objid == geom;
          });
      Check(drawn != drawables.end(), "MuJoCo does not draw geom {}", geom);
      drawn->is_there = false;
      moving.push_back(static_cast<std::size_t>(drawn - drawables.begin()));
    }
  }

  void Place(Drawable& drawable, const Pose& T_WB) const {
    const int id = drawable.geom.objid;
    const Pose T_WG = T_WB * GeomInBody(id, world.model());
    const Eigen::Matrix3d R = T_WG.R();
    Eigen::Map<Eigen::Vector3f>(drawable.geom.pos) = T_WG.p().cast<float>();
    Eigen::Map<Eigen::Matrix<float, 3, 3, Eigen::RowMajor>>(drawable.geom.mat) = R.cast<float>();
    drawable.box = BoxAt(id, world.model(), T_WG.p(), R);
  }

  /// Fills the scene with what is seen. What ends nearest comes first, so that most of what it
  /// hides fails the depth test before its texture is looked up; the ground, which reaches far,
  /// comes late.
  void KeepWhatIsSeen(const Pose& T_WC, const Pinhole& pinhole) {
    const Frustum frustum(T_WC, pinhole, kNear, far);
    seen.clear();
    for (std::size_t i = 0; i < drawables.size(); ++i) {
      if (!drawables[i].is_there) continue;
      const auto depth = drawables[i].box ? frustum.FarthestDepth(*drawables[i].box) : far;
      if (depth) seen.emplace_back(*depth, i);
    }
    std::sort(seen.begin(), seen.end());
    scene.ngeom = 0;
    for (const auto& [depth, index] : seen) scene.geoms[scene.ngeom++] = drawables[index].geom;
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

void Renderer::SetFar(double far_m) {
  Check(far_m > kNear && far_m <= kFar, "the renderer's far plane at {} m is not in ({}, {}] m",
        far_m, kNear, kFar);
  mujoco_->far = far_m;
}

void Renderer::Place(const MovingPoses& poses) {
  const std::vector<std::size_t>& moving = mujoco_->moving;
  Check(poses.empty() || poses.size() == moving.size(), "{} poses of {} moving bodies",
        poses.size(), moving.size());
  for (std::size_t i = 0; i < moving.size(); ++i) {
    Drawable& drawable = mujoco_->drawables[moving[i]];
    drawable.is_there = !poses.empty() && poses[i].has_value();
    if (drawable.is_there) mujoco_->Place(drawable, *poses[i]);
  }
}

void Renderer::Render(const Pose& T_WC, const Pinhole& pinhole, RawImage& image) {
  Mujoco& mujoco = *mujoco_;
  Check(pinhole.width <= mujoco.context.offWidth && pinhole.height <= mujoco.context.offHeight,
        "a view of {} x {} px is larger than the renderer was made for", pinhole.width,
        pinhole.height);
  mujoco.KeepWhatIsSeen(T_WC, pinhole);
  // Without stereo MuJoCo draws from the mean of its two eyes.
  mujoco.scene.camera[0] = mujoco.scene.camera[1] = ToGlCamera(T_WC, pinhole, mujoco.far);

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
  // Reversed depth runs from 1 at the near plane to 0 at the far one: 1/z is linear in it.
  const auto inverse_far = static_cast<float>(1.0 / mujoco.far);
  const auto inverse_span = static_cast<float>(1.0 / kNear - 1.0 / mujoco.far);
  for (int row = 0; row < pinhole.height; ++row) {
    // OpenGL's rows run upwards.
    const auto start = static_cast<std::size_t>(pinhole.height - 1 - row) * row_pixels;
    std::copy_n(mujoco.rgb.data() + 3 * start, 3 * row_pixels,
                image.albedo.ptr<unsigned char>(row));
    auto* depth = image.depth.ptr<float>(row);
    for (std::size_t column = 0; column < row_pixels; ++column) {
      const float d = mujoco.reversed_depth[start + column];
      depth[column] =
          d > 0.F ? 1.F / (inverse_far + d * inverse_span) : std::numeric_limits<float>::infinity();
    }
  }
}

}  // namespace drydock::sim
