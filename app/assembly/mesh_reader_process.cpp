#include "app/assembly/mesh_reader_process.h"

#include <algorithm>
#include <cstring>
#include <span>
#include <string>
#include <string_view>

#include "app/base/byte_records.h"
#include "app/scene/diagnostics.h"
#include "app/scene/isolated_reader.h"
#include "hydro/mesh/weld.h"

namespace assembly {
namespace {

namespace fs = std::filesystem;

constexpr char kNotStated = -1;

/// Distance within which vertices are one [m]: one step of a float, 2^-23, at the largest
/// coordinate, or at the size of a mesh that is farther away and not rounded to floats.
double weld_distance(const MeshFile& read) {
  const hydro::TriMesh& mesh = read.mesh;
  const double farthest = mesh.vertices.cwiseAbs().maxCoeff();
  const double size = hydro::bounding_box(mesh).sizes().maxCoeff();
  return 0x1p-23 * (read.rounding == Rounding::of_floats ? farthest : std::min(farthest, size));
}

/// Reads a file and welds its mesh. The process that reads does it, for the corners of each
/// triangle are several times what is left of them.
MeshFile parse_welded(const fs::path& file, scene::MeshFormats formats) {
  MeshFile read = parse_mesh(file, formats);
  if (read.mesh.face_count() == 0) throw scene::InputError(file, "the file holds no triangles");
  const Eigen::Index faces = read.mesh.face_count();
  read.mesh = welded(read.mesh, weld_distance(read));
  read.dropped = faces - read.mesh.face_count();
  if (read.mesh.face_count() == 0)
    throw scene::InputError(file, "all triangles of the file are degenerate");
  return read;
}

void write(const app::CallOutput& output, const MeshFile& read) {
  const hydro::TriMesh& mesh = read.mesh;
  const char up = read.frame.up ? static_cast<char>(*read.frame.up) : kNotStated;
  const double unit = read.frame.unit.value_or(0);  // 0: not stated.
  app::put_record(output, std::span(&up, 1));
  app::put_record(output, std::span(&read.rounding, 1));
  app::put_record(output, std::span(&unit, 1));
  app::put_record(output, std::span(&read.dropped, 1));
  app::put_record(output,
                  std::span(mesh.vertices.data(), mesh.vertices.data() + mesh.vertices.size()));
  app::put_record(output, std::span(mesh.faces.data(), mesh.faces.data() + mesh.faces.size()));
}

/// Fills three rows with the next record.
template <class T>
void take(app::ByteRecords& records, Eigen::Matrix<T, 3, Eigen::Dynamic>& columns) {
  const std::string_view bytes = records.bytes();
  columns.resize(3, static_cast<Eigen::Index>(bytes.size() / (3 * sizeof(T))));
  if (!bytes.empty()) std::memcpy(columns.data(), bytes.data(), bytes.size());
}

/// Reverses `write`.
MeshFile mesh_in(const std::string& bytes) {
  app::ByteRecords records(bytes);
  MeshFile read;
  if (const char up = records.bytes().at(0); up != kNotStated)
    read.frame.up = static_cast<scene::UpAxis>(up);
  read.rounding = records.values<Rounding>().at(0);
  if (const double unit = records.values<double>().at(0); unit > 0) read.frame.unit = unit;
  read.dropped = records.values<Eigen::Index>().at(0);
  take(records, read.mesh.vertices);
  take(records, read.mesh.faces);
  return read;
}

}  // namespace

MeshFile read_welded(const fs::path& file, scene::MeshFormats formats) {
  return mesh_in(scene::read_isolated(
      file, "the reader of " + file.extension().string(),
      [&](const app::CallOutput& output) { write(output, parse_welded(file, formats)); },
      mesh_limits(file)));
}

app::CallLimits mesh_limits(const fs::path& file) {
  constexpr int kSeconds = 2;
  constexpr double kBytesPerSecond = 4e6;
  return scene::limits_by_size(file, kSeconds, kBytesPerSecond);
}

}  // namespace assembly
