#include "app/assembly/build_shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "app/assembly/height_io.h"
#include "app/assembly/memory_need.h"
#include "app/assembly/mesh_mending.h"
#include "app/base/machine.h"
#include "hydro/mesh/mesh_union.h"
#include "hydro/mesh/primitives.h"

namespace assembly {
namespace {

template <class... Ts>
struct Overloaded : Ts... {
  using Ts::operator()...;
};

hydro::TriMesh primitive(const scene::Shape& shape) {
  return std::visit(
      Overloaded{
          [](const scene::Mesh&) { return hydro::TriMesh{}; },
          [](const scene::Shapes&) { return hydro::TriMesh{}; },
          [](const scene::Box& s) { return hydro::make_box(s.size, s.divisions); },
          [](const scene::Sphere& s) { return hydro::make_sphere(s.radius, s.slices, s.stacks); },
          [](const scene::Icosphere& s) { return hydro::make_icosphere(s.radius, s.subdivisions); },
          [](const scene::Ellipsoid& s) {
            return hydro::make_ellipsoid(s.semi_axes, s.slices, s.stacks);
          },
          [](const scene::Cylinder& s) {
            return hydro::make_cylinder(s.radius, s.height, s.slices, s.stacks);
          }},
      shape);
}

/// Returns the faults of a report that matter for the requirement.
hydro::MeshReport relevant(hydro::MeshReport report, Soundness needed) {
  if (needed == Soundness::closed) return report;
  hydro::MeshReport kept;
  kept.not_finite = report.not_finite;
  kept.degenerate_faces = report.degenerate_faces;
  return kept;
}

/// Refuses shapes that overlap: their union would take a cut through both. @return true if none do
bool lie_apart(const std::vector<hydro::TriMesh>& parts, const std::string& key, BuildLog& log) {
  bool apart = true;
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const auto common = hydro::common_part(parts[j], parts[i]);
      if (!common) continue;
      apart = false;
      const Eigen::Vector3d at = common->box.center();
      log.faults.add(
          log.scene.places, fmt::format("{}[{}]", key, i),
          fmt::format("overlaps {}[{}] by {:.4g} m along {}, about ({:.4g}, {:.4g}, "
                      "{:.4g}); move one of them by that much, so that they touch, or "
                      "join them in a program that draws solids",
                      key, j, common->depth(), "xyz"[common->axis()], at.x(), at.y(), at.z()));
    }
  return apart;
}

/// Returns the union of shapes in the body's mesh frame; a fault acts as in `shape_mesh`.
/// @param key   Path of the list.
hydro::TriMesh union_mesh(const scene::Shapes& shapes, const std::string& key, BuildLog& log) {
  std::vector<hydro::TriMesh> parts;
  for (std::size_t i = 0; i < shapes.parts.size(); ++i) {
    const scene::PlacedShape& placed = shapes.parts[i];
    const std::string path = fmt::format("{}[{}]", key, i);
    const scene::Shape shape = scene::as_shape(placed.shape);
    hydro::TriMesh mesh = shape_mesh(shape, path, log);
    if (!make_sound(mesh, Soundness::closed, shape, shape_key_path(shape, path), log)) continue;
    parts.push_back(hydro::transformed(std::move(mesh),
                                       Eigen::Translation3d(placed.position) * placed.orientation));
  }
  if (parts.size() < shapes.parts.size() || !lie_apart(parts, key, log)) return {};
  hydro::TriMesh whole = hydro::joined(parts);
  const std::vector<std::string> wrong = hydro::describe(hydro::check_mesh(whole));
  if (wrong.empty()) return whole;
  log.faults.add(log.scene.places, key,
                 fmt::format("touch in a way that gives no solid: {}; move one by a thousandth of "
                             "the size, so that there is a gap, or join them in a program that "
                             "draws solids",
                             wrong.front()));
  return {};
}

/// Mends a mesh as the scene asks; what cannot be done is a fault.
void mend(const scene::Mesh& file, const std::string& key, hydro::TriMesh& mesh, MeshSource& source,
          BuildLog& log) {
  auto known = std::ranges::find(log.mended, file, &decltype(log.mended)::value_type::first);
  if (known == log.mended.end()) {
    log.mended.emplace_back(file, hydro::mended(mesh, mend_options(file.mending)));
    known = std::prev(log.mended.end());
    for (const std::string& failure : known->second.failures)
      log.faults.add(log.scene.places, key, failure);
  }
  source.mended = mending_record(mesh, known->second);
  mesh = known->second.mesh;
}

/// Tells what makes a solid of a mesh; found once for all bodies that have it.
const std::string& remedy(const scene::Mesh& file, const hydro::TriMesh& mesh, BuildLog& log) {
  auto known = std::ranges::find(log.remedies, file, &decltype(log.remedies)::value_type::first);
  if (known == log.remedies.end()) {
    log.remedies.emplace_back(file, remedy_text(mesh, file.file, RemedyWords::keys));
    known = std::prev(log.remedies.end());
  }
  return known->second;
}

}  // namespace

