// A diver's forearm with glove and dive computer.
#pragma once

#include "scenes/creatures/loft.h"

namespace drydock::scenes::creatures {

enum class Side { kLeft, kRight };

/// The arm in one stiff piece: the elbow at the origin, x towards the hand, y left, z up where the
/// back of the hand is. The finger tips are at x = kArmReach; behind the elbow the sleeve runs on
/// down and back, so that no end of it comes into view.
Mesh MakeArm(Side side);
inline constexpr double kArmReach = 0.45;  ///< [m], to some millimetres.

/// The picture of the arm, in metres. Sleeve and glove lie unrolled from the top of the arm (left)
/// to its underside (right); both sides show the same.
struct ArmPicture {
  static constexpr double kWidth = 0.48;
  static constexpr double kHeight = 0.56;
  static constexpr double kSleeveWidth = 0.17;
  static constexpr double kElbow = 0.28;  ///< Where the elbow lies on the sleeve.
  static constexpr double kGloveLeft = 0.18;
  static constexpr double kGloveWidth = 0.13;
  static constexpr double kCuff = 0.195;    ///< Where the glove begins, from the elbow.
  static constexpr double kFingers = 0.24;  ///< Top of the fingers' patch.
  static constexpr double kFingerWidth = 0.04;
  /// The dive computer's face, its rim included.
  static UvRect Face() {
    return {{0.34 / kWidth, 0.02 / kHeight}, {0.46 / kWidth, 0.14 / kHeight}};
  }
};

}  // namespace drydock::scenes::creatures
