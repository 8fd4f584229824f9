// Draws one cloud of silt into a finished image of light.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "sensors_models/base/pose.h"
#include "sim/optics/light_at.h"
#include "sim/optics/silt_config.h"
#include "sim/optics/silt_rows.h"
#include "sim/optics/underwater_optics.h"
#include "sim/render/pinhole.h"

namespace drydock::sim {

/// What a camera looks at.
struct SiltView {
  const cv::Mat& depth;  ///< Along the axis [CV_32FC1, m]; infinite where nothing is.
  const Pose& T_WC;
  ImageChannels channels;
  const LightAt& light;
};

/// A cloud at one time.
struct DrawnSilt {
  SiltBlob whole;               ///< For its light: one blob instead of all.
  std::vector<SiltBlob> puffs;  ///< What it is made of.
  Eigen::Array3f albedo;
};

/// The law is in Silt's comment. Per pixel: the optical depth. On a raster of pixels, and
/// interpolated: light, and the water before the cloud.
class SiltPainter {
 public:
  /// `beam_attenuation` is that of the water [1/m].
  SiltPainter(const Pinhole& pinhole, const Eigen::Array3f& beam_attenuation);

  /// `radiance` is CV_32FC1 or CV_32FC3 by the view's channels.
  void Draw(const DrawnSilt& silt, const SiltView& view, cv::Mat& radiance) const;

  /// Nothing is drawn of a puff where its optical depth is less.
  static constexpr double kLeast = 1e-4;

 private:
  /// Whole cells of the raster, ends excluded.
  struct Window {
    int column_begin = 0, column_end = 0;
    int row_begin = 0, row_end = 0;
  };
  /// A puff as the camera has it, and where it shows.
  struct Puff {
    rows::BlobInCamera blob = {};
    Window window;
  };
  /// One delivered channel of what the cloud sends out and hides, CV_32FC1, at the raster's points.
  struct Plane {
    cv::Mat source, share;
  };
  static constexpr int kRaster = 16;  ///< [px]

  std::optional<Window> FindWindow(const rows::BlobInCamera& blob) const;
  std::vector<Puff> FindPuffs(const std::vector<SiltBlob>& puffs, const Pose& T_CW) const;
  std::vector<Plane> LookAtRaster(const DrawnSilt& silt, const Window& window,
                                  const SiltView& view) const;
  /// The opacity of row `v` from the window's first column on.
  void FindOpacity(const std::vector<Puff>& puffs, const Window& window, int v,
                   const cv::Mat& depth, std::vector<float>& opacity) const;
  int ColumnEnd(const Window& window) const;

  Pinhole pinhole_;
  Eigen::Array3f beam_attenuation_;
  std::vector<float> columns_;  ///< (u - cx) / focal
};

}  // namespace drydock::sim
