// The camera, stage by stage, on poses along the bus dive: one left image an iteration; and a
// stereo pair through all stages, with the share of each.
#include <array>
#include <ctime>
#include <memory>

#include <benchmark/benchmark.h>
#include <opencv2/imgcodecs.hpp>

#include "sim/optics/auto_exposure.h"
#include "sim/optics/image_sensor.h"
#include "sim/optics/underwater_optics.h"
#include "sim/render/lens.h"
#include "sim/render/renderer.h"
#include "tests/benchmark/bench_dive.h"

namespace drydock::benchmark {
namespace {

constexpr int kPoses = 24;

/// Two lamps beside the rig, as divers in caves have them.
std::vector<sim::LampConfig> Lamps() {
  sim::LampConfig left, right;
  left.position_m = {0.1, 0.35, 0.1};
  left.yaw_deg = -8.0;
  right.position_m = {0.1, -0.35, 0.1};
  right.yaw_deg = 8.0;
  return {left, right};
}

sim::WaterConfig WithoutDaylight(sim::WaterConfig water) {
  water.daylight = 0.0;
  return water;
}

/// Everything up to a stage, prepared once for all benchmarks of the process (MuJoCo allows one
/// OpenGL context).
class Stages {
 public:
  Stages()
      : lens(dive.rig.stereo.cameras[0]),
        rays(dive.world),
        shadows(rays, sim::DirectionToSun(dive.scenario.water)),
        optics(dive.scenario.water, lens.source(), &shadows),
        dark_water(WithoutDaylight(dive.scenario.water)),
        lamp_optics(
            dark_water, lens.source(), nullptr,
            sim::LampLight(Lamps(), dive.rig.stereo.T_IC[0], dark_water, lens.source(), &rays)),
        renderer(dive.world, sim::RendererBackend::kAuto, lens.source().width,
                 lens.source().height) {
    for (const Pose& T_WI : dive.Poses(kPoses)) {
      pairs.push_back({T_WI * dive.rig.stereo.T_IC[0], T_WI * dive.rig.stereo.T_IC[1]});
      poses.push_back(pairs.back()[0]);
      renderer.Render(poses.back(), lens.source(), raw.emplace_back());
      optics.Apply(raw.back(), poses.back(), sim::ImageChannels::kMonochrome,
                   radiance.emplace_back());
      lens.ApplySmooth(radiance.back(), through_lens.emplace_back());
      sensor.Expose(through_lens.back(), Settled(through_lens.back()), 0, images.emplace_back());
    }
  }

  sim::Exposure Settled(const cv::Mat& light) const {
    return sim::AutoExposure(dive.rig.stereo.imager, {}).Settled(sim::MeterLight(light));
  }

