// The pictures of the docs that show what cameras see.
#pragma once

#include <filesystem>

namespace drydock {

/// The same views of the bus, a row for each kind of water and light, as a JPEG. InputError if it
/// cannot be written.
void WriteGallery(const std::filesystem::path& path);

/// What the front end makes of images in ever murkier water: as they are, pre-processed but for the
/// removal of their background, and pre-processed. As above.
void WritePreprocessing(const std::filesystem::path& path);

}  // namespace drydock
