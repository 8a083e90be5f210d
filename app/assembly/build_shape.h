#pragma once

#include <string>
#include <vector>

#include "app/scene/diagnostics.h"
#include "app/scene/scene.h"
#include "hydro/mesh/mesh_check.h"
#include "hydro/sea.h"

/// @file
/// From the shapes that a scene names to meshes.

namespace assembly {

/// Where faults and notes of one scene go while it is built.
struct BuildLog {
  const scene::Scene& scene;
  scene::Faults faults;
  std::vector<std::string> notes;
};

/// The mesh of a shape in the mesh frame [m], not yet checked. Without vertices if there was a
/// fault, which is then in the log.
/// @param key_path   Of the block that holds the shape: `bodies[1]`.
hydro::TriMesh shape_mesh(const scene::Shape& shape, const std::string& key_path, BuildLog& log);

/// The path of the key under which a body's shape stands: `bodies[1].mesh`.
std::string shape_key_path(const scene::Shape& shape, const std::string& key_path);

/// A mesh file, scaled; as `shape_mesh`. @param key_path   Of the block with the key `file`.
hydro::TriMesh mesh_from_file(const scene::Mesh& mesh, const std::string& key_path, BuildLog& log);

/// What a mesh must be for its use.
enum class Soundness {
  closed,  ///< A solid: closed, oriented, no faces twice.
  surface  ///< Only finite and not degenerate.
};

/// Turns a mesh outward if it is inward as a whole, and notes it; reports what else is wrong.
/// True if the mesh may be used.
bool make_sound(hydro::TriMesh& mesh, Soundness needed, const std::string& key_path, BuildLog& log);

/// A height field of the scene [m above `level`]; a flat one of one cell after a fault.
hydro::HeightField height_field(const scene::HeightField& field, const std::string& key_path,
                                BuildLog& log);

}  // namespace assembly
