#include "app/assembly/obj_reader.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <vector>

#include "app/assembly/mesh_text.h"
#include "app/assembly/polygon_mesh.h"

namespace assembly {
namespace {

namespace fs = std::filesystem;

Eigen::Vector3d vertex_of(MeshText& text) {
  const Eigen::Vector3d vertex = text.vector();
  if (!text.has_word()) return vertex;
  const double weight = text.number();
  if (text.has_word()) return vertex;  // A colour follows the three numbers.
  if (weight == 0) text.fault("the weight of a vertex is 0, expected another number");
  return vertex / weight;
}

/// Returns the number of the vertex that a corner of a face names: `7`, `7/1`, `7//3`, `-1/2/3`.
std::int64_t corner_of(std::string_view word, const MeshText& text, std::int64_t vertex_count) {
  const char* const end = word.data() + word.size();
  std::int64_t number = 0;
  const auto [stop, error] = std::from_chars(word.data(), end, number);
  if (error != std::errc{} || (stop != end && *stop != '/'))
    text.fault(fmt::format("found {}, expected the corner of a face, such as 7 or 7/1/3",
                           in_quotes(word)));
  if (number > 0) return number;
  if (number == 0 || number < -vertex_count)
    text.fault(
        fmt::format("a face names vertex {}, the file has {} vertices before it, counted "
                    "from 1 or back from -1",
                    number, vertex_count));
  return vertex_count + 1 + number;
}

}  // namespace

MeshFile read_obj(const fs::path& file, std::string_view bytes) {
  MeshText text(file, bytes, {.comment = '#', .continued = true});
  PolygonMesh mesh(file, PlaceKind::line, 1);
  std::vector<std::int64_t> corners;
  while (text.next_line()) {
    const auto line = static_cast<std::uint64_t>(text.line());
    const std::string_view keyword = text.word();
    if (keyword == "v") mesh.add_vertex(vertex_of(text), line);
    if (keyword != "f") continue;
    corners.clear();
    while (text.has_word()) corners.push_back(corner_of(text.word(), text, mesh.vertex_count()));
    mesh.add_polygon(corners, line);
  }
  return {.mesh = mesh.triangles(), .frame = {}, .rounding = Rounding::as_written};
}

}  // namespace assembly