bool has_memory(double triangles, const std::string& key_path, BuildLog& log) {
  // To ask the system takes longer than to build a small body, and there may be thousands of them.
  constexpr double kSmallBody = 64e6;  // [bytes]
  if (body_bytes(triangles) < kSmallBody) return true;
  const auto verdict = app::judged_need(body_bytes(triangles), app::available_memory());
  if (!verdict) return true;
  const std::string text = fmt::format("{}: {:.3g} triangles", verdict->text, triangles);
  if (verdict->fault)
    log.faults.add(log.scene.places, key_path, text);
  else
    log.warnings.push_back(fmt::format("{}: {}", key_path, text));
  return !verdict->fault;
}

std::string shape_key_path(const scene::Shape& shape, const std::string& key_path) {
  constexpr const char* kNames[] = {"mesh",      "box",      "sphere", "icosphere",
                                    "ellipsoid", "cylinder", "shapes"};
  return fmt::format("{}.{}", key_path, kNames[shape.index()]);
}

std::pair<hydro::TriMesh, MeshSource> mesh_from_file(const scene::Mesh& mesh,
                                                     const std::string& key_path, BuildLog& log) {
  MeshSource source{.file = mesh.file, .frame = {}};
  try {
    auto found = log.read.find(mesh.file);
    if (found == log.read.end()) {
      found = log.read.emplace(mesh.file, read_welded(mesh.file, log.scene.mesh_formats)).first;
      if (const std::string note = note_of_dropped(found->second); !note.empty())
        log.notes.push_back(fmt::format("{}: {}", key_path, note));
    }
    const MeshFile& read = found->second;
    source.frame = applied_frame(read.frame, mesh);
    if (!has_memory(static_cast<double>(read.mesh.face_count()), key_path + ".file", log))
      return {{}, source};
    return {in_mesh_frame(read.mesh, source.frame), source};
  } catch (const scene::InputError& error) {
    for (const scene::Fault& fault : error.faults())
      log.faults.add(log.scene.places, key_path + ".file",
                     to_string(scene::Fault{fault.place, "", fault.message}));
  }
  return {{}, source};
}

hydro::TriMesh shape_mesh(const scene::Shape& shape, const std::string& key_path, BuildLog& log) {
  const std::string key = shape_key_path(shape, key_path);
  if (const auto* file = std::get_if<scene::Mesh>(&shape)) {
    auto [mesh, source] = mesh_from_file(*file, key, log);
    if (mesh.face_count() == 0) return {};
    if (asks_for_mending(file->mending)) mend(*file, key, mesh, source, log);
    warn(source.file, key, size_warning(mesh, source, "unit: "), log);
    log.sources.push_back(std::move(source));
    return mesh;
  }
  if (const auto* shapes = std::get_if<scene::Shapes>(&shape)) return union_mesh(*shapes, key, log);
  if (!has_memory(triangles_of(shape), key, log)) return {};
  try {
    return primitive(shape);
  } catch (const std::invalid_argument& error) {
    log.faults.add(log.scene.places, key, error.what());
    return {};
  }
}

void warn(const std::filesystem::path& file, const std::string& key_path, const std::string& text,
          BuildLog& log) {
  if (!text.empty() && log.warned_files.insert(file).second)
    log.warnings.push_back(fmt::format("{}: {}", key_path, text));
}

bool make_sound(hydro::TriMesh& mesh, Soundness needed, const scene::Shape& shape,
                const std::string& key_path, BuildLog& log) {
  if (mesh.face_count() == 0) return false;
  hydro::RepairedMesh repaired = hydro::repaired(std::move(mesh));
  mesh = std::move(repaired.mesh);
  for (const std::string& note : repaired.notes)
    log.notes.push_back(fmt::format("{}: {}", key_path, note));
  std::vector<std::string> faults = hydro::describe(relevant(repaired.report, needed));
  const auto* file = std::get_if<scene::Mesh>(&shape);
  if (file && needed == Soundness::closed && !faults.empty())
    faults.back() += "; " + remedy(*file, mesh, log);
  for (const std::string& fault : faults) log.faults.add(log.scene.places, key_path, fault);
  return faults.empty();
}

hydro::HeightField height_field(const scene::HeightField& field, const std::string& key_path,
                                BuildLog& log) {
  try {
    return hydro::make_height_field(read_heights(field.file, field.range), field.cell,
                                    field.origin);
  } catch (const scene::InputError& error) {
    for (const scene::Fault& fault : error.faults())
      log.faults.add(log.scene.places, key_path + ".file",
                     to_string(scene::Fault{fault.place, "", fault.message}));
  } catch (const std::invalid_argument& error) {
    log.faults.add(log.scene.places, key_path, error.what());
  }
  return hydro::make_height_field(Eigen::MatrixXd::Zero(2, 2), 1, field.origin);
}

}  // namespace assembly
