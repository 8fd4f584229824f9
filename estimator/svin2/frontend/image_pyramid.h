// An image at all scales.
#pragma once

#include <cmath>
#include <vector>

#include <opencv2/core/mat.hpp>

namespace drydock::svin2 {

/// Level 0 is the image (CV_8UC1), each other level half as large as the one before. Pixel p of
/// level l is pixel 2^l p of the image.
using ImagePyramid = std::vector<cv::Mat>;

/// Pixels of the image that a pixel of an octave's level is wide. A point's octave is the level at
/// which it was found and is looked for: haze leaves least of what is fine, and noise most, so that
/// a coarse corner may stand out where no fine one does.
inline double OctaveScale(int octave) { return std::ldexp(1.0, octave); }

}  // namespace drydock::svin2
