#include "app/assembly/mesh_writer.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>

#include "app/assembly/mesh_text.h"
#include "app/base/atomic_file.h"

namespace assembly {
namespace {

std::string obj_text(const hydro::TriMesh& mesh) {
  std::string text;
  for (const auto& v : mesh.vertices.colwise())
    text += fmt::format("v {} {} {}\n", v.x(), v.y(), v.z());
  for (const auto& f : mesh.faces.colwise())
    text += fmt::format("f {} {} {}\n", f[0] + 1, f[1] + 1, f[2] + 1);
  return text;
}

template <class T>
void append(std::string& bytes, const T& value) {
  static_assert(std::endian::native == std::endian::little);
  std::array<char, sizeof value> stored;
  std::memcpy(stored.data(), &value, sizeof value);
  bytes.append(stored.data(), stored.size());
}

std::string stl_bytes(const hydro::TriMesh& mesh) {
  constexpr std::size_t kHead = 80;
  std::string bytes = "mesh in metres";
  bytes.resize(kHead, ' ');
  append(bytes, static_cast<std::uint32_t>(mesh.face_count()));
  for (Eigen::Index f = 0; f < mesh.face_count(); ++f) {
    for (const double n : hydro::area_vector(mesh, f).normalized())
      append(bytes, static_cast<float>(n));
    for (const int v : mesh.faces.col(f))
      for (const double x : mesh.vertices.col(v)) append(bytes, static_cast<float>(x));
    append(bytes, std::uint16_t{0});
  }
  return bytes;
}

}  // namespace

bool is_writable_mesh(const std::filesystem::path& file) {
  const std::string extension = lower(file.extension().string());
  return extension == ".obj" || extension == ".stl";
}

void write_mesh(const std::filesystem::path& file, const hydro::TriMesh& mesh) {
  const bool stl = lower(file.extension().string()) == ".stl";
  app::write_whole(std::filesystem::absolute(file), stl ? stl_bytes(mesh) : obj_text(mesh));
}

}  // namespace assembly
