#include "sim/render/lens.h"

#include <Eigen/Core>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <opencv2/core.hpp>

#include "sensors_models/base/check.h"

namespace drydock::sim {
namespace {

/// Columns that bicubic interpolation needs beyond the outermost sample.
constexpr double kMargin = 3.0;  // [px]
constexpr double kDegree = 180.0 / std::numbers::pi;

/// Weights of four neighbours for a point `t` of the way from the second to the third.
std::array<float, 4> CatmullRom(float t) {
  return {0.5F * t * (-1.F + t * (2.F - t)), 1.F + 0.5F * t * t * (-5.F + 3.F * t),
          0.5F * t * (1.F + t * (4.F - 3.F * t)), 0.5F * t * t * (t - 1.F)};
}

/// The points of the plane z = 1 that the camera's pixels are the means of.
struct Gaze {
  std::vector<Eigen::Vector2d> middles;  ///< Of the pixels, row by row.
  std::vector<int> counts;               ///< Points of a pixel.
  std::vector<Eigen::Vector2d> points;
};

/// How many points across a camera pixel see each of the pinhole's pixels there.
int PointsAcross(const Eigen::Matrix2d& source_by_pixel) {
  constexpr long kMost = 4;
  const double widest = source_by_pixel.jacobiSvd().singularValues()[0];
  return static_cast<int>(std::clamp(std::lround(widest), 1L, kMost));
}

Gaze GazeOf(const CameraModel& camera, double focal) {
  Gaze gaze;
  for (int v = 0; v < camera.intrinsics().height; ++v) {
    for (int u = 0; u < camera.intrinsics().width; ++u) {
      const auto middle = camera.Unproject({u, v});
      RequireInput(middle.has_value(),
                   "the rig's stereo.cameras: pixel ({}, {}) has no ray that could be drawn: the "
                   "distortion must not fold over, nor look more than 85 degrees off the axis",
                   u, v);
      const Eigen::Matrix2d by_pixel = camera.PixelByIdeal(*middle).inverse();
      const int across = PointsAcross(focal * by_pixel);
      gaze.middles.push_back(*middle);
      gaze.counts.push_back(across * across);
      for (int row = 0; row < across; ++row) {
        for (int column = 0; column < across; ++column) {
          const Eigen::Vector2d offset((column + 0.5) / across - 0.5, (row + 0.5) / across - 0.5);
          gaze.points.emplace_back(*middle + by_pixel * offset);
        }
      }
    }
  }
  return gaze;
}

/// The pinhole that has all `points` of z = 1 and what interpolation needs about them.
Pinhole Covering(const std::vector<Eigen::Vector2d>& points, double focal) {
  Eigen::Array2d low = points.front(), high = points.front();
  for (const Eigen::Vector2d& point : points) {
    low = low.min(point.array());
    high = high.max(point.array());
  }
  Pinhole pinhole;
  pinhole.focal = focal;
  pinhole.cx = std::ceil(-low.x() * focal + kMargin);
  pinhole.cy = std::ceil(-low.y() * focal + kMargin);
  // Kept small enough for whole numbers; what is refused is smaller.
  constexpr double kHuge = 1e6;
  pinhole.width =
      static_cast<int>(std::min(std::ceil(high.x() * focal + pinhole.cx + kMargin) + 1.0, kHuge));
  pinhole.height =
      static_cast<int>(std::min(std::ceil(high.y() * focal + pinhole.cy + kMargin) + 1.0, kHuge));
  return pinhole;
}

/// FlatPort::ByInverseDepth of each pixel.
std::vector<Eigen::Vector2d> BehindPort(const FlatPort& port,
                                        const std::vector<Eigen::Vector2d>& middles) {
  std::vector<Eigen::Vector2d> by_inverse_depth;
  by_inverse_depth.reserve(middles.size());
  for (const Eigen::Vector2d& middle : middles) {
    RequireInput(
        middle.norm() < port.widest(),
        "stereo.flat_port: the rig's stereo.cameras look {:.1f} degrees off the axis, must "
        "be less than {:.1f} behind a flat port",
        std::atan(middle.norm()) * kDegree, std::atan(port.widest()) * kDegree);
    by_inverse_depth.push_back(port.ByInverseDepth(middle));
  }
  return by_inverse_depth;
}

/// All that may be seen behind a port: `gaze` moved as what is nearest and as what is infinitely
/// far.
std::vector<Eigen::Vector2d> AllSeen(const Gaze& gaze, const FlatPort& port,
                                     const std::vector<Eigen::Vector2d>& by_inverse_depth) {
  const double calibrated = port.calibrated_inverse_depth();
  std::vector<Eigen::Vector2d> seen;
  auto point = gaze.points.begin();
  for (std::size_t i = 0; i < gaze.counts.size(); ++i) {
    const Eigen::Vector2d near =
        (FlatPort::largest_inverse_depth() - calibrated) * by_inverse_depth[i];
    const Eigen::Vector2d far = -calibrated * by_inverse_depth[i];
    for (int n = 0; n < gaze.counts[i]; ++n, ++point) {
      seen.emplace_back(*point + near);
      seen.emplace_back(*point + far);
    }
  }
  return seen;
}

}  // namespace

Lens::Lens(const CameraIntrinsics& intrinsics, const FlatPortConfig& port)
    : size_(intrinsics.width, intrinsics.height) {
  // The same pixels per radian as the camera has at its centre: barrel distortion only ever
  // shrinks.
  const double focal = std::max(intrinsics.fx, intrinsics.fy);
  Gaze gaze = GazeOf(CameraModel(intrinsics), focal);
  const FlatPort window(port);
  std::vector<Eigen::Vector2d> by_inverse_depth;
  if (port.enabled) by_inverse_depth = BehindPort(window, gaze.middles);
  source_ = Covering(port.enabled ? AllSeen(gaze, window, by_inverse_depth) : gaze.points, focal);
  RequireInput(source_.width <= 4 * intrinsics.width && source_.height <= 4 * intrinsics.height,
               "the rig's stereo.cameras: without its distortion the view has {}x{} px, must have "
               "at most four times {}x{}: the simulator draws no wider lens",
               source_.width, source_.height, intrinsics.width, intrinsics.height);
  counts_ = std::move(gaze.counts);
  if (port.enabled) {
    constexpr int kParts = 1 << kPartBits;
    warp_.emplace(window, source_, size_.width, gaze.middles, by_inverse_depth);
    for (const Eigen::Vector2d& point : gaze.points) {
      places_.emplace_back(static_cast<float>(point.x() * source_.focal + source_.cx),
                           static_cast<float>(point.y() * source_.focal + source_.cy));
    }
    for (int part = 0; part < kParts; ++part)
      weights_.push_back(CatmullRom(static_cast<float>(part) / kParts));
    return;
  }
  samples_.reserve(gaze.points.size());
  for (const Eigen::Vector2d& point : gaze.points) samples_.push_back(SampleAt(point));
  nearest_.reserve(gaze.middles.size());
  for (const Eigen::Vector2d& middle : gaze.middles) {
    const double column = middle.x() * source_.focal + source_.cx;
    const double row = middle.y() * source_.focal + source_.cy;
    nearest_.emplace_back(static_cast<int>(std::ceil(column - 0.5)),
                          static_cast<int>(std::ceil(row - 0.5)));
  }
}

Lens::Sample Lens::SampleAt(const Eigen::Vector2d& ideal) const {
  const double column = ideal.x() * source_.focal + source_.cx;
  const double row = ideal.y() * source_.focal + source_.cy;
  Sample sample;
  sample.column = static_cast<int>(std::floor(column));
  sample.row = static_cast<int>(std::floor(row));
  sample.across = CatmullRom(static_cast<float>(column - sample.column));
  sample.down = CatmullRom(static_cast<float>(row - sample.row));
  return sample;
}

template <int kChannels, bool kBehindPort>
void Lens::Resample(const cv::Mat& pinhole_image, const cv::Mat& depth, cv::Mat& out) const {
  using Pixel = Eigen::Array<float, kChannels, 1>;
  const auto add = [&](int column, int row, const Weights& across, const Weights& down,
                       Pixel& sum) {
    for (int i = 0; i < 4; ++i) {
      const float* in = pinhole_image.ptr<float>(row - 1 + i) + kChannels * (column - 1);
      Pixel line = Pixel::Zero();
      for (int k = 0; k < 4; ++k) {
        line += across[static_cast<std::size_t>(k)] * Eigen::Map<const Pixel>(in + kChannels * k);
      }
      sum += down[static_cast<std::size_t>(i)] * line;
    }
  };
  constexpr int kParts = 1 << kPartBits;
  constexpr float kToNearest = 0.5F;  // Whole numbers are had by cutting off.
  const Weights* weights = weights_.data();
  const cv::Point2f* place = places_.data();
  const Sample* sample = samples_.data();
  PortWarp::Depths depths;
  if constexpr (kBehindPort) depths = warp_->Survey(depth);
  PortWarp::Row shift;
  const int* count = counts_.data();
  for (int v = 0; v < size_.height; ++v) {
    if constexpr (kBehindPort) warp_->ShiftRow(v, depths, shift);
    const float* shift_across = shift.across.data();
    const float* shift_down = shift.down.data();
    auto* pixels = out.ptr<float>(v);
    for (int u = 0; u < size_.width; ++u, ++count) {
      Pixel sum = Pixel::Zero();
      for (int n = 0; n < *count; ++n) {
        if constexpr (kBehindPort) {
          const int x = static_cast<int>(kParts * (place->x + shift_across[u]) + kToNearest);
          const int y = static_cast<int>(kParts * (place->y + shift_down[u]) + kToNearest);
          ++place;
          add(x >> kPartBits, y >> kPartBits, weights[x & (kParts - 1)], weights[y & (kParts - 1)],
              sum);
        } else {
          add(sample->column, sample->row, sample->across, sample->down, sum);
          ++sample;
        }
      }
      if (*count > 1) sum /= static_cast<float>(*count);
      // The kernel overshoots at edges; light is never negative.
      Eigen::Map<Pixel>(pixels + kChannels * u) = sum.max(0.F);
    }
  }
}

void Lens::ApplySmooth(const cv::Mat& pinhole_image, cv::Mat& out) const {
  Check(!warp_, "a lens behind a flat port needs the image's depth");
  ApplySmooth(pinhole_image, {}, out);
}

void Lens::ApplySmooth(const cv::Mat& pinhole_image, const cv::Mat& depth, cv::Mat& out) const {
  const cv::Size source(source_.width, source_.height);
  Check(pinhole_image.size() == source && pinhole_image.depth() == CV_32F,
        "the lens needs the float image of its own pinhole");
  Check(!warp_ || (depth.size() == source && depth.type() == CV_32FC1 && depth.isContinuous()),
        "the lens needs the depth of its own pinhole");
  out.create(size_, pinhole_image.type());
  const bool is_grey = pinhole_image.channels() == 1;
  if (warp_ && is_grey) {
    Resample<1, true>(pinhole_image, depth, out);
  } else if (warp_) {
    Resample<3, true>(pinhole_image, depth, out);
  } else if (is_grey) {
    Resample<1, false>(pinhole_image, depth, out);
  } else {
    Resample<3, false>(pinhole_image, depth, out);
  }
}

void Lens::ApplyNearest(const cv::Mat& depth, cv::Mat& out) const {
  out.create(size_, CV_32FC1);
  const cv::Point* nearest = nearest_.data();
  PortWarp::Depths depths;
  if (warp_) depths = warp_->Survey(depth);
  PortWarp::Row row;
  for (int v = 0; v < size_.height; ++v) {
    auto* pixels = out.ptr<float>(v);
    if (warp_) {
      warp_->SeeDepth(v, depth, depths, row, pixels);
      continue;
    }
    for (int u = 0; u < size_.width; ++u, ++nearest) pixels[u] = depth.at<float>(*nearest);
  }
}

}  // namespace drydock::sim
