// Wheels and what is under the floor.
#include <cstddef>
#include <string>
#include <utility>

#include "scenes/bus/bus_shape.h"
#include "scenes/bus/parts.h"
#include "scenes/mesh/shapes.h"

namespace drydock::scenes::bus {
namespace {
using Eigen::Vector3d;

struct Wheel {
  const char* name;
  double x, y, width;
};

constexpr Wheel kWheels[] = {{"front_left", kFrontAxle, 1.0, 0.30},
                             {"front_right", kFrontAxle, -1.0, 0.30},
                             {"rear_left", kRearAxle, 0.86, 0.56},
                             {"rear_right", kRearAxle, -0.86, 0.56}};

void AddWheel(SceneModel& model, const Wheel& wheel) {
  const double h = wheel.width / 2;
  Mesh tyre = Lathe({{0.27, -0.9 * h},
                     {0.30, -h},
                     {0.44, -h},
                     {0.485, -0.86 * h},
                     {0.5, -0.5 * h},
                     {0.5, 0.5 * h},
                     {0.485, 0.86 * h},
                     {0.44, h},
                     {0.30, h},
                     {0.27, 0.9 * h}},
                    22, 3.0);
  Mesh hub = Lathe({{0.0, -0.5 * h},
                    {0.28, -0.5 * h},
                    {0.285, 0.92 * h},
                    {0.26, 0.90 * h},
                    {0.23, h - 0.10},
                    {0.13, h - 0.13},
                    {0.12, h - 0.05},
                    {0.085, h - 0.03},
                    {0.0, h - 0.03}},
                   15, 2.0, 0.0, 1.4);
  // Seen face on: the picture is laid over it flat.
  for (std::size_t i = 0; i < hub.uvs.size(); ++i) {
    hub.uvs[i] = Eigen::Vector2d(hub.positions[i].x() + wheel.x, hub.positions[i].y() + wheel.y);
  }
  // z of the turned parts points outwards, away from the bus.
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  const double side = wheel.y > 0 ? 1.0 : -1.0;
  pose.linear() = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), Vector3d(0, side, 0))
                      .toRotationMatrix();
  pose.translation() = Vector3d(wheel.x, wheel.y, kAxleHeight);
  if (std::string(wheel.name) == "front_left") {  // the wheels are turned a little
    pose.linear() = Eigen::AngleAxisd(0.25, Vector3d::UnitZ()) * pose.linear();
  }
  tyre.Transform(pose);
  hub.Transform(pose);
  model.Add(std::string("bus_wheel_") + wheel.name, "rubber", std::move(tyre));
  model.Add(std::string("bus_hub_") + wheel.name, "bare_rust", std::move(hub));
}

}  // namespace

void AddChassis(SceneModel& model) {
  for (const Wheel& wheel : kWheels) AddWheel(model, wheel);
  Mesh frame;
  for (const double y : {-0.42, 0.42}) {
    frame.Append(Box({6.7, y, -0.86}, {10.4, 0.09, 0.22}, {1.0, {0.3 + y, 0.2}}));
  }
  for (const double x : {kRearAxle, kFrontAxle}) {
    frame.Append(
        Tube({{x, -1.0, kAxleHeight}, {x, 1.0, kAxleHeight}}, 0.075, 10, {1.0, {0.2, 0.5}}));
  }
  model.Add("bus_frame", "bare_rust", std::move(frame));
  Mesh under;
  under.Append(
      Tube({{1.3, -0.6, -0.98}, {3.0, -0.6, -0.95}, {3.4, -0.5, -0.72}, {9.0, -0.55, -0.82}}, 0.05,
           8, {1.0, {0.1, 0.1}}));
  under.Append(Box({6.4, -0.82, -0.93}, {1.4, 0.5, 0.4}, {1.0, {0.6, 0.7}}, 0.08, 0));  // fuel tank
  under.Append(Box({8.0, 0.85, -0.92}, {0.7, 0.45, 0.3}, {1.0, {0.1, 0.4}}, 0.03, 0));  // battery
  model.Add("bus_tank", "bare_rust", std::move(under));
  Mesh underside;
  underside.AddQuad({Vector3d(1.52, -1.15, -0.68), Vector3d(1.52, 1.15, -0.68),
                     Vector3d(10.4, 1.15, -0.68), Vector3d(10.4, -1.15, -0.68)},
                    {Eigen::Vector2d(0, 0), Eigen::Vector2d(2.3, 0), Eigen::Vector2d(2.3, 8.9),
                     Eigen::Vector2d(0, 8.9)});
  model.Add("bus_underside", "bare_rust", std::move(underside));
}

}  // namespace drydock::scenes::bus
