#include "app/assembly/msh_reader.h"

#include <fmt/format.h>

#include <cstdint>
#include <map>
#include <vector>

#include "app/assembly/mesh_text.h"
#include "app/assembly/polygon_mesh.h"

namespace assembly {
namespace {

namespace fs = std::filesystem;

/// Numbers of the kinds of elements that are read.
constexpr std::int64_t kTriangle = 2, kQuadrangle = 3;

class MshReader {
 public:
  MshReader(const fs::path& file, std::string_view bytes)
      : text_(file, bytes), mesh_(file, PlaceKind::line, 1) {}

  hydro::TriMesh triangles() {
    while (text_.next_line()) {
      const std::string_view section = text_.word();
      if (section == "$MeshFormat") read_format();
      if (section == "$Nodes") is_new_ ? read_node_blocks() : read_nodes();
      if (section == "$Elements") is_new_ ? read_element_blocks() : read_elements();
    }
    if (!formatted_) text_.fault("the file has no $MeshFormat");
    return mesh_.triangles();
  }

 private:
  void line(const char* what) {
    if (!text_.next_line())
      text_.fault(fmt::format("the file is cut short: it ends where {} are expected", what));
  }

  void read_format() {
    line("a version");
    const std::string_view version = text_.word();
    if (version != "2.2" && version != "4.1")
      text_.fault(fmt::format("the version is {}, expected 2.2 or 4.1", in_quotes(version)));
    is_new_ = version == "4.1";
    if (text_.integer() != 0) text_.fault("a binary file is not read, expected one of text");
    formatted_ = true;
  }

  void add_node(std::int64_t tag, const Eigen::Vector3d& vertex) {
    mesh_.add_vertex(vertex, static_cast<std::uint64_t>(text_.line()));
    number_of_tag_[tag] = mesh_.vertex_count();
  }

  /// Adds the polygon whose corners follow on the line, if it is of a kind that is read.
  void add_element(std::int64_t kind) {
    if (kind != kTriangle && kind != kQuadrangle) return;
    std::vector<std::int64_t> corners;
    for (int i = 0; i < (kind == kTriangle ? 3 : 4); ++i) {
      const std::int64_t tag = text_.integer();
      const auto found = number_of_tag_.find(tag);
      if (found == number_of_tag_.end())
        text_.fault(fmt::format("an element names node {}, which the file does not have", tag));
      corners.push_back(found->second);
    }
    mesh_.add_polygon(corners, static_cast<std::uint64_t>(text_.line()));
  }

  void read_nodes() {
    line("nodes");
    for (std::int64_t left = text_.integer(); left > 0; --left) {
      line("nodes");
      const std::int64_t tag = text_.integer();
      add_node(tag, text_.vector());
    }
  }

  void read_elements() {
    line("elements");
    for (std::int64_t left = text_.integer(); left > 0; --left) {
      line("elements");
      text_.integer();
      const std::int64_t kind = text_.integer();
      for (std::int64_t tags = text_.integer(); tags > 0; --tags) text_.integer();
      add_element(kind);
    }
  }

  void read_node_blocks() {
    line("nodes");
    for (std::int64_t blocks = text_.integer(); blocks > 0; --blocks) {
      line("nodes");
      for (int i = 0; i < 3; ++i) text_.integer();
      std::vector<std::int64_t> tags;
      for (std::int64_t left = text_.integer(); left > 0; --left) {
        line("nodes");
        tags.push_back(text_.integer());
        if (left == 1) read_coordinates(tags);
      }
    }
  }

  void read_coordinates(const std::vector<std::int64_t>& tags) {
    for (const std::int64_t tag : tags) {
      line("nodes");
      add_node(tag, text_.vector());
    }
  }

  void read_element_blocks() {
    line("elements");
    for (std::int64_t blocks = text_.integer(); blocks > 0; --blocks) {
      line("elements");
      for (int i = 0; i < 2; ++i) text_.integer();
      const std::int64_t kind = text_.integer();
      for (std::int64_t left = text_.integer(); left > 0; --left) {
        line("elements");
        text_.integer();
        add_element(kind);
      }
    }
  }

  MeshText text_;
  PolygonMesh mesh_;
  std::map<std::int64_t, std::int64_t> number_of_tag_;
  bool is_new_ = false, formatted_ = false;
};

}  // namespace

MeshFile read_msh(const fs::path& file, std::string_view bytes) {
  return {
      .mesh = MshReader(file, bytes).triangles(), .frame = {}, .rounding = Rounding::as_written};
}

}  // namespace assembly
