// The pictures of the docs that show water and light.
#pragma once

#include <filesystem>

namespace drydock {

/// Writes a JPEG: the same views of the bus, a row for each kind of water and light. InputError if
/// it cannot be written.
void WriteGallery(const std::filesystem::path& path);

}  // namespace drydock
