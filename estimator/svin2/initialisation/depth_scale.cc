#include "estimator/svin2/initialisation/depth_scale.h"

#include <algorithm>
#include <cmath>

namespace drydock::svin2 {
namespace {

struct CameraAt {
  Eigen::Vector3d p_V = Eigen::Vector3d::Zero();
  Eigen::Quaterniond q_VI = Eigen::Quaterniond::Identity();
};

class CameraPath {
 public:
  CameraPath(const VisualHeights& vision, const Eigen::Vector3d& p_IC) : vision_(vision) {
    for (const Pose& T_VI : vision.T_VI) p_V_.push_back(T_VI * p_IC);
  }

  std::optional<CameraAt> At(Time t) const {
    const std::vector<Time>& times = vision_.t;
    if (times.size() < 2 || t < times.front() || t > times.back()) return std::nullopt;
    const auto after = std::upper_bound(times.begin() + 1, times.end() - 1, t);
    const int j = static_cast<int>(after - times.begin());
    const int i = j - 1;
    const double T = (times[j] - times[i]).Seconds();
    const double s = (t - times[i]).Seconds() / T;
    const double s2 = s * s, s3 = s2 * s;
    CameraAt here;
    here.p_V = (2.0 * s3 - 3.0 * s2 + 1.0) * p_V_[i] + (3.0 * s2 - 2.0 * s3) * p_V_[j] +
               T * (s3 - 2.0 * s2 + s) * Slope(i) + T * (s3 - s2) * Slope(j);
    here.q_VI = vision_.T_VI[i].q().slerp(s, vision_.T_VI[j].q());
    return here;
  }

 private:
  // That of the parabola through k and its neighbours.
  Eigen::Vector3d Slope(int k) const {
    const int last = static_cast<int>(p_V_.size()) - 1;
    if (last == 1) return Between(0, 1);
    const int middle = std::clamp(k, 1, last - 1);
    const Eigen::Vector3d before = Between(middle - 1, middle);
    const Eigen::Vector3d after = Between(middle, middle + 1);
    const double T_before = Seconds(middle - 1, middle), T_after = Seconds(middle, middle + 1);
    const Eigen::Vector3d bend = (after - before) / (T_before + T_after);
    if (k < middle) return before - bend * T_before;
    if (k > middle) return after + bend * T_after;
    return before + bend * T_before;
  }
  Eigen::Vector3d Between(int i, int j) const { return (p_V_[j] - p_V_[i]) / Seconds(i, j); }
  double Seconds(int i, int j) const { return (vision_.t[j] - vision_.t[i]).Seconds(); }

  const VisualHeights& vision_;
  std::vector<Eigen::Vector3d> p_V_;
};

}  // namespace

ScaleEstimate Combine(const ScaleEstimate& a, const ScaleEstimate& b) {
  const double information_a = 1.0 / (a.sigma * a.sigma);
  const double information_b = 1.0 / (b.sigma * b.sigma);
  const double sum = information_a + information_b;
  return {(a.value * information_a + b.value * information_b) / sum, 1.0 / std::sqrt(sum)};
}

std::optional<ScaleEstimate> ScaleFromDepth(std::span<const TimedDepth> readings,
                                            const VisualHeights& vision,
                                            const Eigen::Vector3d& p_IC, const DepthSheet& sheet,
                                            const DepthScaleConfig& config) {
  const CameraPath path(vision, p_IC);
  std::vector<Eigen::Vector3d> p_V;  // Of the camera.
  std::vector<double> heights;       // Of the camera by the readings, but for a constant.
  for (const TimedDepth& reading : readings) {
    const auto camera = path.At(reading.t - Duration::FromSeconds(sheet.lag_s));
    if (!camera.has_value() || !std::isfinite(reading.depth)) continue;
    p_V.push_back(camera->p_V);
    heights.push_back(-reading.depth - vision.up_V.dot(camera->q_VI * (sheet.p_ID - p_IC)));
  }
  if (p_V.size() < 2) return std::nullopt;

  const double count = static_cast<double>(p_V.size());
  Eigen::Vector3d mean_p = Eigen::Vector3d::Zero();
  double mean_height = 0.0;
  for (std::size_t m = 0; m < p_V.size(); ++m) {
    mean_p += p_V[m] / count;
    mean_height += heights[m] / count;
  }
  double squares = 0.0, products = 0.0, low = 0.0, high = 0.0;
  Eigen::Vector3d by_up = Eigen::Vector3d::Zero();
  for (std::size_t m = 0; m < p_V.size(); ++m) {
    const Eigen::Vector3d p = p_V[m] - mean_p;
    const double z = vision.up_V.dot(p);
    squares += z * z;
    products += z * (heights[m] - mean_height);
    by_up += z * p;
    low = std::min(low, z);
    high = std::max(high, z);
  }
  if (!(high - low >= config.min_excursion_m)) return std::nullopt;

  // A tilted up mixes the way travelled into the height.
  const Eigen::Vector3d sideways = (by_up - vision.up_V * vision.up_V.dot(by_up)) / squares;
  const double reading_sigma =
      std::hypot(sheet.noise_m, sheet.resolution_m / std::sqrt(12.0), config.height_sigma_m);
  const double value = products / squares;
  return ScaleEstimate{value, std::hypot(reading_sigma / std::sqrt(squares),
                                         value * sideways.norm() * vision.tilt_sigma_rad)};
}

}  // namespace drydock::svin2
