#include "sim/world/ray_scene.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <embree3/rtcore.h>

#include "sensors_models/base/check.h"

namespace drydock::sim {
namespace {

struct Triangles {
  std::vector<Eigen::Vector3f> vertices;
  std::vector<std::array<std::uint32_t, 3>> faces;
};

Triangles MeshTriangles(const mjModel& model, int mesh) {
  Triangles triangles;
  const float* vertices = model.mesh_vert + 3 * model.mesh_vertadr[mesh];
  for (int i = 0; i < model.mesh_vertnum[mesh]; ++i) {
    triangles.vertices.emplace_back(vertices[3 * i], vertices[3 * i + 1], vertices[3 * i + 2]);
  }
  const int* faces = model.mesh_face + 3 * model.mesh_faceadr[mesh];
  for (int i = 0; i < model.mesh_facenum[mesh]; ++i) {
    triangles.faces.push_back({static_cast<std::uint32_t>(faces[3 * i]),
                               static_cast<std::uint32_t>(faces[3 * i + 1]),
                               static_cast<std::uint32_t>(faces[3 * i + 2])});
  }
  return triangles;
}

Triangles BoxTriangles(const Eigen::Vector3f& half) {
  Triangles triangles;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3f sign(corner & 1 ? 1.F : -1.F, corner & 2 ? 1.F : -1.F,
                               corner & 4 ? 1.F : -1.F);
    triangles.vertices.emplace_back(half.cwiseProduct(sign));
  }
  triangles.faces = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                     {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return triangles;
}

Triangles PlaneTriangles(float half_x, float half_y) {
  constexpr float kInfinite = 1000.F;  // MuJoCo's planes of size 0 have no end.
  const float x = half_x > 0 ? half_x : kInfinite;
  const float y = half_y > 0 ? half_y : kInfinite;
  return {{{-x, -y, 0.F}, {x, -y, 0.F}, {x, y, 0.F}, {-x, y, 0.F}}, {{0, 1, 2}, {0, 2, 3}}};
}

Triangles GeomTriangles(const World& world, int geom) {
  const mjModel& model = world.model();
  const mjtNum* size = model.geom_size + 3 * geom;
  switch (model.geom_type[geom]) {
    case mjGEOM_MESH:
      return MeshTriangles(model, model.geom_dataid[geom]);
    case mjGEOM_BOX:
      return BoxTriangles(Eigen::Vector3f(static_cast<float>(size[0]), static_cast<float>(size[1]),
                                          static_cast<float>(size[2])));
    case mjGEOM_PLANE:
      return PlaneTriangles(static_cast<float>(size[0]), static_cast<float>(size[1]));
    default:
      break;
  }
  RequireInput(false,
               "the scene's body '{}' has a geom that is neither mesh, box nor plane; use a mesh",
               world.BodyOfGeom(geom));
  return {};
}

/// The point of triangle abc that is nearest to p (Ericson, Real-Time Collision Detection, 5.1.5).
Eigen::Vector3f NearestOnTriangle(const Eigen::Vector3f& p, const Eigen::Vector3f& a,
                                  const Eigen::Vector3f& b, const Eigen::Vector3f& c) {
  const Eigen::Vector3f ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const float d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return a;
  const float d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return b;
  const float vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + d1 / (d1 - d3) * ab;
  const float d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return c;
  const float vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + d2 / (d2 - d6) * ac;
  const float va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return b + (d4 - d3) / (d4 - d3 + d5 - d6) * (c - b);
  const float scale = 1.F / (va + vb + vc);
  return a + vb * scale * ab + vc * scale * ac;
}

}  // namespace

struct RayScene::Embree {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  /// World-frame triangles of each Embree geometry, whose id is MuJoCo's geom id.
  std::vector<Triangles> geoms;

  Embree() : device(rtcNewDevice("threads=1")), scene(rtcNewScene(device)) {
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
  }
  ~Embree() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
  Embree(const Embree&) = delete;
  Embree& operator=(const Embree&) = delete;

