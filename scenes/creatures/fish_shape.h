// The bodies of fish, in stiff parts that turn against each other.
#pragma once

#include <string>
#include <vector>

#include "scenes/creatures/loft.h"

namespace drydock::scenes::creatures {

/// How a kind of fish is built, in lengths of the fish: s runs from the snout (0) to the tips of
/// the tail (1), heights and widths are half ones.
struct FishShape {
  std::string kind;
  Profile back;             ///< Height of the back over s.
  Profile belly;            ///< Depth of the belly over s.
  Profile width;            ///< To either side, over s.
  Profile dorsal;           ///< Height of the fin on the back above the back, over s.
  Profile anal;             ///< Height of the fin behind the belly, over s.
  double tail_span = 0.14;  ///< Of the tail's tips from the middle.
  double tail_fork = 0.06;  ///< How far the tail's middle falls short of its tips.
};

/// A deep-bodied, a slender and a humped one.
std::vector<FishShape> FishShapes();

/// A stiff part of a fish one metre long: x forward, y left, z up, the origin kOrigin behind the
/// snout. All parts are in the frame of the straight fish; a part turns against the one ahead of it
/// about the vertical through x = joint. The first one's joint means nothing.
struct FishPart {
  Mesh mesh;
  double joint = 0.0;  ///< [m]
};

inline constexpr double kOrigin = 0.42;

/// From the head to the tail fin.
std::vector<FishPart> MakeFish(const FishShape& shape);

/// The picture of a fish one metre long, in metres: the skin lies unrolled at the top, from the
/// back (y = 0) to the belly; s is x. Both sides show the same. Fins have rectangles of their own.
struct FishPicture {
  static constexpr double kWidth = 1.0;
  static constexpr double kHeight = 0.64;
  static constexpr double kSkin = 0.40;  ///< Height of the skin.
  /// [low, high]; roots of fins at the top, tips at the bottom.
  static UvRect Tail() { return Rect(0.01, 0.43, 0.29, 0.63); }
  static UvRect Dorsal() { return Rect(0.31, 0.43, 0.99, 0.52); }
  static UvRect Anal() { return Rect(0.31, 0.54, 0.62, 0.63); }
  static UvRect Paired() { return Rect(0.64, 0.54, 0.99, 0.63); }

 private:
  static UvRect Rect(double x0, double y0, double x1, double y1) {
    return {{x0 / kWidth, y0 / kHeight}, {x1 / kWidth, y1 / kHeight}};
  }
};

}  // namespace drydock::scenes::creatures
