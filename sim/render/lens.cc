#include "sim/render/lens.h"

#include <Eigen/Core>
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

}  // namespace

Lens::Lens(const CameraIntrinsics& intrinsics) : size_(intrinsics.width, intrinsics.height) {
  const CameraModel camera(intrinsics);
  cv::Mat ideal(intrinsics.height, intrinsics.width, CV_64FC2);
  cv::Vec2d low(1e9, 1e9), high(-1e9, -1e9);
  for (int v = 0; v < intrinsics.height; ++v) {
    for (int u = 0; u < intrinsics.width; ++u) {
      const auto point = camera.Unproject({u, v});
      RequireInput(point.has_value(),
                   "the distortion cannot be inverted at pixel ({}, {}): smaller coefficients", u,
                   v);
      ideal.at<cv::Vec2d>(v, u) = {point->x(), point->y()};
      for (int axis = 0; axis < 2; ++axis) {
        low[axis] = std::min(low[axis], (*point)[axis]);
        high[axis] = std::max(high[axis], (*point)[axis]);
      }
    }
  }
  // The same pixels per radian as the camera has at its centre: barrel distortion only ever
  // shrinks.
  source_.focal = std::max(intrinsics.fx, intrinsics.fy);
  source_.cx = std::ceil(-low[0] * source_.focal + kMargin);
  source_.cy = std::ceil(-low[1] * source_.focal + kMargin);
  source_.width = static_cast<int>(std::ceil(high[0] * source_.focal + source_.cx + kMargin)) + 1;
  source_.height = static_cast<int>(std::ceil(high[1] * source_.focal + source_.cy + kMargin)) + 1;
  RequireInput(source_.width <= 4 * intrinsics.width && source_.height <= 4 * intrinsics.height,
               "the distortion widens the view more than fourfold: smaller coefficients");

  samples_.reserve(ideal.total());
  for (int v = 0; v < intrinsics.height; ++v) {
    for (int u = 0; u < intrinsics.width; ++u) {
      const auto& point = ideal.at<cv::Vec2d>(v, u);
      const double column = point[0] * source_.focal + source_.cx;
      const double row = point[1] * source_.focal + source_.cy;
      Sample sample;
      sample.column = static_cast<int>(std::floor(column));
      sample.row = static_cast<int>(std::floor(row));
      sample.across = CatmullRom(static_cast<float>(column - sample.column));
      sample.down = CatmullRom(static_cast<float>(row - sample.row));
      sample.right_half = column - sample.column > 0.5;
      sample.lower_half = row - sample.row > 0.5;
      samples_.push_back(sample);
    }
  }
}

template <int kChannels>
void Lens::Resample(const cv::Mat& pinhole_image, cv::Mat& out) const {
  using Pixel = Eigen::Array<float, kChannels, 1>;
  const Sample* sample = samples_.data();
  for (int v = 0; v < size_.height; ++v) {
    auto* pixels = out.ptr<float>(v);
    for (int u = 0; u < size_.width; ++u, ++sample) {
      Pixel sum = Pixel::Zero();
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
  const Sample* sample = samples_.data();
  for (int v = 0; v < size_.height; ++v) {
    for (int u = 0; u < size_.width; ++u, ++sample) {
      out.at<float>(v, u) = pinhole_image.at<float>(sample->row + (sample->lower_half ? 1 : 0),
                                                    sample->column + (sample->right_half ? 1 : 0));
    }
  }
}

}  // namespace drydock::sim
