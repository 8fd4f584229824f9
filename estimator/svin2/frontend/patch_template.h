// A small piece of an image that can be found again to a tenth of a pixel.
#pragma once

#include <Eigen/Core>
#include <optional>

#include <opencv2/core/mat.hpp>

namespace drydock::svin2 {

struct PatchAlignment {
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  /// Of the patch as it was cut out to the patch found: turn, stretch and shear.
  Eigen::Matrix2d warp = Eigen::Matrix2d::Identity();
  double correlation = 0.0;  ///< Of the grey values, -1 to 1.
};

/// What inverse compositional alignment needs of a patch, prepared once (Baker and Matthews 2004).
/// Changes of brightness and contrast are always solved for, an affine deformation on request.
class PatchTemplate {
 public:
  /// The patch of `image` (CV_8UC1) about `pixel`, (2 radius + 1)^2 large. Nothing where it leaves
  /// the image or has too little texture to be located.
  static std::optional<PatchTemplate> Make(const cv::Mat& image, const Eigen::Vector2d& pixel,
                                           int radius);

  /// Finds the patch in `to` (CV_8UC1) near `start`. It is looked for as deformed by `warp`, and
  /// only shifts; if `affine`, it also deforms. Nothing if the patch leaves the image or the search
  /// moves on and on.
  std::optional<PatchAlignment> Align(const cv::Mat& to, const Eigen::Vector2d& start,
                                      const Eigen::Matrix2d& warp, bool affine) const;

  int radius() const { return radius_; }

 private:
  // Shift x, y; contrast; brightness; then the shift's change with x and y (four entries).
  static constexpr int kParameters = 8;
  using Values = Eigen::VectorXf;
  using Vector8d = Eigen::Matrix<double, kParameters, 1>;
  using Matrix8d = Eigen::Matrix<double, kParameters, kParameters>;

  PatchTemplate() = default;
  Vector8d Step(const Values& difference, bool affine) const;
  double Correlation(const Values& found) const;

  int radius_ = 0;
  Values values_;                                             // Grey, less their mean.
  Eigen::Matrix<float, kParameters, Eigen::Dynamic> slopes_;  // A column for each value.
  Eigen::Matrix4d shift_inverse_;  // Of the normal matrix of the first four parameters,
  Matrix8d affine_inverse_;        // and of all eight.
  double energy_ = 0.0;            // Sum of the squared values.
};

}  // namespace drydock::svin2
