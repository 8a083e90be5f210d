#include "app/assembly/panel_reader.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "app/assembly/mesh_text.h"
#include "app/assembly/polygon_mesh.h"

namespace assembly {
namespace {

namespace fs = std::filesystem;

/// Reads numbers one after the other, on as many lines as they take.
class Numbers {
 public:
  Numbers(const fs::path& file, std::string_view bytes) : text_(file, bytes) {}

  MeshText& text() { return text_; }
  double number(const char* what) {
    require(what);
    return text_.number();
  }
  std::int64_t integer(const char* what) {
    require(what);
    return text_.integer();
  }
  Eigen::Vector3d vector(const char* what) {
    const double x = number(what), y = number(what), z = number(what);
    return {x, y, z};
  }
  /// A count of things that take two bytes each at least.
  std::int64_t count(const char* what) {
    const std::int64_t count = integer(what);
    if (count < 0 || count > static_cast<std::int64_t>(text_.rest().size() + 1) / 2)
      text_.fault(fmt::format("the file has no room for {} {}", count, what));
    return count;
  }
  /// A flag of symmetry.
  bool flag(const char* what) {
    const std::int64_t value = integer(what);
    if (value != 0 && value != 1)
      text_.fault(fmt::format("{} is {}, expected 0 or 1", what, value));
    return value == 1;
  }
  void end_line() {
    while (text_.has_word()) text_.word();
  }
  /// True if the next word of the line is a number.
  bool is_number_next() const {
    MeshText words = text_;
    const std::string_view next = words.word();
    return !next.empty() && next.find_first_not_of("0123456789+-.eEdD") == std::string_view::npos;
  }
  /// Moves on to the next line that begins with a number.
  void skip_comments() {
    while (text_.next_line())
      if (is_number_next()) return;
  }

 private:
  void require(const char* what) {
    while (!text_.has_word())
      if (!text_.next_line())
        text_.fault(fmt::format("the file is cut short: it ends where {} are expected", what));
  }

  MeshText text_;
};

std::uint64_t line_of(Numbers& numbers) {
  return static_cast<std::uint64_t>(numbers.text().line());
}

/// Repeats a mesh in the planes of symmetry.
hydro::TriMesh whole(hydro::TriMesh mesh, bool about_x, bool about_y) {
  for (const auto& [axis, wanted] : {std::pair(0, about_x), std::pair(1, about_y)}) {
    if (!wanted || mesh.vertex_count() == 0) continue;
    const Eigen::Index vertices = mesh.vertex_count(), faces = mesh.face_count();
    mesh.vertices.conservativeResize(3, 2 * vertices);
    mesh.vertices.rightCols(vertices) = mesh.vertices.leftCols(vertices).eval();
    mesh.vertices.rightCols(vertices).row(axis) *= -1;
    mesh.faces.conservativeResize(3, 2 * faces);
    for (Eigen::Index f = 0; f < faces; ++f)
      mesh.faces.col(faces + f) =
          Eigen::Vector3i(mesh.faces(0, f), mesh.faces(2, f), mesh.faces(1, f)).array() +
          static_cast<int>(vertices);
  }
  return mesh;
}

MeshFile mesh_file(const PolygonMesh& mesh, bool about_x, bool about_y) {
  return {.mesh = whole(mesh.triangles(), about_x, about_y),
          .frame = {},
          .rounding = Rounding::of_floats};
}

}  // namespace

MeshFile read_gdf(const fs::path& file, std::string_view bytes) {
  constexpr double kGravityInFeet = 32.174, kNear = 0.5;
  Numbers numbers(file, bytes);
  numbers.text().next_line();
  numbers.end_line();
  numbers.number("ULEN and GRAV");
  const double gravity = numbers.number("ULEN and GRAV");
  numbers.end_line();  // Words of explanation may follow, here and below.
  const bool about_x = numbers.flag("ISX"), about_y = numbers.flag("ISY");
  numbers.end_line();
  const std::int64_t panels = numbers.count("panels");
  if (numbers.is_number_next() && numbers.integer("IGDEF") != 0)
    numbers.text().fault("a file of high order, with IGDEF, is not read: expected flat panels");
  numbers.end_line();
  PolygonMesh mesh(file, PlaceKind::line, 1);
  for (std::int64_t panel = 0; panel < panels; ++panel) {
    std::vector<std::int64_t> corners;
    for (int i = 0; i < 4; ++i) {
      const Eigen::Vector3d vertex = numbers.vector("vertices of panels");
      mesh.add_vertex(vertex, line_of(numbers));
      corners.push_back(mesh.vertex_count());
    }
    mesh.add_polygon(corners, line_of(numbers));
  }
  MeshFile read = mesh_file(mesh, about_x, about_y);
  read.frame.unit = std::abs(gravity - kGravityInFeet) < kNear ? 0.3048 : 1;
  return read;
}

MeshFile read_nemoh_mesh(const fs::path& file, std::string_view bytes) {
  Numbers numbers(file, bytes);
  if (numbers.integer("2 and the symmetry") != 2)
    numbers.text().fault("a mesh of Nemoh begins with 2 and a flag of symmetry");
  const bool about_y = numbers.flag("the symmetry");
  numbers.end_line();
  PolygonMesh mesh(file, PlaceKind::line, 1);
  for (std::int64_t expected = 1;; ++expected) {
    const std::int64_t number = numbers.integer("vertices and a 0");
    const Eigen::Vector3d vertex = numbers.vector("vertices and a 0");
    if (number == 0) break;
    if (number != expected)
      numbers.text().fault(fmt::format("found vertex {}, expected {}", number, expected));
    mesh.add_vertex(vertex, line_of(numbers));
  }
  for (;;) {
    std::vector<std::int64_t> corners;
    for (int i = 0; i < 4; ++i) corners.push_back(numbers.integer("panels and zeros"));
    if (corners[0] == 0) break;
    mesh.add_polygon(corners, line_of(numbers));
  }
  return mesh_file(mesh, false, about_y);
}

MeshFile read_pnl(const fs::path& file, std::string_view bytes) {
  Numbers numbers(file, bytes);
  numbers.skip_comments();
  const std::int64_t panels = numbers.count("panels"), vertices = numbers.count("vertices");
  const bool about_x = numbers.flag("the symmetry about x"),
             about_y = numbers.flag("the symmetry about y");
  PolygonMesh mesh(file, PlaceKind::line, 1);
  for (std::int64_t i = 0; i < vertices; ++i) {
    numbers.skip_comments();
    if (const std::int64_t number = numbers.integer("vertices"); number != i + 1)
      numbers.text().fault(fmt::format("found vertex {}, expected {}", number, i + 1));
    mesh.add_vertex(numbers.vector("vertices"), line_of(numbers));
  }
  for (std::int64_t i = 0; i < panels; ++i) {
    numbers.skip_comments();
    numbers.integer("panels");
    const std::int64_t count = numbers.integer("panels");
    if (count != 3 && count != 4)
      numbers.text().fault(fmt::format("a panel has {} vertices, expected 3 or 4", count));
    std::vector<std::int64_t> corners;
    for (std::int64_t k = 0; k < count; ++k) corners.push_back(numbers.integer("panels"));
    mesh.add_polygon(corners, line_of(numbers));
  }
  return mesh_file(mesh, about_x, about_y);
}

}  // namespace assembly
