#include "sim/render/lens.h"

#include <Eigen/Core>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include <opencv2/core.hpp>

#include "sensors_models/base/check.h"

namespace drydock::sim {
namespace {

/// Columns that bicubic interpolation needs beyond the outermost sample.
constexpr double kMargin = 3.0;  // [px]

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

}  // namespace

Lens::Lens(const CameraIntrinsics& intrinsics) : size_(intrinsics.width, intrinsics.height) {
  // The same pixels per radian as the camera has at its centre: barrel distortion only ever
  // shrinks.
  const double focal = std::max(intrinsics.fx, intrinsics.fy);
  const Gaze gaze = GazeOf(CameraModel(intrinsics), focal);
  source_ = Covering(gaze.points, focal);
  RequireInput(source_.width <= 4 * intrinsics.width && source_.height <= 4 * intrinsics.height,
               "the rig's stereo.cameras: without its distortion the view has {}x{} px, must have "
               "at most four times {}x{}: the simulator draws no wider lens",
               source_.width, source_.height, intrinsics.width, intrinsics.height);
  counts_ = gaze.counts;
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

template <int kChannels>
void Lens::Resample(const cv::Mat& pinhole_image, cv::Mat& out) const {
  using Pixel = Eigen::Array<float, kChannels, 1>;
  const Sample* sample = samples_.data();
  const int* count = counts_.data();
  for (int v = 0; v < size_.height; ++v) {
    auto* pixels = out.ptr<float>(v);
    for (int u = 0; u < size_.width; ++u, ++count) {
      Pixel sum = Pixel::Zero();
      for (int n = 0; n < *count; ++n, ++sample) {
        for (int i = 0; i < 4; ++i) {
          const float* in =
              pinhole_image.ptr<float>(sample->row - 1 + i) + kChannels * (sample->column - 1);
          Pixel row = Pixel::Zero();
          for (int k = 0; k < 4; ++k) {
            row += sample->across[static_cast<std::size_t>(k)] *
                   Eigen::Map<const Pixel>(in + kChannels * k);
          }
          sum += sample->down[static_cast<std::size_t>(i)] * row;
        }
      }
      if (*count > 1) sum /= static_cast<float>(*count);
      // The kernel overshoots at edges; light is never negative.
      Eigen::Map<Pixel>(pixels + kChannels * u) = sum.max(0.F);
    }
  }
}

void Lens::ApplySmooth(const cv::Mat& pinhole_image, cv::Mat& out) const {
  Check(pinhole_image.size() == cv::Size(source_.width, source_.height) &&
            pinhole_image.depth() == CV_32F,
        "the lens needs the float image of its own pinhole");
  out.create(size_, pinhole_image.type());
  if (pinhole_image.channels() == 1) {
    Resample<1>(pinhole_image, out);
  } else {
    Resample<3>(pinhole_image, out);
  }
}

void Lens::ApplyNearest(const cv::Mat& pinhole_image, cv::Mat& out) const {
  out.create(size_, CV_32FC1);
  const cv::Point* nearest = nearest_.data();
  for (int v = 0; v < size_.height; ++v) {
    for (int u = 0; u < size_.width; ++u, ++nearest)
      out.at<float>(v, u) = pinhole_image.at<float>(*nearest);
  }
}

}  // namespace drydock::sim
