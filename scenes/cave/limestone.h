// Paints limestone: what its pictures have in common.
#pragma once

#include "scenes/texture/canvas.h"

namespace drydock::scenes::cave {

/// Fractions of the surface, unless said otherwise.
struct Limestone {
  Rgb dark = Rgb(118, 104, 80);  ///< of the bare rock, between these
  Rgb bright = Rgb(216, 204, 176);
  double beds = 0.3;        ///< strength of the lines between beds
  double cracks = 0.4;      ///< where there are cracks
  double pits = 0.08;       ///< small hollows
  double holes = 0.05;      ///< hollows of a hand's breadth
  double iron = 0.12;       ///< orange-brown stains
  double manganese = 0.03;  ///< dark brown crust
  double streaks = 0.10;    ///< what ran down
  double silt = 0.06;       ///< settled
  double fossils = 12.0;    ///< shells and their fragments [1/m^2]
};

void PaintLimestone(Canvas& canvas, const Limestone& look, const NoiseKeys& keys);

/// Grain and specks of some millimetres, which a camera close by holds on to.
void AddGrain(Canvas& canvas, double grain, double specks, const NoiseKeys& keys);

}  // namespace drydock::scenes::cave