  void Attach(unsigned id) {
    const Triangles& triangles = geoms[id];
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                             sizeof(Eigen::Vector3f), triangles.vertices.size());
    std::copy(triangles.vertices.begin(), triangles.vertices.end(),
              static_cast<Eigen::Vector3f*>(vertices));
    void* faces = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                          3 * sizeof(std::uint32_t), triangles.faces.size());
    std::copy(triangles.faces.begin(), triangles.faces.end(),
              static_cast<std::array<std::uint32_t, 3>*>(faces));
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, id);
    rtcReleaseGeometry(geometry);
  }
};

RayScene::RayScene(const World& world) : embree_(std::make_unique<Embree>()) {
  const mjModel& model = world.model();
  embree_->geoms.resize(static_cast<std::size_t>(model.ngeom));
  for (int geom = 0; geom < model.ngeom; ++geom) {
    if (world.IsMoving(geom)) continue;
    Triangles triangles = GeomTriangles(world, geom);
    // MuJoCo keeps a mesh in its inertial frame: the geom's pose brings it back.
    const Eigen::Map<const Eigen::Matrix<mjtNum, 3, 3, Eigen::RowMajor>> R(world.data().geom_xmat +
                                                                           9 * geom);
    const Eigen::Map<const Eigen::Matrix<mjtNum, 3, 1>> p(world.data().geom_xpos + 3 * geom);
    for (Eigen::Vector3f& vertex : triangles.vertices) {
      vertex = (R * vertex.cast<mjtNum>() + p).template cast<float>();
    }
    if (model.geom_type[geom] != mjGEOM_PLANE) {
      for (const Eigen::Vector3f& vertex : triangles.vertices)
        bounds_.extend(vertex.cast<double>());
    }
    const auto id = static_cast<unsigned>(geom);
    embree_->geoms[id] = std::move(triangles);
    embree_->Attach(id);
  }
  rtcCommitScene(embree_->scene);
}

RayScene::~RayScene() = default;

namespace {

RTCRayHit MakeRay(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction,
                  float max_range) {
  RTCRayHit ray{};
  ray.ray.org_x = origin.x();
  ray.ray.org_y = origin.y();
  ray.ray.org_z = origin.z();
  ray.ray.dir_x = direction.x();
  ray.ray.dir_y = direction.y();
  ray.ray.dir_z = direction.z();
  ray.ray.tfar = max_range;
  ray.ray.mask = 0xFFFFFFFFU;
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  return ray;
}

}  // namespace

bool RayScene::IsOccluded(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                          double max_range) const {
  RTCRay ray =
      MakeRay(origin.cast<float>(), direction.cast<float>(), static_cast<float>(max_range)).ray;
  RTCIntersectContext context{};
  rtcInitIntersectContext(&context);
  rtcOccluded1(embree_->scene, &context, &ray);
  return ray.tfar < 0.F;  // Embree sets it to minus infinity on a hit.
}

std::optional<RayHit> RayScene::Cast(const Eigen::Vector3d& origin,
                                     const Eigen::Vector3d& direction, double max_range) const {
  RTCRayHit ray =
      MakeRay(origin.cast<float>(), direction.cast<float>(), static_cast<float>(max_range));
  RTCIntersectContext context{};
  rtcInitIntersectContext(&context);
  rtcIntersect1(embree_->scene, &context, &ray);
  if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  Eigen::Vector3d normal =
      Eigen::Vector3f(ray.hit.Ng_x, ray.hit.Ng_y, ray.hit.Ng_z).cast<double>().normalized();
  if (normal.dot(direction) > 0) normal = -normal;
  return RayHit{ray.ray.tfar, normal, static_cast<int>(ray.hit.geomID)};
}

