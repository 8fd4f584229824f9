#include "sim/optics/lamp_veil.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/optics/lamp_rows.h"

namespace drydock::sim {
namespace {

/// Nothing is seen nearer than this [m].
constexpr double kNearest = 0.05;
/// Steps of Simpson's rule in a piece of a ray; even.
constexpr int kSteps = 8;

}  // namespace

double PhaseFunction(double cosine) {
  constexpr double kG = 0.924;
  return (1.0 - kG * kG) /
         (4.0 * std::numbers::pi * std::pow(1.0 + kG * kG - 2.0 * kG * cosine, 1.5));
}

LampVeil::LampVeil(const WaterConfig& water, const Pinhole& pinhole,
                   const std::vector<LampInCamera>& lamps)
    : pinhole_(pinhole),
      lamps_(lamps),
      attenuation_(BeamAttenuation(water)),
      scattering_(ScatteringAlbedo(water) * attenuation_) {
  const int rows = CellsIn(pinhole.height, kRaster) + 1;
  const int columns = CellsIn(pinhole.width, kRaster) + 1;
  // Pieces grow with range as what is seen of them fades.
  constexpr double kFirst = 0.3, kLast = 12.0;  // [m]
  ends_[0] = 0.F;
  for (int i = 0; i < kPieces; ++i) {
    ends_[static_cast<std::size_t>(i) + 1] = static_cast<float>(
        kFirst * std::pow(kLast / kFirst, static_cast<double>(i) / (kPieces - 1)));
  }
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    pieces_[i].create(rows, columns, CV_32FC3);
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        const Eigen::Vector3d ray =
            Eigen::Vector3d((column * kRaster - pinhole.cx) / pinhole.focal,
                            (row * kRaster - pinhole.cy) / pinhole.focal, 1.0)
                .normalized();
        const Eigen::Array3d light =
            IntegrateAlong(ray, std::max<double>(ends_[i], kNearest), ends_[i + 1]);
        pieces_[i].at<cv::Vec3f>(row, column) =
            cv::Vec3f(static_cast<float>(light[0]), static_cast<float>(light[1]),
                      static_cast<float>(light[2]));
      }
    }
  }
  coarse_.resize(static_cast<std::size_t>(columns));
  fine_.resize(static_cast<std::size_t>(columns - 1) * kRaster);
}

Eigen::Array3d LampVeil::SourceAt(const Eigen::Vector3d& ray_C, double range) const {
  Eigen::Array3d sum = Eigen::Array3d::Zero();
  const Eigen::Vector3d p_C = range * ray_C;
  for (const LampInCamera& lamp : lamps_) {
    // The light goes along `way` and turns against the ray.
    const Eigen::Vector3d way = p_C - lamp.position_C;
    const double phase =
        PhaseFunction(-way.dot(ray_C) / std::max(way.norm(), LampInCamera::kNearest));
    sum += phase * lamp.IlluminanceAt(p_C, attenuation_);
  }
  return std::numbers::pi * scattering_ * sum * (-attenuation_ * range).exp();
}

Eigen::Array3d LampVeil::IntegrateAlong(const Eigen::Vector3d& ray_C, double begin,
                                        double end) const {
  Eigen::Array3d sum = Eigen::Array3d::Zero();
  const double step = (end - begin) / kSteps;
  for (int i = 0; i <= kSteps; ++i) {
    const double weight = i == 0 || i == kSteps ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
    sum += weight / 3.0 * SourceAt(ray_C, begin + i * step);
  }
  return step * sum;
}

Eigen::Array3d LampVeil::Integrate(double u, double v, double range) const {
  const Eigen::Vector3d ray =
      Eigen::Vector3d((u - pinhole_.cx) / pinhole_.focal, (v - pinhole_.cy) / pinhole_.focal, 1.0)
          .normalized();
  constexpr int kParts = 50;
  Eigen::Array3d sum = Eigen::Array3d::Zero();
  const double part = (range - kNearest) / kParts;
  for (int i = 0; i < kParts; ++i)
    sum += IntegrateAlong(ray, kNearest + i * part, kNearest + (i + 1) * part);
  return sum;
}

void LampVeil::AddRow(int v, const float* range, const Eigen::Array3f& weights, float* veil) {
  const int row = v / kRaster;
  const float down = static_cast<float>(v % kRaster) / kRaster;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const auto* above = pieces_[i].ptr<cv::Vec3f>(row);
    const auto* below = pieces_[i].ptr<cv::Vec3f>(row + 1);
    for (std::size_t column = 0; column < coarse_.size(); ++column) {
      const cv::Vec3f light = above[column] + down * (below[column] - above[column]);
      coarse_[column] = weights[0] * light[0] + weights[1] * light[1] + weights[2] * light[2];
    }
    rows::Stretch(static_cast<int>(coarse_.size()) - 1, kRaster, coarse_.data(), fine_.data());
    rows::AddPiece(pinhole_.width, ends_[i], ends_[i + 1], range, fine_.data(), veil);
  }
}

}  // namespace drydock::sim
