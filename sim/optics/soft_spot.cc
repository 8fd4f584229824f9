#include "sim/optics/soft_spot.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace drydock::sim {
namespace {

/// The spot's radius against an ellipse's, in the direction (a, b) of this length.
double Lobes(const SoftSpot& spot, double a, double b, double length) {
  if (length == 0.0) return 1.0;
  const double cosine = a / length, sine = b / length;
  return 1.0 + spot.lobe_cos * cosine * (4.0 * cosine * cosine - 3.0) +
         spot.lobe_sin * sine * (3.0 - 4.0 * sine * sine);
}

/// The share of the radius within which the spot is whole, where it fades by a smooth step over the
/// rest of an ellipse with this product of half axes. Over a circle of radius 1 the step's mean is
/// 1 - fade + 0.3 fade^2; `fade` makes it what the spot covers. A small spot is whole nowhere.
double CoreOf(const SoftSpot& spot, double axes) {
  const double lobes = 1.0 + 0.5 * (spot.lobe_cos * spot.lobe_cos + spot.lobe_sin * spot.lobe_sin);
  const double share = spot.half_along * spot.half_across / (axes * lobes);
  const double fade = (1.0 - std::sqrt(std::max(0.0, 1.0 - 1.2 * (1.0 - share)))) / 0.6;
  return std::clamp(1.0 - fade, 0.0, 0.999);
}

}  // namespace

SpotPainter::SpotPainter(const cv::Mat& depth, cv::Mat& radiance)
    : depth_(depth), radiance_(radiance) {}

double SpotPainter::Weigh(const SoftSpot& spot, const Box& box) {
  weights_.clear();
  const double along = spot.half_along + 0.5 * spot.edge;
  const double across = spot.half_across + 0.5 * spot.edge;
  const double core = CoreOf(spot, along * across);
  double sum = 0.0;
  for (int v = box.v_begin; v < box.v_end; ++v) {
    for (int u = box.u_begin; u < box.u_end; ++u) {
      const double du = u - spot.u, dv = v - spot.v;
      const double a = (du * spot.along_u + dv * spot.along_v) / along;
      const double b = (dv * spot.along_u - du * spot.along_v) / across;
      const double radius = std::sqrt(a * a + b * b);
      const double x =
          std::clamp((1.0 - radius / Lobes(spot, a, b, radius)) / (1.0 - core), 0.0, 1.0);
      const double weight = x * x * (3.0 - 2.0 * x);
      weights_.push_back(static_cast<float>(weight));
      sum += weight;
    }
  }
  return sum;
}

void SpotPainter::Draw(const SoftSpot& spot, const SpotLight& light) {
  const double reach = (1.0 + std::hypot(spot.lobe_cos, spot.lobe_sin)) *
                       (std::max(spot.half_along, spot.half_across) + 0.5 * spot.edge);
  if (spot.u + reach < 0.0 || spot.u - reach > radiance_.cols - 1 || spot.v + reach < 0.0 ||
      spot.v - reach > radiance_.rows - 1) {
    return;
  }
  const Box box{static_cast<int>(std::ceil(spot.u - reach)),
                static_cast<int>(std::floor(spot.u + reach)) + 1,
                static_cast<int>(std::ceil(spot.v - reach)),
                static_cast<int>(std::floor(spot.v + reach)) + 1};
  const double sum = Weigh(spot, box);
  if (sum <= 0.0) return;
  const double area = std::numbers::pi * spot.half_along * spot.half_across;
  const auto scale = static_cast<float>(area / sum);
  const auto cover = static_cast<float>(spot.cover), depth = static_cast<float>(spot.depth);
  const int channels = radiance_.channels(), columns = box.u_end - box.u_begin;
  for (int v = std::max(box.v_begin, 0); v < std::min(box.v_end, radiance_.rows); ++v) {
    const float* weights = weights_.data() + (v - box.v_begin) * columns;
    const auto* depths = depth_.ptr<float>(v);
    auto* pixels = radiance_.ptr<float>(v);
    for (int u = std::max(box.u_begin, 0); u < std::min(box.u_end, radiance_.cols); ++u) {
      if (depths[u] <= depth) continue;
      const float a = cover * std::min(scale * weights[u - box.u_begin], 1.F);
      for (int k = 0; k < channels; ++k) {
        const auto i = static_cast<std::size_t>(k);
        float& pixel = pixels[channels * u + k];
        pixel += a * (light.source[i] - light.share[i] * pixel);
      }
    }
  }
}

}  // namespace drydock::sim
