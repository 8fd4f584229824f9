#include "scenes/mesh/msh_file.h"

#include <bit>
#include <cstdint>
#include <fstream>
#include <string>

#include "sensors_models/base/check.h"

namespace drydock::scenes {
namespace {

void Put(std::string& out, std::uint32_t word) {
  for (int byte = 0; byte < 4; ++byte) out.push_back(static_cast<char>(word >> (8 * byte)));
}

void Put(std::string& out, double value) {
  Put(out, std::bit_cast<std::uint32_t>(static_cast<float>(value)));
}

}  // namespace

void WriteMsh(const Mesh& mesh, const std::filesystem::path& path) {
  std::string out;
  out.reserve(16 + 32 * mesh.positions.size() + 12 * mesh.triangles.size());
  const auto vertices = static_cast<std::uint32_t>(mesh.positions.size());
  for (int i = 0; i < 3; ++i) Put(out, vertices);
  Put(out, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& p : mesh.positions) {
    for (int i = 0; i < 3; ++i) Put(out, p[i]);
  }
  for (const auto& n : mesh.normals) {
    for (int i = 0; i < 3; ++i) Put(out, n[i]);
  }
  for (const auto& uv : mesh.uvs) {
    for (int i = 0; i < 2; ++i) Put(out, uv[i]);
  }
  for (const auto& t : mesh.triangles) {
    for (const int index : t) Put(out, static_cast<std::uint32_t>(index));
  }
  std::ofstream stream(path, std::ios::binary);
  stream.write(out.data(), static_cast<std::streamsize>(out.size()));
  stream.close();
  RequireInput(static_cast<bool>(stream), "{}: cannot be written", path.string());
}

}  // namespace drydock::scenes