  BenchDive dive;
  sim::Lens lens;
  sim::RayScene rays;
  sim::DaylightGrid shadows;
  sim::UnderwaterOptics optics;
  sim::WaterConfig dark_water;
  sim::UnderwaterOptics lamp_optics;
  sim::Renderer renderer;
  sim::ImageSensor sensor{dive.rig.stereo.imager, {}, dive.rig.stereo.cameras[0], 1, "cam0/noise"};
  std::vector<std::array<Pose, 2>> pairs;  ///< Of both eyes.
  std::vector<Pose> poses;                 ///< Of the left eye.
  std::vector<sim::RawImage> raw;
  std::vector<cv::Mat> radiance;
  std::vector<cv::Mat> through_lens;
  std::vector<cv::Mat> images;
};

Stages& SharedStages() {
  static Stages stages;
  return stages;
}

/// Runs `work(i)` over the poses in turn.
template <typename Work>
void Loop(::benchmark::State& state, Work work) {
  std::size_t i = 0;
  for (auto _ : state) {
    work(i);
    i = (i + 1) % kPoses;
  }
}

void Render(::benchmark::State& state) {
  Stages& stages = SharedStages();
  sim::RawImage raw;
  Loop(state,
       [&](std::size_t i) { stages.renderer.Render(stages.poses[i], stages.lens.source(), raw); });
}

void Optics(::benchmark::State& state) {
  Stages& stages = SharedStages();
  cv::Mat radiance;
  Loop(state, [&](std::size_t i) {
    stages.optics.Apply(stages.raw[i], stages.poses[i], sim::ImageChannels::kMonochrome, radiance);
  });
}

void OpticsColor(::benchmark::State& state) {
  Stages& stages = SharedStages();
  cv::Mat radiance;
  Loop(state, [&](std::size_t i) {
    stages.optics.Apply(stages.raw[i], stages.poses[i], sim::ImageChannels::kColor, radiance);
  });
}

/// No daylight, but two lamps with their shadows.
void OpticsLamps(::benchmark::State& state) {
  Stages& stages = SharedStages();
  cv::Mat radiance;
  Loop(state, [&](std::size_t i) {
    stages.lamp_optics.Apply(stages.raw[i], stages.poses[i], sim::ImageChannels::kMonochrome,
                             radiance);
  });
}

void LensResampling(::benchmark::State& state) {
  Stages& stages = SharedStages();
  cv::Mat out;
  Loop(state, [&](std::size_t i) { stages.lens.ApplySmooth(stages.radiance[i], out); });
}

void Exposure(::benchmark::State& state) {
  Stages& stages = SharedStages();
  cv::Mat out;
  Loop(state, [&](std::size_t i) {
    stages.sensor.Expose(stages.through_lens[i], stages.Settled(stages.through_lens[i]), 0, out);
  });
}

void WritePng(::benchmark::State& state) {
  Stages& stages = SharedStages();
  std::vector<unsigned char> bytes;
  Loop(state, [&](std::size_t i) {
    cv::imencode(".png", stages.images[i], bytes,
                 {cv::IMWRITE_PNG_COMPRESSION, 1, cv::IMWRITE_PNG_STRATEGY,
                  cv::IMWRITE_PNG_STRATEGY_HUFFMAN_ONLY});
  });
}

/// Adds the processor time of `work`, all threads together, to `sum` [ms].
template <typename Work>
void Charge(double& sum, Work work) {
  const std::clock_t start = std::clock();
  work();
  sum += 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// A stereo pair as it is recorded; both eyes look through the left lens, which costs the same. The
/// counters are processor milliseconds a pair.
void StereoPair(::benchmark::State& state) {
  Stages& stages = SharedStages();
  sim::RawImage raw;
  cv::Mat radiance, through_lens, image;
  std::vector<unsigned char> bytes;
  double render = 0, optics = 0, lens = 0, exposure = 0, png = 0;
  Loop(state, [&](std::size_t i) {
    for (const Pose& T_WC : stages.pairs[i]) {
      Charge(render, [&] { stages.renderer.Render(T_WC, stages.lens.source(), raw); });
      Charge(optics,
             [&] { stages.optics.Apply(raw, T_WC, sim::ImageChannels::kMonochrome, radiance); });
      Charge(lens, [&] { stages.lens.ApplySmooth(radiance, through_lens); });
      Charge(exposure,
             [&] { stages.sensor.Expose(through_lens, stages.Settled(through_lens), 0, image); });
      Charge(png, [&] {
        cv::imencode(".png", image, bytes,
                     {cv::IMWRITE_PNG_COMPRESSION, 1, cv::IMWRITE_PNG_STRATEGY,
                      cv::IMWRITE_PNG_STRATEGY_HUFFMAN_ONLY});
      });
    }
  });
  using ::benchmark::Counter;
  state.counters["1_render"] = Counter(render, Counter::kAvgIterations);
  state.counters["2_optics"] = Counter(optics, Counter::kAvgIterations);
  state.counters["3_lens"] = Counter(lens, Counter::kAvgIterations);
  state.counters["4_exposure"] = Counter(exposure, Counter::kAvgIterations);
  state.counters["5_png"] = Counter(png, Counter::kAvgIterations);
}

BENCHMARK(Render)->Unit(::benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(Optics)->Unit(::benchmark::kMillisecond);
BENCHMARK(OpticsColor)->Unit(::benchmark::kMillisecond);
BENCHMARK(OpticsLamps)->Unit(::benchmark::kMillisecond);
BENCHMARK(LensResampling)->Unit(::benchmark::kMillisecond);
BENCHMARK(Exposure)->Unit(::benchmark::kMillisecond);
BENCHMARK(WritePng)->Unit(::benchmark::kMillisecond);
BENCHMARK(StereoPair)->Unit(::benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

}  // namespace
}  // namespace drydock::benchmark
