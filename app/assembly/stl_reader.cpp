#include "app/assembly/stl_reader.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>

#include "app/assembly/byte_order.h"
#include "app/assembly/mesh_text.h"
#include "app/assembly/polygon_mesh.h"
#include "app/scene/diagnostics.h"

namespace assembly {
namespace {

namespace fs = std::filesystem;

/// Parts of a binary file [bytes].
constexpr std::size_t kHead = 80, kCount = 4, kFacet = 50, kNormal = 12;

std::size_t announced(std::string_view bytes) {
  return value_at<std::uint32_t>(bytes, kHead, std::endian::little);
}

bool is_binary(std::string_view bytes) {
  return bytes.size() >= kHead + kCount &&
         bytes.size() == kHead + kCount + kFacet * announced(bytes);
}

MeshFile read_binary(const fs::path& file, std::string_view bytes) {
  PolygonMesh mesh(file, PlaceKind::byte, 1);
  mesh.reserve_triangles(announced(bytes));
  for (std::size_t facet = kHead + kCount; facet < bytes.size(); facet += kFacet) {
    const std::int64_t first = mesh.vertex_count() + 1;
    for (std::size_t at = facet + kNormal; at < facet + 4 * kNormal; at += kNormal) {
      Eigen::Vector3d vertex;
      for (std::size_t axis = 0; axis < 3; ++axis)
        vertex[static_cast<Eigen::Index>(axis)] =
            value_at<float>(bytes, at + 4 * axis, std::endian::little);
      mesh.add_vertex(vertex, at);
    }
    mesh.add_polygon(std::array{first, first + 1, first + 2}, facet);
  }
  return {.mesh = mesh.triangles(), .frame = {}, .rounding = Rounding::of_floats};
}

/// Reads the words of a file of text, which may be spread over lines in any way but for the numbers
/// of a vertex, which follow on its line.
class Facets {
 public:
  Facets(const fs::path& file, std::string_view bytes)
      : text_(file, bytes), mesh_(file, PlaceKind::line, 1) {}

  hydro::TriMesh triangles() {
    for (std::string word = next(); word == "solid"; word = next()) {
      leave_line();  // The name follows.
      for (word = next(); word == "facet"; word = next()) facet();
      if (word != "endsolid") refuse(word, "facet or endsolid");
      leave_line();
    }
    if (!ended_) refuse(last_, "solid");
    return mesh_.triangles();
  }

 private:
  /// Takes the next word of the file; empty at its end.
  std::string next() {
    while (!ended_ && !text_.has_word()) ended_ = !text_.next_line();
    return last_ = ended_ ? "" : lower(text_.word());
  }
  void leave_line() {
    while (text_.has_word()) text_.word();
  }
  [[noreturn]] void refuse(const std::string& found, const char* expected) {
    if (ended_)
      text_.fault(fmt::format("the file is cut short: it ends where {} is expected", expected));
    text_.fault(fmt::format("found {}, expected {}", in_quotes(found), expected));
  }
  void expect(const char* word) {
    if (const std::string found = next(); found != word) refuse(found, word);
  }

  void facet() {
    expect("normal");
    for (int i = 0; i < 3; ++i) next();  // Some writers have words for what is not a number.
    expect("outer");
    expect("loop");
    const auto line = static_cast<std::uint64_t>(text_.line());
    const std::int64_t first = mesh_.vertex_count() + 1;
    for (int i = 0; i < 3; ++i) {
      expect("vertex");
      mesh_.add_vertex(text_.vector(), static_cast<std::uint64_t>(text_.line()));
    }
    mesh_.add_polygon(std::array{first, first + 1, first + 2}, line);
    expect("endloop");
    expect("endfacet");
  }

  MeshText text_;
  PolygonMesh mesh_;
  std::string last_;
  bool ended_ = false;
};

}  // namespace

MeshFile read_stl(const fs::path& file, std::string_view bytes) {
  if (is_binary(bytes)) return read_binary(file, bytes);
  MeshText text(file, bytes);
  if (text.next_line() && lower(text.word()) == "solid")
    return {.mesh = Facets(file, bytes).triangles(), .frame = {}, .rounding = Rounding::as_written};
  if (bytes.size() < kHead + kCount)
    throw scene::InputError(file,
                            "the file does not begin with 'solid' as text, and is too short for a "
                            "binary one");
  throw scene::InputError(
      file,
      fmt::format("the file does not begin with 'solid' as text; as a binary one with {} "
                  "triangles, which it announces, it has {} bytes, expected {}",
                  announced(bytes), bytes.size(), kHead + kCount + kFacet * announced(bytes)));
}

}  // namespace assembly
