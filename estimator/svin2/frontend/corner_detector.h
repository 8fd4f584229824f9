// Corners, spread evenly over an image.
#pragma once

#include <Eigen/Core>
#include <vector>

#include <opencv2/core/mat.hpp>

namespace drydock::svin2 {

struct Corner {
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();  ///< Pixel centres lie on integers.
  float score = 0.0F;  ///< Smaller eigenvalue of the structure tensor (Shi and Tomasi 1994).
};

/// Finds at most a budget of corners, the strongest first, no two nearer than an occupancy radius.
/// Deterministic: equal scores go by row, then by column.
class CornerDetector {
 public:
  struct Config {
    int max_corners = 300;         ///< In the whole image, corners already there included.
    double radius_px = 16.0;       ///< Of occupancy about each corner.
    int border_px = 12;            ///< No corners nearer than this to the image's edge.
    double window_sigma_px = 1.5;  ///< Of the structure tensor's Gaussian weights.
    /// Least score, for grey values in [0, 1] and slopes per pixel, of a pre-processed image. In
    /// haze, most corners below 1e-3 are noise: they serve where tracking sorts them out.
    double min_score = 5e-4;
    double min_quality = 0.0;  ///< Least score as a share of the strongest in the image.
    /// Of the window in which corners are refined to sub-pixels [px], as junctions of edges or
    /// centres of blobs, whichever fits better (Foerstner and Guelch 1987); 0: no refinement.
    int refine_radius_px = 4;
    double max_refine_px = 3.0;  ///< What would move further stays at its pixel.
  };

  /// Throws InputError for values that cannot be used.
  explicit CornerDetector(const Config& config);

  /// New corners in `image` (CV_8UC1), away from those `occupied` and only where `mask` is not zero
  /// (CV_8UC1 of the image's size; empty: everywhere).
  std::vector<Corner> Detect(const cv::Mat& image,
                             const std::vector<Eigen::Vector2d>& occupied = {},
                             const cv::Mat& mask = {}) const;

 private:
  Eigen::Vector2d Refined(const cv::Mat& image, const Eigen::Vector2d& pixel) const;
  cv::Mat Scores(const cv::Mat& image) const;
  std::vector<Corner> Candidates(const cv::Mat& scores, const cv::Mat& mask) const;

  Config config_;
};

}  // namespace drydock::svin2