std::vector<FanHit> RayScene::CastFan(const Eigen::Vector3d& origin, const RayFan& directions,
                                      double max_range) const {
  std::vector<RTCRayHit> rays;
  rays.reserve(static_cast<std::size_t>(directions.cols()));
  const Eigen::Vector3f from = origin.cast<float>();
  for (const auto direction : directions.colwise()) {
    rays.push_back(MakeRay(from, direction, static_cast<float>(max_range)));
  }
  RTCIntersectContext context{};
  rtcInitIntersectContext(&context);
  // Embree picks the packets that suit the processor; without the flag it casts one by one.
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect1M(embree_->scene, &context, rays.data(), static_cast<unsigned>(rays.size()),
                 sizeof(RTCRayHit));
  std::vector<FanHit> hits(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const RTCRayHit& ray = rays[i];
    if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) continue;
    const Eigen::Vector3f normal(ray.hit.Ng_x, ray.hit.Ng_y, ray.hit.Ng_z);
    const Eigen::Vector3f direction(ray.ray.dir_x, ray.ray.dir_y, ray.ray.dir_z);
    const float cos_incidence = std::abs(normal.dot(direction)) / normal.norm();
    hits[i] = {ray.ray.tfar, std::min(cos_incidence, 1.0F), static_cast<int>(ray.hit.geomID)};
  }
  return hits;
}

std::vector<char> RayScene::AreHidden(const Eigen::Ref<const RayFan>& from,
                                      const Eigen::Ref<const RayFan>& to, float margin) const {
  std::vector<RTCRay> rays;
  rays.reserve(static_cast<std::size_t>(from.cols()));
  for (Eigen::Index i = 0; i < from.cols(); ++i) {
    const Eigen::Vector3f way = to.col(i) - from.col(i);
    const float distance = way.norm();
    rays.push_back(MakeRay(from.col(i), way / distance, std::max(distance - margin, 0.F)).ray);
  }
  RTCIntersectContext context{};
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcOccluded1M(embree_->scene, &context, rays.data(), static_cast<unsigned>(rays.size()),
                sizeof(RTCRay));
  std::vector<char> hidden;
  hidden.reserve(rays.size());
  for (const RTCRay& ray : rays) hidden.push_back(ray.tfar < 0.F ? 1 : 0);
  return hidden;
}

namespace {

struct NearestQuery {
  const std::vector<Triangles>* geoms = nullptr;
  float distance = std::numeric_limits<float>::infinity();
  Eigen::Vector3f surface = Eigen::Vector3f::Zero();
  int geom = -1;
};

bool VisitTriangle(RTCPointQueryFunctionArguments* arguments) {
  auto& query = *static_cast<NearestQuery*>(arguments->userPtr);
  const Triangles& triangles = (*query.geoms)[arguments->geomID];
  const auto& face = triangles.faces[arguments->primID];
  const Eigen::Vector3f p(arguments->query->x, arguments->query->y, arguments->query->z);
  const Eigen::Vector3f nearest = NearestOnTriangle(
      p, triangles.vertices[face[0]], triangles.vertices[face[1]], triangles.vertices[face[2]]);
  const float distance = (p - nearest).norm();
  if (distance >= arguments->query->radius) return false;
  arguments->query->radius = distance;
  query.distance = distance;
  query.surface = nearest;
  query.geom = static_cast<int>(arguments->geomID);
  return true;  // The radius has shrunk.
}

}  // namespace

std::optional<RayHit> RayScene::Nearest(const Eigen::Vector3d& point, double max_distance) const {
  RTCPointQuery query{};
  query.x = static_cast<float>(point.x());
  query.y = static_cast<float>(point.y());
  query.z = static_cast<float>(point.z());
  query.radius = static_cast<float>(max_distance);
  RTCPointQueryContext context{};
  rtcInitPointQueryContext(&context);
  NearestQuery nearest;
  nearest.geoms = &embree_->geoms;
  rtcPointQuery(embree_->scene, &query, &context, VisitTriangle, &nearest);
  if (nearest.geom < 0) return std::nullopt;
  const Eigen::Vector3d away = point - nearest.surface.cast<double>();
  return RayHit{nearest.distance, away.normalized(), nearest.geom};
}

}  // namespace drydock::sim
