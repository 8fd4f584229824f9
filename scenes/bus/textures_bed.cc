// The lake bed: several pictures with the same rim, so that any of them fits beside any.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include <fmt/format.h>

#include "scenes/bus/site.h"
#include "scenes/bus/textures.h"
#include "scenes/texture/materials.h"
#include "scenes/texture/stamps.h"

namespace drydock::scenes::bus {
namespace {

constexpr double kRim = 0.45;  ///< this far in, all variants show the same things [m]

/// Noise of the shared rim that turns into a variant's own further in.
class RimmedNoise {
 public:
  RimmedNoise(const Canvas& canvas, const NoiseKeys& shared, const NoiseKeys& own)
      : canvas_(canvas), shared_(shared), own_(own), weight_(canvas.size()) {
    const auto n = canvas.size().width;
    for (int y = 0; y < n; ++y) {
      for (int x = 0; x < n; ++x) {
        const int rim = std::min({x, y, n - 1 - x, n - 1 - y});
        const double t = std::clamp((rim / canvas.scale() - 0.2) / 0.7, 0.0, 1.0);
        weight_(y, x) = static_cast<float>(t * t * (3 - 2 * t));
      }
    }
  }

  cv::Mat1f operator()(double largest, double smallest, double gain, const std::string& name,
                       double stretch = 1.0) const {
    cv::Mat1f field = canvas_.Noise(largest, smallest, gain, shared_.Key(name), stretch);
    const cv::Mat1f own = canvas_.Noise(largest, smallest, gain, own_.Key(name), stretch);
    for (int y = 0; y < field.rows; ++y) {
      for (int x = 0; x < field.cols; ++x) {
        const float w = weight_(y, x);
        // Keeps the variance where the two mix.
        field(y, x) =
            ((1 - w) * field(y, x) + w * own(y, x)) / std::sqrt(w * w + (1 - w) * (1 - w));
      }
    }
    return field;
  }

 private:
  const Canvas& canvas_;
  const NoiseKeys& shared_;
  const NoiseKeys& own_;
  cv::Mat1f weight_;
};

void PaintSediment(Canvas& canvas, const RimmedNoise& noise) {
  const cv::Mat1f fine = noise(0.03, 0.004, 0.85, "fine");
  canvas.Blend(Everywhere(canvas), noise(1.6, 0.01, 0.62, "base"), Rgb(78, 69, 50),
               Rgb(172, 160, 126));
  // Ripples: crests pale, troughs full of dark flakes.
  const cv::Mat1f warp = noise(1.5, 0.1, 0.5, "warp");
  const cv::Mat1f where = noise(2.0, 0.1, 0.55, "ripples where");
  cv::Mat1f ripple(canvas.size());
  const double turn = 2 * std::numbers::pi / canvas.size().width;
  for (int y = 0; y < ripple.rows; ++y) {
    for (int x = 0; x < ripple.cols; ++x) {
      const double phase = turn * (27.0 * y + 6.0 * x) + 3.4 * warp(y, x);
      // Only in places, and broken up.
      const float strength = std::clamp(0.45F + 0.75F * where(y, x), 0.0F, 1.3F);
      ripple(y, x) = strength * static_cast<float>(std::sin(phase)) + 0.35F * fine(y, x);
    }
  }
  canvas.Blend(Ramp(ripple, 0.6, 1.6), Rgb(168, 156, 124), 0.45);
  canvas.Blend(Ramp(-ripple, 0.6, 1.5), Rgb(62, 54, 38), 0.5);
  canvas.Blend(Coverage(noise(0.8, 0.006, 0.68, "detritus"), 0.21, 0.3), fine, Rgb(30, 25, 18),
               Rgb(70, 60, 42), 0.88);
  canvas.Blend(Coverage(noise(0.9, 0.006, 0.66, "mats"), 0.06, 0.12), fine, Rgb(34, 38, 20),
               Rgb(88, 92, 50), 0.88);
  canvas.Blend(Coverage(noise(0.5, 0.006, 0.66, "bright"), 0.09, 0.30), fine, Rgb(146, 136, 110),
               Rgb(206, 196, 168), 0.8);
  canvas.Modulate(fine, 0.09);
}

using DrawThing = std::function<void(Canvas&, double x, double y, RandomStream&)>;

/// Things on the shared rim (drawn again on the opposite side where they stick out) or inside it.
void Strew(Canvas& canvas, int count, bool rim, const DrawThing& draw, RandomStream& random) {
  const double w = canvas.width();
  const double reach = 0.3;
  for (int i = 0; i < count; ++i) {
    const double x = random.Uniform(0.0, w);
    const double y = random.Uniform(0.0, w);
    const double inside = std::min({x, y, w - x, w - y});
    if ((inside < kRim) != rim) continue;
    const RandomStream look(random.Bits(), "look");
    for (const double dx : {-w, 0.0, w}) {
      for (const double dy : {-w, 0.0, w}) {
        const bool touches =
            x + dx > -reach && x + dx < w + reach && y + dy > -reach && y + dy < w + reach;
        RandomStream same = look;
        if (touches) draw(canvas, x + dx, y + dy, same);
      }
    }
  }
}

void StrewEverything(Canvas& canvas, bool rim, std::uint64_t key) {
  RandomStream random(key, "strewn");
  const auto pebble = [](double low, double high) -> DrawThing {
    return [low, high](Canvas& c, double x, double y, RandomStream& r) {
      const double size = r.Uniform();
      DrawPebble(c, x, y, low + (high - low) * size * size * size, r);
    };
  };
  Strew(
      canvas, 70, rim,
      [](Canvas& c, double x, double y, RandomStream& r) {
        DrawTwig(c, x, y, r.Uniform(0.1, 0.45), r);
      },
      random);
  Strew(canvas, 5200, rim, pebble(0.00, 0.018), random);
  Strew(canvas, 520, rim, pebble(0.01, 0.08), random);
  Strew(
      canvas, 220, rim,
      [](Canvas& c, double x, double y, RandomStream& r) {
        DrawShell(c, x, y, r.Uniform(0.01, 0.06), r);
      },
      random);
  Strew(
      canvas, 130, rim,
      [](Canvas& c, double x, double y, RandomStream& r) {
        DrawLeaf(c, x, y, r.Uniform(0.05, 0.15), r);
      },
      random);
}

cv::Mat3b PaintBed(int variant, std::uint64_t seed, double scale) {
  const NoiseKeys shared(seed, "bus/bed");
  const NoiseKeys own(seed, fmt::format("bus/bed_{}", variant));
  Canvas canvas(kTile, kTile, 300 * scale, Rgb(128, 116, 90), true);
  const RimmedNoise noise(canvas, shared, own);
  PaintSediment(canvas, noise);
  StrewEverything(canvas, true, shared.Key("things"));
  StrewEverything(canvas, false, own.Key("things"));
  return canvas.image();
}

}  // namespace

std::vector<TextureTask> BedTextures() {
  std::vector<TextureTask> tasks;
  tasks.reserve(kBedVariants);
  for (int variant = 0; variant < kBedVariants; ++variant) {
    tasks.push_back({fmt::format("bed_{}", variant), [variant](std::uint64_t seed, double scale) {
                       return PaintBed(variant, seed, scale);
                     }});
  }
  return tasks;
}

}  // namespace drydock::scenes::bus
