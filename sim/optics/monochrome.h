// How a sensor without colour filters weighs colours.
#pragma once

#include <array>

namespace drydock::sim {

/// What silicon makes of red, green and blue light, roughly.
inline constexpr std::array<float, 3> kMonochromeWeights = {0.30F, 0.45F, 0.25F};

}  // namespace drydock::sim
