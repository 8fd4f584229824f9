#include <vector>

#include <fmt/format.h>

#include "estimator/svin2/frontend/preprocessor.h"
#include "scenarios/gallery/dive_views.h"
#include "scenarios/gallery/gallery.h"
#include "scenarios/gallery/picture_rows.h"

namespace drydock {

void WritePreprocessing(const std::filesystem::path& path) {
  constexpr double kAtTheFront = 36.0;  // [s]
  svin2::Preprocessor preprocessor({});
  svin2::Preprocessor with_background({.background_sigma_px = 0.0});
  std::vector<PictureRow> rows;
  for (const double visibility_m : {12.0, 6.0, 3.0}) {
    const cv::Mat image =
        LeftImages({"bus", {fmt::format("water.visibility_m={}", visibility_m)}, {kAtTheFront}})
            .front();
    rows.push_back(
        {fmt::format("V = {} m: the image; pre-processed with its background; and without",
                     visibility_m),
         {image, with_background.Process(image), preprocessor.Process(image)}});
  }
  WritePictureRows(path, rows);
}

}  // namespace drydock
