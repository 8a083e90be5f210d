#pragma once

#include <filesystem>
#include <string>

#include "app/assembly/mesh_reader_process.h"
#include "app/base/reporter.h"
#include "app/scene/shape.h"
#include "hydro/mesh/mesh.h"

/// @file
/// Reads mesh files.

namespace assembly {

/// Tells how many faces were dropped; empty if none was.
std::string note_of_dropped(const MeshFile& read);

/// Reads a mesh file as read_welded and brings it into its mesh frame (mesh_frame.h).
/// @param frame   The author's word on axes and unit.
hydro::TriMesh read_mesh(const std::filesystem::path& file,
                         scene::MeshFormats formats = scene::MeshFormats::common,
                         const scene::MeshFrame& frame = {});

/// Reads a mesh that must be a solid; one that is inward as a whole is reversed.
/// @param reporter   Receives a note on each change, on axes and a unit other than z and m, and a
///     warning of a size that speaks for another unit.
/// @throws InputError as read_mesh, and with every fault that keeps the mesh from being a solid
hydro::TriMesh read_solid(const std::filesystem::path& file, app::Reporter& reporter,
                          scene::MeshFormats formats = scene::MeshFormats::common,
                          const scene::MeshFrame& frame = {});

/// Refuses `--up`, `--unit` and `--scale`, given beside a scene, whose meshes have keys for them.
/// @throws InputError
void refuse_frame(const scene::MeshFrame& frame);

}  // namespace assembly
