// The pictures of the docs that show what cameras see.
#pragma once

#include <filesystem>

namespace drydock {

/// The same views of the bus, a row for each kind of water and light, as a JPEG. InputError if it
/// cannot be written.
void WriteWaters(const std::filesystem::path& path);

/// Three views of each of the paper's dives. As above.
void WriteDives(const std::filesystem::path& path);

/// What else is in the water, a row for each: lamps, snow, caustics, silt, fish and an arm. As
/// above.
void WriteEffects(const std::filesystem::path& path);

/// What the front end makes of images in ever murkier water: as they are, pre-processed but for the
/// removal of their background, and pre-processed. As above.
void WritePreprocessing(const std::filesystem::path& path);

}  // namespace drydock
