#include "sim/sensors/sensor_suite.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "sim/sensors/depth_sensor.h"
#include "sim/sensors/sonar.h"

namespace drydock::sim {

SensorSuite::SensorSuite(const Motion& motion, World& world, const RayScene& rays, const Rig& rig,
                         const SensorsConfig& config, const WaterConfig& water,
                         const std::vector<LampConfig>& lamps, RendererBackend backend,
                         std::uint64_t seed, Time end)
    : end_(end) {
  const auto add = [this](bool present, const SensorSwitches& switches, auto make) {
    if (present && switches.enabled) slots_.push_back({make(), switches.latency});
  };
  add(true, config.imu, [&] {
    auto imu = std::make_unique<Imu>(motion, KeepEffects(rig.imu, config.imu_effects),
                                     config.imu.noise, seed);
    imu_ = imu.get();
    return imu;
  });
  add(rig.HasDepth(), config.depth, [&] {
    return std::make_unique<DepthSensor>(motion, KeepEffects(rig.depth, config.depth_effects),
                                         water.surface_z_m, config.depth.noise, seed);
  });
  add(rig.HasSonar(), config.sonar, [&] {
    return std::make_unique<Sonar>(motion, world, rays, rig.sonar, config.sonar.noise,
                                   config.sonar_effects, seed);
  });
  add(true, config.stereo, [&] {
    auto camera =
        std::make_unique<StereoCamera>(StereoCamera::Surroundings{motion, world, rays, end},
                                       rig.stereo, water, lamps, config.camera, backend, seed);
    camera_ = camera.get();
    return camera;
  });
}

void SensorSuite::Insert(Pending pending) {
  const auto key = [](const Pending& p) {
    return std::tuple(p.observation.measurement.t_arrival, p.rank, p.observation.measurement.t);
  };
  const auto later = [&](const Pending& a, const Pending& b) { return key(a) > key(b); };
  const auto place = std::upper_bound(pending_.begin(), pending_.end(), pending, later);
  pending_.insert(place, std::move(pending));
}

std::optional<Observation> SensorSuite::Next() {
  while (true) {
    // The sensor that fires next, the first by rank on ties.
    std::size_t next = slots_.size();
    for (std::size_t rank = 0; rank < slots_.size(); ++rank) {
      if (slots_[rank].sensor->NextTime() > end_) continue;
      if (next == slots_.size() ||
          slots_[rank].sensor->NextTime() < slots_[next].sensor->NextTime())
        next = rank;
    }
    const bool may_fire = next < slots_.size();
    // Nothing that has yet to be measured can arrive before it is measured.
    const bool may_release =
        !pending_.empty() &&
        (!may_fire ||
         std::pair(pending_.back().observation.measurement.t_arrival, pending_.back().rank) <
             std::pair(slots_[next].sensor->NextTime(), next));
    if (may_release) {
      Observation observation = std::move(pending_.back().observation);
      pending_.pop_back();
      return observation;
    }
    if (!may_fire) return std::nullopt;
    Pending pending{next, slots_[next].sensor->Observe()};
    pending.observation.measurement.t_arrival =
        pending.observation.measurement.t + slots_[next].latency;
    Insert(std::move(pending));
  }
}

}  // namespace drydock::sim
