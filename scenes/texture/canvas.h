// A picture in metres to paint a texture on.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include <opencv2/core.hpp>

#include "scenes/texture/noise_field.h"

namespace drydock::scenes {

/// Red, green, blue.
using Rgb = cv::Vec3b;

/// Keys of named noise fields of one texture: Key("rust") is the same on every run.
class NoiseKeys {
 public:
  NoiseKeys(std::uint64_t seed, std::string_view texture);
  std::uint64_t Key(std::string_view name) const;

 private:
  std::uint64_t base_;
};

/// An RGB image with a scale. Positions are in metres from the top left corner, x right, y down.
class Canvas {
 public:
  /// [m] and [pixels/m]. With `wrap`, noise meets itself at opposite sides.
  Canvas(double width, double height, double pixels_per_metre, const Rgb& color, bool wrap = false);

  cv::Mat3b& image() { return image_; }
  const cv::Mat3b& image() const { return image_; }
  cv::Size size() const { return image_.size(); }
  double width() const { return width_; }    ///< [m]
  double height() const { return height_; }  ///< [m]
  double scale() const { return scale_; }    ///< [pixels/m]
  bool wrap() const { return wrap_; }
  /// A position as OpenCV's drawing wants it: fixed point with kShift fractional bits.
  static constexpr int kShift = 4;
  cv::Point Fixed(double x, double y) const;
  int FixedLength(double metres) const;
  /// At least one pixel.
  int Pixels(double metres) const;

  /// Noise with features from `largest` down to `smallest` [m].
  cv::Mat1f Noise(double largest, double smallest, double gain, std::uint64_t key,
                  double stretch_y = 1.0) const;
  /// An empty mask of this size.
  cv::Mat1b Mask() const { return cv::Mat1b(image_.size(), std::uint8_t{0}); }

  /// Paints where the mask is, alpha in [0, 1].
  void Blend(const cv::Mat1b& mask, const Rgb& color, double alpha = 1.0);
  /// Paints a colour between `low` (mix below -2) and `high` (above 2).
  void Blend(const cv::Mat1b& mask, const cv::Mat1f& mix, const Rgb& low, const Rgb& high,
             double alpha = 1.0);
  /// Multiplies every pixel by 1 + amount * field, the field clamped to +-2.5.
  void Modulate(const cv::Mat1f& field, double amount);
  /// Multiplies by 1 - amount where the mask is: grime.
  void Darken(const cv::Mat1b& mask, double amount);

 private:
  double width_;
  double height_;
  double scale_;
  bool wrap_;
  cv::Mat3b image_;
};

/// Blurs a mask by about `sigma` pixels, exactly the same on every machine (box filters on
/// integers).
void SoftenMask(cv::Mat1b& mask, int sigma);

/// PNG, compressed lightly: these textures are written once and read at every start.
void WritePng(const cv::Mat3b& rgb, const std::filesystem::path& path);

}  // namespace drydock::scenes
