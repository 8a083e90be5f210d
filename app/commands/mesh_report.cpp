#include "app/commands/mesh_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/base/console.h"
#include "app/base/table.h"

namespace app {
namespace {

/// Most rows of a table; the largest parts and the longest loops have them.
constexpr std::size_t kMostRows = 10;

std::string number(double value) { return fmt::format("{:.4g}", value); }

std::string place(const Eigen::Vector3d& p) {
  // Round-off about 0 would read as a place.
  const auto coordinate = [](double x) { return std::abs(x) < 1e-9 ? 0 : x; };
  return fmt::format("({:.4g}, {:.4g}, {:.4g})", coordinate(p.x()), coordinate(p.y()),
                     coordinate(p.z()));
}

std::string size_text(const Eigen::AlignedBox3d& box) {
  const Eigen::Vector3d size = box.sizes();
  return fmt::format("{:.4g} x {:.4g} x {:.4g}", size.x(), size.y(), size.z());
}

std::string shape_text(const hydro::OpenLoop& loop) {
  if (loop.shape == hydro::LoopShape::line) return "a crack";
  if (loop.shape == hydro::LoopShape::bent)
    return fmt::format("not flat, by {:.3g} m", loop.off_plane);
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(loop.normal[axis]) > 1 - 1e-6)
      return fmt::format("flat, {} = {:.4g}", "xyz"[axis],
                         std::abs(loop.middle[axis]) < 1e-9 ? 0 : loop.middle[axis]);
  return "flat";
}

/// Returns the first numbers in the order of a size, the largest first.
template <class Size>
std::vector<std::size_t> largest(std::size_t count, Size size) {
  std::vector<std::size_t> order(count);
  for (std::size_t i = 0; i < count; ++i) order[i] = i;
  std::ranges::stable_sort(order, std::ranges::greater(), size);
  order.resize(std::min(count, kMostRows));
  return order;
}

void add_table(std::vector<std::string>& lines, const std::vector<Cells>& table, std::size_t count,
               const char* what) {
  if (table.size() < 2) return;
  for (std::string& line : aligned_lines(table)) lines.push_back(std::move(line));
  if (count + 1 > table.size())
    lines.push_back(fmt::format("  and {} more {}", count + 1 - table.size(), what));
}

std::vector<Cells> part_table(const std::vector<hydro::DiagnosedPart>& parts) {
  std::vector<Cells> table = {
      {"part", "triangles", "size m", "area m^2", "surface", "open loops", "volume m^3"}};
  const auto faces = [&](std::size_t i) { return parts[i].faces; };
  for (const std::size_t i : largest(parts.size(), faces)) {
    const hydro::DiagnosedPart& part = parts[i];
    const char* surface = part.closed ? "closed" : part.open_loops > 0 ? "open" : "faulty";
    table.push_back({std::to_string(i + 1), std::to_string(part.faces), size_text(part.box),
                     number(part.area), surface, std::to_string(part.open_loops),
                     part.closed ? number(part.volume) : "-"});
  }
  return table;
}

std::vector<Cells> loop_table(const hydro::MeshDiagnosis& diagnosis) {
  std::vector<Cells> table = {{"open loop", "part", "edges", "length m", "shape", "middle m"}};
  const auto length = [&](std::size_t i) { return diagnosis.loops[i].length; };
  for (const std::size_t i : largest(diagnosis.loops.size(), length)) {
    const hydro::OpenLoop& loop = diagnosis.loops[i];
    table.push_back({std::to_string(i + 1), std::to_string(diagnosis.part_of_loop[i] + 1),
                     std::to_string(loop.vertices.size()), number(loop.length), shape_text(loop),
                     place(loop.middle)});
  }
  return table;
}

}  // namespace

std::string volume_text(const std::optional<double>& volume) {
  return volume ? fmt::format("{:.5g} m^3", *volume) : "open";
}

std::vector<std::string> diagnosis_lines(const hydro::TriMesh& mesh,
                                         const hydro::MeshDiagnosis& diagnosis) {
  std::vector<std::string> lines = {
      fmt::format("  {}, {}; {} m; {} m^2",
                  counted(static_cast<std::size_t>(mesh.face_count()), "triangle", "triangles"),
                  counted(static_cast<std::size_t>(mesh.vertex_count()), "vertex", "vertices"),
                  size_text(hydro::bounding_box(mesh)), number(diagnosis.area))};
  add_table(lines, part_table(diagnosis.parts), diagnosis.parts.size(), "parts");
  add_table(lines, loop_table(diagnosis), diagnosis.loops.size(), "open loops");
  for (const std::string& fault : hydro::describe(diagnosis.report)) lines.push_back("  " + fault);
  if (diagnosis.t_junctions > 0)
    lines.push_back(fmt::format(
        "  {} on the open side of a face (T-junctions)",
        counted(static_cast<std::size_t>(diagnosis.t_junctions), "vertex lies", "vertices lie")));
  for (const hydro::DiagnosedOverlap& overlap : diagnosis.overlaps)
    lines.push_back(fmt::format(
        "  parts {} and {} overlap{}", overlap.first + 1, overlap.second + 1,
        overlap.volume ? fmt::format(": they share {:.4g} m^3", *overlap.volume) : std::string()));
  return lines;
}

}  // namespace app
