// Grounds that several scenes paint on: stone, and things strewn over sand or silt.
#pragma once

#include <cstdint>
#include <functional>

#include "scenes/texture/canvas.h"
#include "sensors_models/base/random_stream.h"

namespace drydock::scenes {

/// A mask that is white all over.
cv::Mat1b Everywhere(const Canvas& canvas);

/// Dark and bright ends of what a stone is made of. Pale limestone unless said otherwise.
struct StoneColors {
  Rgb low{92, 88, 76};
  Rgb high{190, 184, 162};
  Rgb pit_low{40, 38, 32};
  Rgb pit_high{92, 86, 72};
  Rgb lichen_low{160, 154, 126};
  Rgb lichen_high{214, 208, 184};
};

/// Hewn stone with pits and lichen, over the whole canvas.
void PaintStone(Canvas& canvas, const NoiseKeys& keys, const StoneColors& colors = {});

/// Ripples of sand that meet themselves at the rim of a canvas that wraps.
struct RippleShape {
  int across = 0;          ///< Waves along the canvas's width,
  int down = 0;            ///< and along its height.
  double warp = 3.0;       ///< How far noise bends them [rad].
  double where_m = 2.0;    ///< Size of the stretches with more and with less of them [m].
  float strength = 0.6F;   ///< Mean; noise adds 0.7 times itself to it,
  float strongest = 1.3F;  ///< and it stays between 0 and this.
};
/// About a sine of that strength.
cv::Mat1f Ripples(const Canvas& canvas, const NoiseKeys& keys, const RippleShape& shape);

/// Draws one thing at (x, y) [m]; `size` is uniform in (0, 1).
using DrawThing =
    std::function<void(Canvas& canvas, double x, double y, double size, RandomStream& look)>;

/// `count` things all over a canvas that wraps; those at its rim are drawn again on the opposite
/// side.
void Strew(Canvas& canvas, int count, RandomStream& random, const DrawThing& draw);

}  // namespace drydock::scenes
