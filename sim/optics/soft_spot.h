// Small things drawn into a finished image of light.
#pragma once

#include <array>
#include <vector>

#include <opencv2/core/mat.hpp>

namespace drydock::sim {

/// A lump with soft edges, about an ellipse. Pixel centres lie on integers.
struct SoftSpot {
  double u = 0.0, v = 0.0;              ///< Its middle [px].
  double along_u = 1.0, along_v = 0.0;  ///< Direction of the first axis, a unit vector.
  /// Half axes where it would be sharp [px]: what it covers is pi times their product.
  double half_along = 1.0, half_across = 1.0;
  /// By which shares its radius changes as the cosine and sine of three times the angle from the
  /// first axis; together less than 1.
  double lobe_cos = 0.0, lobe_sin = 0.0;
  double edge = 1.0;   ///< Width over which the edges fade [px].
  double depth = 0.0;  ///< Along the optical axis [m].
  double cover = 1.0;  ///< What it hides where it covers a pixel wholly.
};

/// radiance = radiance + a (source - share radiance) in up to three channels.
struct SpotLight {
  std::array<float, 3> source = {};
  std::array<float, 3> share = {};
};

/// Draws spots one after the other.
class SpotPainter {
 public:
  /// `depth` [CV_32FC1, m] hides spots that are farther; `radiance` is CV_32FC1 or CV_32FC3. Both
  /// must outlive the painter.
  SpotPainter(const cv::Mat& depth, cv::Mat& radiance);

  /// The sum of what pixels are covered is just what the spot covers, whatever its size and
  /// wherever its middle lies between pixels, so that a spot smaller than a pixel dims as it
  /// shrinks; only what lies off the image or behind something is lost.
  void Draw(const SoftSpot& spot, const SpotLight& light);

 private:
  struct Box {
    int u_begin, u_end, v_begin, v_end;
  };
  /// Fills weights_ with the spot's shape over all of the box and gives their sum.
  double Weigh(const SoftSpot& spot, const Box& box);

  const cv::Mat& depth_;
  cv::Mat& radiance_;
  std::vector<float> weights_;
};

}  // namespace drydock::sim
