// The cemetery's pictures.
#pragma once

#include <vector>

#include "scenes/cemetery/inscriptions.h"
#include "scenes/texture/materials.h"
#include "scenes/texture/texture_task.h"

namespace drydock::scenes::cemetery {

/// Every texture that the parts refer to.
std::vector<TextureTask> TextureTasks();

// What the files of textures share:

/// The dark stone; the pale one is limestone.
StoneColors SlateColors();
/// Growth and silt on gravestones.
void OvergrowStone(Canvas& canvas, const NoiseKeys& keys);
/// The atlas of inscriptions, see inscriptions.h.
cv::Mat3b PaintInscriptions(const std::vector<Inscription>& inscriptions, std::uint64_t seed,
                            double scale);

}  // namespace drydock::scenes::cemetery
