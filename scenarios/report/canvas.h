// A small drawing surface: what plots and contact sheets need and no more.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

namespace drydock::report {

/// Blue, green, red, 0 to 255.
using Color = cv::Scalar;

inline const Color kInk{34, 34, 34};
inline const Color kFaintInk{110, 110, 110};
inline const Color kGridInk{228, 228, 228};
inline const Color kPaper{255, 255, 255};

/// The colour of the i-th of several things; well apart for colour-blind eyes too, repeating after
/// seven.
Color PaletteColor(std::size_t i);

enum class TextAnchor { kLeft, kCentre, kRight };

/// Everything is measured in pixels of the finished picture, x right and y down, and drawn twice as
/// large so that the finished lines and letters are smooth.
class Canvas {
 public:
  Canvas(int width, int height, const Color& background);

  int width() const { return width_; }
  int height() const { return height_; }

  void Line(cv::Point2d a, cv::Point2d b, const Color& color, double thickness);
  void Polyline(const std::vector<cv::Point2d>& points, const Color& color, double thickness);
  void Rectangle(const cv::Rect2d& box, const Color& color, double thickness);
  void FillRectangle(const cv::Rect2d& box, const Color& color);
  void FillCircle(cv::Point2d centre, double radius, const Color& color);
  /// `at` lies on the baseline; `size` is the height of a capital letter. ASCII only: other letters
  /// come out as '?'.
  void Text(const std::string& text, cv::Point2d at, double size, const Color& color,
            TextAnchor anchor = TextAnchor::kLeft);
  /// Puts a grey or BGR picture into `box`, scaled to fill it.
  void Picture(const cv::Mat& image, const cv::Rect2d& box);

  /// The width of a text [px].
  static double TextWidth(const std::string& text, double size);

  /// The finished picture, CV_8UC3.
  cv::Mat Finish() const;

 private:
  int width_;
  int height_;
  cv::Mat image_;
};

/// A picture as the bytes of a PNG file.
std::string EncodePng(const cv::Mat& image);

/// Complete or not at all; InputError if it cannot be written.
void WritePng(const std::filesystem::path& path, const cv::Mat& image);

}  // namespace drydock::report
