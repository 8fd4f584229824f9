// What is mounted on the bus' body.
#include <cmath>
#include <numbers>
#include <utility>

#include "scenes/bus/bus_shape.h"
#include "scenes/bus/details_atlas.h"
#include "scenes/bus/parts.h"
#include "scenes/mesh/shapes.h"

namespace drydock::scenes::bus {
namespace {
using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

Isometry3d At(const Vector3d& position, const Eigen::Matrix3d& rotation) {
  Isometry3d pose = Isometry3d::Identity();
  pose.linear() = rotation;
  pose.translation() = position;
  return pose;
}

/// Turns z into `axis` and keeps pictures upright: their top towards the world's up.
Eigen::Matrix3d Facing(const Vector3d& axis) {
  Eigen::Matrix3d r;
  const Vector3d right = Vector3d::UnitZ().cross(axis).normalized();
  r << right, axis.cross(right), axis;
  return r;
}

/// The emergency door, hinged at its left, hanging open.
void AddBackDoor(SceneModel& model) {
  SlabPlan plan;
  plan.u_lines = {-0.56, -0.42, 0.42, 0.56};
  plan.v_lines = {-0.58, -0.30, 0.10, 0.32, 0.95, 1.13};
  plan.is_hole = [](int i, int j) { return i == 1 && (j == 1 || j == 3); };
  plan.outer = [](double u, double v) -> Vector3d { return {kRear - 0.02, -u, v}; };
  plan.inner = [](double u, double v) -> Vector3d { return {kRear + 0.03, -u, v}; };
  plan.outer_uv = [](const Vector3d& p) -> Vector2d {
    return {(0.6 - p.y()) / kDoorCanvas.width, (1.2 - p.z()) / kDoorCanvas.height};
  };
  plan.inner_uv = [](const Vector3d& p) -> Vector2d {
    return {(1.8 + p.y()) / kDoorCanvas.width, (1.2 - p.z()) / kDoorCanvas.height};
  };
  SlabMeshes meshes = BuildSlab(plan);
  const Vector3d hinge(kRear - 0.03, kBackDoorHalfWidth, kBackDoorTop);
  Mesh handle =
      Tube({{1.46, -0.45, 0.2}, {1.41, -0.45, 0.2}, {1.41, -0.45, -0.05}, {1.46, -0.45, -0.05}},
           0.014, 6, {0.5, {0, 0}});
  const Isometry3d open =
      Eigen::Translation3d(hinge) *
      (AngleAxisd(-1.95, Vector3d::UnitZ()) * AngleAxisd(0.035, Vector3d::UnitX())) *
      Eigen::Translation3d(-hinge);
  for (Mesh* mesh : {&meshes.outer, &meshes.inner, &handle}) mesh->Transform(open);
  model.Add("bus_back_door", "door", std::move(meshes.outer));
  model.Add("bus_back_door", "door", std::move(meshes.inner));
  Mesh iron = std::move(handle);
  for (const double z : {-0.35, 0.3, 0.95}) {
    iron.Append(Tube({{kRear - 0.03, kBackDoorHalfWidth, z - 0.06},
                      {kRear - 0.03, kBackDoorHalfWidth, z + 0.06}},
                     0.022, 8, {0.5, {0.2, z}}));
  }
  model.Add("bus_back_door_hinges", "bare_rust", std::move(iron));
}

/// A lamp: a short round housing with a lens.
void AddLamp(Mesh& housings, Mesh& lenses, const Vector3d& position, const Vector3d& axis,
             double radius, const UvRect& cell) {
  Mesh housing = Lathe(
      {{radius * 1.2, -0.03}, {radius * 1.2, 0.03}, {radius * 1.02, 0.04}, {radius, 0.02}}, 12, 1);
  Mesh lens = Disc(radius, 12, cell);
  housing.Transform(At(position, Facing(axis)));
  lens.Transform(At(position + 0.028 * axis, Facing(axis)));
  housings.Append(housing);
  lenses.Append(lens);
}

void AddLamps(SceneModel& model) {
  Mesh housings;
  Mesh lenses;
  for (const double side : {-1.0, 1.0}) {
    const Vector3d back(-1, 0, 0);
    AddLamp(housings, lenses, {kRear, 0.80 * side, 0.86}, back, 0.075, AmberLampCell());
    AddLamp(housings, lenses, {kRear + 0.005, 1.03 * side, 0.84}, back, 0.075, RedLampCell());
    AddLamp(housings, lenses, {kRear, 0.93 * side, -0.22}, back, 0.09, RedLampCell());
    AddLamp(housings, lenses, {kRear, 0.71 * side, -0.24}, back, 0.065, AmberLampCell());
    for (const double y : {0.78, 0.98}) {
      AddLamp(housings, lenses, {10.235, y * side, 1.36 - 0.12 * y}, Vector3d::UnitX(), 0.075,
              y > 0.9 ? RedLampCell() : AmberLampCell());
    }
  }
  model.Add("bus_lamp_housings", "black_paint", std::move(housings));
  model.Add("bus_lamps", "details", std::move(lenses));
}

/// SCHOOL BUS over the windscreen and over the back door.
void AddSigns(SceneModel& model) {
  for (const bool front : {true, false}) {
    const double x = front ? 10.17 : 1.68;
    const double face = front ? x + 0.087 : x - 0.087;
    const double y = front ? 0.62 : -0.62;  // right end, for who reads it: u grows towards it
    model.Add(front ? "bus_sign_front" : "bus_sign_rear", "yellow_paint",
              Box({x, 0, 1.46}, {0.17, 1.3, 0.34}, {1.0, {0.4, front ? 0.1 : 0.6}}, 0.03, 1));
    const double v = front ? 0.0 : 0.5;
    Mesh board;
    board.AddQuad({Vector3d(face, -y, 1.34), Vector3d(face, y, 1.34), Vector3d(face, y, 1.60),
                   Vector3d(face, -y, 1.60)},
                  {Vector2d(0, v + 0.5), Vector2d(1, v + 0.5), Vector2d(1, v), Vector2d(0, v)});
    model.Add(front ? "bus_sign_front" : "bus_sign_rear", "signs", std::move(board));
  }
}

void AddMirrors(SceneModel& model) {
  Mesh tubes;
  Mesh black;
  Mesh glass;
  for (const double side : {-1.0, 1.0}) {
    tubes.Append(Tube({{10.25, 1.19 * side, 0.75},
                       {10.42, 1.45 * side, 0.72},
                       {10.42, 1.47 * side, 0.2},
                       {10.25, 1.19 * side, 0.1}},
                      0.013, 6, {0.4, {0.1, 0.2}}));
    tubes.Append(Box({10.44, 1.47 * side, 0.48}, {0.05, 0.2, 0.34}, {1.0, {0.6, 0.4}}, 0.02, 0));
    Mesh face;
    const Vector3d c(10.414, 1.47 * side, 0.48);
    face.AddQuad({c + Vector3d(0, 0.09, -0.16), c + Vector3d(0, -0.09, -0.16),
                  c + Vector3d(0, -0.09, 0.16), c + Vector3d(0, 0.09, 0.16)},
                 {MirrorCell().At(0, 1), MirrorCell().At(1, 1), MirrorCell().At(1, 0),
                  MirrorCell().At(0, 0)});
    glass.Append(face);
    // The cross-view mirror on its arm over the fender.
    tubes.Append(
        Tube({{11.75, 0.95 * side, -0.25}, {11.85, 1.0 * side, 0.0}, {12.05, 1.02 * side, 0.12}},
             0.013, 6, {0.4, {0.3, 0.7}}));
    Mesh egg =
        Lathe({{0.0, -0.05}, {0.055, -0.035}, {0.07, 0.0}, {0.055, 0.05}, {0.0, 0.08}}, 12, 1);
    egg.Transform(At({12.08, 1.02 * side, 0.14}, Facing(Vector3d(0.9, 0, 0.1).normalized())));
    black.Append(egg);
  }
  model.Add("bus_mirrors", "bare_rust", std::move(tubes));
  model.Add("bus_mirrors", "black_paint", std::move(black));
  model.Add("bus_mirror_glasses", "details", std::move(glass));
}

/// The octagon that says STOP, half folded out from the left side.
void AddStopArm(SceneModel& model) {
  Mesh sign = Disc(0.23, 8, StopSignCell());
  sign.Transform(Isometry3d(AngleAxisd(std::numbers::pi / 8, Vector3d::UnitZ())));
  for (Vector2d& uv : sign.uvs) {  // the picture stays upright while the octagon turns on a side
    const Vector2d middle = StopSignCell().At(0.5, 0.5);
    const Vector2d d = (uv - middle).cwiseProduct(Vector2d(4.0, 2.0));
    uv = middle + (Eigen::Rotation2Dd(-std::numbers::pi / 8) * d).cwiseProduct(Vector2d(0.25, 0.5));
  }
  Mesh back = Flipped(sign);  // of bare metal
  for (Vector2d& uv : back.uvs) uv += MirrorCell().low - StopSignCell().low;
  sign.Append(back);
  const Vector3d axis = Vector3d(-0.75, 0.66, 0.08).normalized();
  sign.Transform(At({9.12, 1.42, -0.27}, Facing(axis)));
  model.Add("bus_stop_arm", "details", std::move(sign));
  model.Add("bus_stop_arm", "black_paint",
            Box({9.3, 1.235, -0.27}, {0.1, 0.06, 0.3}, {1.0, {0.9, 0.3}}, 0.01, 0));
}

void AddHatches(SceneModel& model) {
  Mesh frames;
  for (const double x : {3.9, 7.9}) {
    frames.Append(Box({x, 0, 1.455}, {0.72, 0.72, 0.06}, {1.0, {0.1 * x, 0.3}}, 0.02, 0));
  }
  frames.Append(Box({3.9, 0, 1.50}, {0.64, 0.64, 0.05}, {1.0, {0.2, 0.8}}, 0.02, 1));
  Mesh lid = Box({0.32, 0, 0.02}, {0.64, 0.64, 0.05}, {1.0, {0.55, 0.25}}, 0.02, 1);
  lid.Transform(At({7.58, 0, 1.47}, AngleAxisd(-0.5, Vector3d::UnitY()).toRotationMatrix()));
  frames.Append(lid);
  model.Add("bus_hatches", "yellow_paint", std::move(frames));
}

void AddEntryDoor(SceneModel& model) {
  // Two leaves folded out, the panes gone.
  for (const double x : {9.60, 10.15}) {
    SlabPlan plan;
    plan.u_lines = {0.0, 0.05, 0.27, 0.32};
    plan.v_lines = {-1.05, -0.45, 0.75, 0.84};
    plan.is_hole = [](int i, int j) { return i == 1 && j == 1; };
    plan.outer = [x](double u, double v) -> Vector3d { return {x - 0.02, -1.16 - u, v}; };
    plan.inner = [x](double u, double v) -> Vector3d { return {x + 0.02, -1.16 - u, v}; };
    plan.outer_uv = [x](const Vector3d& p) -> Vector2d { return {p.y() + x, -p.z()}; };
    plan.inner_uv = [x](const Vector3d& p) -> Vector2d { return {p.y() - 0.4 + x, 0.3 - p.z()}; };
    SlabMeshes meshes = BuildSlab(plan);
    meshes.outer.Append(meshes.inner);
    model.Add("bus_entry_door", "yellow_paint", std::move(meshes.outer));
  }
}

}  // namespace

void AddFittings(SceneModel& model) {
  AddBackDoor(model);
  AddLamps(model);
  AddSigns(model);
  AddMirrors(model);
  AddStopArm(model);
  AddHatches(model);
  AddEntryDoor(model);
  Mesh bumper = Box({1.40, 0, -0.86}, {0.16, 2.36, 0.26}, {1.0, {0.5, 0.4}}, 0.03, 1);
  bumper.Append(Box({1.44, 0, -0.63}, {0.2, 1.1, 0.03}, {1.0, {0.8, 0.1}}));
  model.Add("bus_rear_bumper", "black_paint", std::move(bumper));
  Mesh plate;
  plate.AddQuad(
      {Vector3d(1.478, -0.62, -0.52), Vector3d(1.478, -0.94, -0.50), Vector3d(1.478, -0.94, -0.34),
       Vector3d(1.478, -0.62, -0.36)},
      {PlateCell().At(0, 1), PlateCell().At(1, 1), PlateCell().At(1, 0), PlateCell().At(0, 0)});
  model.Add("bus_plate", "details", std::move(plate));
}

}  // namespace drydock::scenes::bus
