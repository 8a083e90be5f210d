#include "app/assembly/mesh_reader_process.h"

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>

#include "app/scene/isolated_reader.h"

namespace assembly {
namespace {

namespace fs = std::filesystem;

/// The fixed part of what the process hands back; vertices and faces follow.
struct AnswerHead {
  char up = 0;      ///< 0: not stated.
  double unit = 0;  ///< 0: not stated.
  std::int64_t vertices = 0;
  std::int64_t faces = 0;
};

template <class T>
void write(const app::CallOutput& output, const T* values, std::size_t count) {
  output({reinterpret_cast<const char*>(values), count * sizeof(T)});
}

void write(const app::CallOutput& output, const MeshFile& read) {
  const AnswerHead head{.up = read.frame.up.value_or(0),
                        .unit = read.frame.unit.value_or(0),
                        .vertices = read.mesh.vertex_count(),
                        .faces = read.mesh.face_count()};
  write(output, &head, 1);
  write(output, read.mesh.vertices.data(), static_cast<std::size_t>(read.mesh.vertices.size()));
  write(output, read.mesh.faces.data(), static_cast<std::size_t>(read.mesh.faces.size()));
}

/// Reverses `write`.
MeshFile mesh_in(const std::string& bytes) {
  AnswerHead head;
  if (bytes.size() < sizeof head) throw std::logic_error("the reader of meshes gave no answer");
  std::memcpy(&head, bytes.data(), sizeof head);
  const char* const rest = bytes.data() + sizeof head;
  MeshFile read;
  read.mesh.vertices.resize(3, head.vertices);
  read.mesh.faces.resize(3, head.faces);
  const std::size_t vertices = static_cast<std::size_t>(3 * head.vertices) * sizeof(double);
  const std::size_t faces = static_cast<std::size_t>(3 * head.faces) * sizeof(int);
  if (bytes.size() != sizeof head + vertices + faces)
    throw std::logic_error("the answer of the reader of meshes is incomplete");
  if (vertices > 0) std::memcpy(read.mesh.vertices.data(), rest, vertices);
  if (faces > 0) std::memcpy(read.mesh.faces.data(), rest + vertices, faces);
  if (head.up != 0) read.frame.up = head.up;
  if (head.unit > 0) read.frame.unit = head.unit;
  return read;
}

}  // namespace

MeshFile read_mesh_file(const fs::path& file, scene::MeshFormats formats) {
  constexpr int kSeconds = 2;
  constexpr double kBytesPerSecond = 4e6;
  return mesh_in(scene::read_isolated(
      file, "the reader of " + file.extension().string(),
      [&](const app::CallOutput& output) { write(output, parse_mesh(file, formats)); },
      scene::limits_by_size(file, kSeconds, kBytesPerSecond)));
}

}  // namespace assembly
