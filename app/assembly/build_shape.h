#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/scene/diagnostics.h"
#include "app/scene/scene.h"
#include "hydro/mesh/mesh_check.h"
#include "hydro/sea.h"

/// @file
/// Makes meshes of the shapes that a scene names.

namespace assembly {

/// Collects the faults, notes and warnings of a scene while it is built.
struct BuildLog {
  const scene::Scene& scene;
  scene::Faults faults;
  std::vector<std::string> notes;
  std::vector<std::string> warnings = {};
  /// The meshes that were read, by file: several bodies may have the same.
  std::map<std::filesystem::path, hydro::TriMesh> read = {};
};

/// Returns the mesh of a shape in the mesh frame [m], not yet checked. After a fault, which goes to
/// the log, it has no vertices.
/// @param key_path   Path of the block that holds the shape: `bodies[1]`.
hydro::TriMesh shape_mesh(const scene::Shape& shape, const std::string& key_path, BuildLog& log);

/// Returns the path of a body's shape: `bodies[1].mesh`.
std::string shape_key_path(const scene::Shape& shape, const std::string& key_path);

/// Reads and scales a mesh file; a fault acts as in `shape_mesh`.
/// @param key_path   Path of the block with the key `file`.
hydro::TriMesh mesh_from_file(const scene::Mesh& mesh, const std::string& key_path, BuildLog& log);

/// Requirements on a mesh.
enum class Soundness {
  closed,  ///< A solid: closed, oriented, without repeated faces.
  surface  ///< Only finite and not degenerate.
};

/// Reverses a mesh that is inward as a whole, with a note, and reports all other faults. Returns
/// true if the mesh is usable.
bool make_sound(hydro::TriMesh& mesh, Soundness needed, const std::string& key_path, BuildLog& log);

/// Returns a height field of the scene [m above `level`]; after a fault, a flat one of one cell.
hydro::HeightField height_field(const scene::HeightField& field, const std::string& key_path,
                                BuildLog& log);

}  // namespace assembly
