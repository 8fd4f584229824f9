#include "estimator/svin2/vocabulary/vocabulary_file.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <type_traits>

#include <zlib.h>

#include "sensors_models/base/check.h"

namespace drydock::svin2 {
namespace {

constexpr std::string_view kMagic = "DryVocab";
constexpr std::uint32_t kVersion = 1;
constexpr std::size_t kHeaderBytes = 24;

template <typename Unsigned>
void Append(std::string& bytes, Unsigned value) {
  static_assert(std::is_unsigned_v<Unsigned>);
  for (std::size_t i = 0; i < sizeof(value); ++i) {
    bytes.push_back(static_cast<char>(static_cast<unsigned char>(value >> (8 * i))));
  }
}

/// Takes numbers off the front of bytes.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  template <typename Unsigned>
  Unsigned Take() {
    RequireInput(bytes_.size() >= sizeof(Unsigned), "the tree ends too early");
    Unsigned value = 0;
    for (std::size_t i = 0; i < sizeof(value); ++i) {
      const auto byte = static_cast<unsigned char>(bytes_[i]);
      value = static_cast<Unsigned>(value | static_cast<Unsigned>(byte) << (8 * i));
    }
    bytes_.remove_prefix(sizeof(value));
    return value;
  }

  std::size_t left() const { return bytes_.size(); }

 private:
  std::string_view bytes_;
};

std::uint32_t Checksum(std::string_view bytes) {
  return static_cast<std::uint32_t>(
      crc32_z(crc32_z(0, nullptr, 0), reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

std::string Compress(std::string_view bytes) {
  uLongf size = compressBound(bytes.size());
  std::string compressed(size, '\0');
  const int result =
      compress2(reinterpret_cast<Bytef*>(compressed.data()), &size,
                reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), Z_BEST_COMPRESSION);
  Check(result == Z_OK, "zlib cannot compress {} bytes: error {}", bytes.size(), result);
  compressed.resize(size);
  return compressed;
}

/// Calls `visit(node, parent)` for each node but the root, in order, as long as there are any.
template <typename Visit>
void VisitChildren(const std::vector<std::uint8_t>& children, Visit visit) {
  std::size_t node = 1;
  for (std::size_t parent = 0; parent < children.size(); ++parent) {
    for (int i = 0; i < children[parent] && node < children.size(); ++i) visit(node++, parent);
  }
}

Descriptor CentreOf(const VocabularyTree& tree, std::size_t node) {
  return node == 0 ? Descriptor{} : tree.centres[node - 1];
}

std::string FormatTree(const VocabularyTree& tree) {
  std::string bytes;
  Append(bytes, static_cast<std::uint32_t>(tree.branching));
  Append(bytes, static_cast<std::uint32_t>(tree.levels));
  Append(bytes, static_cast<std::uint32_t>(tree.children.size()));
  for (const std::uint8_t count : tree.children) Append(bytes, count);
  VisitChildren(tree.children, [&](std::size_t node, std::size_t parent) {
    const Descriptor from = CentreOf(tree, parent), to = CentreOf(tree, node);
    for (std::size_t i = 0; i < to.size(); ++i) Append(bytes, to[i] ^ from[i]);
  });
  for (const float weight : tree.weights) Append(bytes, std::bit_cast<std::uint32_t>(weight));
  return bytes;
}

VocabularyTree ParseTree(std::string_view bytes) {
  ByteReader reader(bytes);
  VocabularyTree tree;
  const auto branching = reader.Take<std::uint32_t>(), levels = reader.Take<std::uint32_t>();
  // Whatever does not fit an int is out of bounds, which Vocabulary says.
  constexpr std::uint32_t kMost = std::numeric_limits<int>::max();
  tree.branching = static_cast<int>(std::min(branching, kMost));
  tree.levels = static_cast<int>(std::min(levels, kMost));
  const auto nodes = reader.Take<std::uint32_t>();
  RequireInput(nodes >= 1 && nodes <= kMaxVocabularyNodes && nodes <= reader.left(),
               "the tree cannot have {} nodes in {} bytes", nodes, bytes.size());
  for (std::uint32_t i = 0; i < nodes; ++i) tree.children.push_back(reader.Take<std::uint8_t>());
  TreeDepth(tree.children);  // Parents must come before their children.
  VisitChildren(tree.children, [&](std::size_t, std::size_t parent) {
    Descriptor centre = CentreOf(tree, parent);
    for (std::uint64_t& bits : centre) bits ^= reader.Take<std::uint64_t>();
    tree.centres.push_back(centre);
  });
  const auto words = std::ranges::count(tree.children, 0);
  for (std::ptrdiff_t i = 0; i < words; ++i) {
    tree.weights.push_back(std::bit_cast<float>(reader.Take<std::uint32_t>()));
  }
  RequireInput(reader.left() == 0, "{} bytes follow the tree", reader.left());
  RequireTree(tree);
  return tree;
}

}  // namespace

std::string PackVocabulary(std::string_view tree) {
  const std::string compressed = Compress(tree);
  std::string bytes(kMagic);
  Append(bytes, kVersion);
  Append(bytes, static_cast<std::uint32_t>(compressed.size()));
  Append(bytes, static_cast<std::uint32_t>(tree.size()));
  Append(bytes, Checksum(tree));
  return bytes + compressed;
}

std::string UnpackVocabulary(std::string_view content, const std::string& name) {
  RequireInput(!content.empty(), "{}: is empty", name);
  RequireInput(content.starts_with(kMagic.substr(0, content.size())),
               "{}: is no vocabulary of Drydock: it does not begin with \"{}\"", name, kMagic);
  RequireInput(content.size() >= kHeaderBytes, "{}: is cut short: {} bytes, not even a header",
               name, content.size());
  ByteReader reader(content.substr(kMagic.size(), kHeaderBytes - kMagic.size()));
  const auto version = reader.Take<std::uint32_t>();
  RequireInput(version == kVersion, "{}: is of version {}; this program reads version {}", name,
               version, kVersion);
  const auto packed_size = reader.Take<std::uint32_t>(), size = reader.Take<std::uint32_t>(),
             checksum = reader.Take<std::uint32_t>();
  const std::string_view packed = content.substr(kHeaderBytes);
  RequireInput(packed.size() >= packed_size, "{}: is cut short: {} of {} bytes are there", name,
               content.size(), kHeaderBytes + packed_size);
  RequireInput(packed.size() == packed_size, "{}: {} bytes follow its end", name,
               packed.size() - packed_size);
  // Deflate makes nothing more than 1032 times smaller.
  RequireInput(size <= kMaxVocabularyFileBytes && size <= 1032 * packed.size(),
               "{}: is damaged: {} bytes cannot unpack to {}", name, packed.size(), size);
  std::string bytes(size, '\0');
  uLongf unpacked = size;
  uLong read = packed.size();
  const int result = uncompress2(reinterpret_cast<Bytef*>(bytes.data()), &unpacked,
                                 reinterpret_cast<const Bytef*>(packed.data()), &read);
  RequireInput(result == Z_OK && unpacked == size && read == packed.size(),
               "{}: is damaged: it cannot be unpacked", name);
  RequireInput(Checksum(bytes) == checksum, "{}: is damaged: its checksum is wrong", name);
  return bytes;
}

std::string FormatVocabulary(const VocabularyTree& tree) {
  return PackVocabulary(FormatTree(tree));
}

VocabularyTree ParseVocabulary(std::string_view content, const std::string& name) {
  const std::string bytes = UnpackVocabulary(content, name);
  try {
    return ParseTree(bytes);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", name, error.what()));
  }
}

}  // namespace drydock::svin2
