#include "app/assembly/off_reader.h"

#include <fmt/format.h>

#include <cstdint>
#include <vector>

#include "app/assembly/mesh_text.h"
#include "app/assembly/polygon_mesh.h"

namespace assembly {
namespace {

namespace fs = std::filesystem;

/// The head of a file.
struct Head {
  bool weighted = false;
  std::int64_t vertices = 0, faces = 0;
};

/// Takes a count of lines. Each line has a byte at least besides its end.
std::int64_t count_of(MeshText& text, const char* what) {
  const std::int64_t count = text.integer();
  const auto most = static_cast<std::int64_t>(text.rest().size() + 1) / 2;
  if (count < 0)
    text.fault(fmt::format("the head announces {} {}, expected 0 or more", count, what));
  if (count > most)
    text.fault(
        fmt::format("the file is cut short: its head announces {} {}, but only {} bytes "
                    "follow",
                    count, what, text.rest().size()));
  return count;
}

Head head_of(MeshText& text) {
  Head head;
  if (!text.next_line()) text.fault("the file is cut short: it has no head");
  MeshText words = text;
  const std::string_view first = words.word();
  if (first.ends_with("OFF")) {
    std::string_view prefix = first.substr(0, first.size() - 3);
    for (const char* letters : {"ST", "C", "N", "4"})
      if (prefix.starts_with(letters)) {
        head.weighted = *letters == '4';
        prefix.remove_prefix(std::string_view(letters).size());
      }
    if (!prefix.empty())
      text.fault(
          fmt::format("found {}, expected OFF, or with prefixes ST, C, N and 4 in this order",
                      in_quotes(first)));
    if (words.word() == "BINARY") text.fault("a binary file of OFF is not read, expected text");
    text.word();
    if (!text.has_word() && !text.next_line())
      text.fault("the file is cut short: its head has no counts");
  }
  head.vertices = count_of(text, "vertices");
  head.faces = count_of(text, "faces");
  return head;
}

/// Moves on to the next of the lines that the head announces.
void expect_line(MeshText& text, const char* what, std::int64_t number, std::int64_t count) {
  if (!text.next_line())
    text.fault(
        fmt::format("the file is cut short: it ends before {} {} of {}", what, number, count));
}

Eigen::Vector3d vertex_of(MeshText& text, bool weighted) {
  const Eigen::Vector3d vertex = text.vector();
  if (!weighted) return vertex;
  const double weight = text.number();
  if (weight == 0) text.fault("the weight of a vertex is 0, expected another number");
  return vertex / weight;
}

}  // namespace

MeshFile read_off(const fs::path& file, std::string_view bytes) {
  MeshText text(file, bytes, {.comment = '#'});
  PolygonMesh mesh(file, PlaceKind::line, 0);
  const Head head = head_of(text);
  for (std::int64_t i = 0; i < head.vertices; ++i) {
    expect_line(text, "vertex", i + 1, head.vertices);
    mesh.add_vertex(vertex_of(text, head.weighted), static_cast<std::uint64_t>(text.line()));
  }
  std::vector<std::int64_t> corners;
  for (std::int64_t i = 0; i < head.faces; ++i) {
    expect_line(text, "face", i + 1, head.faces);
    corners.clear();
    for (std::int64_t n = text.integer(); n > 0; --n) corners.push_back(text.integer());
    mesh.add_polygon(corners, static_cast<std::uint64_t>(text.line()));
  }
  return {.mesh = mesh.triangles(), .frame = {}, .rounding = Rounding::as_written};
}

}  // namespace assembly
