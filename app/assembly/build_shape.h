#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/assembly/mesh_io.h"
#include "app/scene/diagnostics.h"
#include "app/scene/scene.h"
#include "hydro/mesh/mending/mend.h"
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
  std::map<std::filesystem::path, MeshFile> read = {};
  /// The meshes that were mended, by what the scene says of them, with what was done.
  std::vector<std::pair<scene::Mesh, hydro::MendedMesh>> mended = {};
  /// Texts of what makes a solid of the meshes that are none.
  std::vector<std::pair<scene::Mesh, std::string>> remedies = {};
  /// The mesh files of the present body.
  std::vector<MeshSource> sources = {};
  /// The mesh files of which a warning has told.
  std::set<std::filesystem::path> warned_files = {};
};

/// Returns the mesh of a shape in the mesh frame [m], not yet checked. After a fault, which goes to
/// the log, it has no vertices.
/// @param key_path   Path of the block that holds the shape: `bodies[1]`.
hydro::TriMesh shape_mesh(const scene::Shape& shape, const std::string& key_path, BuildLog& log);

/// Adds a warning, or a fault, if a body of so many triangles takes more memory than is free.
/// Memory for earlier bodies no longer counts as free. @return false after a fault
bool has_memory(double triangles, const std::string& key_path, BuildLog& log);

/// Returns the path of a body's shape: `bodies[1].mesh`.
std::string shape_key_path(const scene::Shape& shape, const std::string& key_path);

/// Reads a mesh file and brings it into its mesh frame, not mended; a fault acts as in
/// `shape_mesh`.
/// @param key_path   Path of the block with the key `file`.
/// @return the mesh and its file
std::pair<hydro::TriMesh, MeshSource> mesh_from_file(const scene::Mesh& mesh,
                                                     const std::string& key_path, BuildLog& log);

/// Adds a warning that `text` tells of the meshes of this file, unless there is one already or the
/// text is empty.
void warn(const std::filesystem::path& file, const std::string& key_path, const std::string& text,
          BuildLog& log);

/// Requirements on a mesh.
enum class Soundness {
  closed,  ///< A solid: closed, oriented, without repeated faces.
  surface  ///< Only finite and not degenerate.
};

/// Reverses a mesh that is inward as a whole, with a note, and reports all other faults; to those
/// of a mesh file it adds the keys that make a solid of it. Returns true if the mesh is usable.
/// @param shape      The shape that has the mesh.
/// @param key_path   Its path, as shape_key_path gives it.
bool make_sound(hydro::TriMesh& mesh, Soundness needed, const scene::Shape& shape,
                const std::string& key_path, BuildLog& log);

/// Returns a height field of the scene [m above `level`]; after a fault, a flat one of one cell.
hydro::HeightField height_field(const scene::HeightField& field, const std::string& key_path,
                                BuildLog& log);

}  // namespace assembly
