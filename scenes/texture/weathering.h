// What years under water do to paint, steel, vinyl: flaking, rust, growth, silt.
#pragma once

#include <cstdint>
#include <string_view>

#include "scenes/texture/canvas.h"

namespace drydock::scenes {

/// Fractions of the surface, unless said otherwise.
struct Weathering {
  double fading = 0.10;  ///< strength of large tints of the paint
  double primer = 0.05;  ///< bare primer around the rust, where paint has flaked
  double rust = 0.13;
  double edge_rust = 1.3;  ///< how much more rust at `edges`, in standard deviations
  double streaks = 0.30;   ///< rust running down
  double algae = 0.11;
  double film = 0.40;  ///< brownish growth, thin
  double silt = 0.15;
  double silt_alpha = 0.65;
  double mussels = 14.0;  ///< clusters have many, elsewhere few [1/m^2]
  double grain = 0.055;   ///< fine structure everywhere
  double specks = 0.02;   ///< dark and bright dots of some millimetres
  double largest = 0.55;  ///< of the rust's blotches [m]
};

/// Ages what is painted on the canvas. `edges` is white where water gets under the paint (seams,
/// rims, rivets); it may be empty.
void Age(Canvas& canvas, const Weathering& weathering, const cv::Mat1b& edges,
         const NoiseKeys& keys);

/// Only what settles on a surface: film, algae, silt, mussels, grain.
void Overgrow(Canvas& canvas, const Weathering& weathering, const NoiseKeys& keys);

/// Bare rusted steel from nothing: scales, pits, orange and brown.
void PaintRust(Canvas& canvas, const NoiseKeys& keys);

}  // namespace drydock::scenes
