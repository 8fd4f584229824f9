#include "scenarios/gallery/picture_rows.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "scenarios/report/canvas.h"
#include "sensors_models/base/check.h"
#include "sensors_models/base/files.h"

namespace drydock {
namespace {

constexpr double kTileWidth = 400.0, kTileHeight = 300.0, kGap = 8.0, kLabel = 26.0;

cv::Mat InColor(const cv::Mat& picture) {
  if (picture.channels() == 3) return picture;
  cv::Mat color;
  cv::cvtColor(picture, color, cv::COLOR_GRAY2BGR);
  return color;
}

}  // namespace

void WritePictureRows(const std::filesystem::path& path, const std::vector<PictureRow>& rows) {
  Check(!rows.empty(), "there are no pictures to be drawn");
  const auto columns = static_cast<double>(rows.front().pictures.size());
  const auto width = static_cast<int>(columns * (kTileWidth + kGap) + kGap);
  const auto height =
      static_cast<int>(static_cast<double>(rows.size()) * (kTileHeight + kLabel + kGap) + kGap);
  report::Canvas canvas(width, height, report::kPaper);
  double y = kGap;
  for (const PictureRow& row : rows) {
    canvas.Text(row.label, {kGap, y + 18.0}, 11.0, report::kInk);
    y += kLabel;
    double x = kGap;
    for (const cv::Mat& picture : row.pictures) {
      canvas.Picture(InColor(picture), {x, y, kTileWidth, kTileHeight});
      x += kTileWidth + kGap;
    }
    y += kTileHeight + kGap;
  }
  std::vector<unsigned char> bytes;
  cv::imencode(".jpg", canvas.Finish(), bytes, {cv::IMWRITE_JPEG_QUALITY, 85});
  WriteFileAtomically(path, std::string(bytes.begin(), bytes.end()));
}

}  // namespace drydock
