// The file that a vocabulary is kept in.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "estimator/svin2/vocabulary/vocabulary_tree.h"

namespace drydock::svin2 {

/// Numbers are little-endian. 24 bytes of header:
///
///     char[8]  "DryVocab"
///     u32      version: 1
///     u32      size of the compressed tree in bytes: all that follows the header
///     u32      size of the tree in bytes
///     u32      CRC-32 of the tree (before compression)
///
/// and the tree, compressed by zlib (RFC 1950):
///
///     u32      branching factor
///     u32      levels
///     u32      nodes N
///     u8[N]    children of each node
///     u64[8]   centre of each node but the root, as the bits that differ from its parent's: most
///              do not, which compresses (the root's centre is zero)
///     f32      weight of each leaf
inline constexpr std::size_t kMaxVocabularyFileBytes = std::size_t{80} << 20;

std::string FormatVocabulary(const VocabularyTree& tree);

/// The tree of a file's content, valid; InputError naming `name` and what is wrong: another kind of
/// file, another version, cut short, damaged.
VocabularyTree ParseVocabulary(std::string_view content, const std::string& name);

/// The header and the compression alone, around whatever bytes.
std::string PackVocabulary(std::string_view tree);
std::string UnpackVocabulary(std::string_view content, const std::string& name);

}  // namespace drydock::svin2
