// Makes hazy images fit for corners and patches.
#pragma once

#include <opencv2/core/mat.hpp>
#include <opencv2/imgproc.hpp>

namespace drydock::svin2 {

/// Noise handling, removal of the background, contrast adjustment and CLAHE, in this order, so that
/// what haze has left of the contrast is spread out and the sensor's noise is not. Deterministic.
class Preprocessor {
 public:
  struct Config {
    /// Gaussian against the sensor's noise [px]; 0: none.
    double denoise_sigma_px = 0.8;

    /// What varies more slowly over the image than a Gaussian of this width is taken away [px; 0:
    /// nothing is]. The water's veil and the lens's vignetting stay where they are while the scene
    /// moves past: in haze they are most of a patch's contrast and hold it back.
    double background_sigma_px = 30.0;

    /// Contrast adjustment: what lies between two percentiles of the image is spread linearly over
    /// the 256 codes. Done before rounding: the filter's fractions of a grey level survive.
    bool adjust_contrast = true;
    double low_percentile = 0.5;
    double high_percentile = 99.5;
    double max_gain = 8.0;  ///< A blank image stays blank.

    /// Contrast-limited adaptive histogram equalisation (Zuiderveld 1994).
    bool clahe = true;
    double clahe_clip_limit = 3.0;  ///< Highest bin, as a multiple of a flat histogram's.
    int clahe_tiles = 8;            ///< Along each side of the image.
  };

  /// Throws InputError for values that cannot be used.
  explicit Preprocessor(const Config& config);

  /// A grey image (CV_8UC1), halved `halvings` times before all else: of a coarse image much of the
  /// noise is gone, and what stands out is no longer hidden from CLAHE. Pixel p of it is pixel
  /// 2^halvings p. `image` is CV_8UC1 or CV_8UC3 (BGR), and not empty.
  cv::Mat Process(const cv::Mat& image, int halvings = 0);

 private:
  cv::Mat WithoutBackground(const cv::Mat& fine) const;
  cv::Mat AdjustContrast(const cv::Mat& fine) const;

  Config config_;
  cv::Ptr<cv::CLAHE> clahe_;
};

}  // namespace drydock::svin2
