// What the diver wears: neoprene with seams and a reflective stripe, a glove, a dive computer.
#pragma once

#include "scenes/texture/texture_task.h"

namespace drydock::scenes::creatures {

/// The picture `arm`, laid out as ArmPicture.
TextureTask ArmTexture();

}  // namespace drydock::scenes::creatures
