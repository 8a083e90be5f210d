#pragma once

#include <filesystem>
#include <string>

#include "app/assembly/mesh_parser.h"
#include "app/base/reporter.h"
#include "app/scene/shape.h"
#include "hydro/mesh/mesh.h"

/// @file
/// Reads mesh files.

namespace assembly {

/// Reads the triangles of a mesh file, in a process of its own (mesh_reader_process.h). All parts
/// become one mesh in the file's own axes and unit, and coinciding vertices are welded.
///
/// The file's node transformations place the parts. Polygons are cut into triangles; points, lines
/// and unused vertices are dropped. The extension selects the format. The coordinates of OBJ, PLY,
/// OFF and STL files are kept as the file has them; assimp, which reads the other formats, rounds
/// them to floats, with a relative precision of 6e-8.
///
/// Vertices are welded if they differ along every axis by at most 1.2e-7 of the largest coordinate,
/// one step of a float there; if the coordinates are not rounded to floats, of the size of the mesh
/// where that is less. Formats that list the corners of each triangle repeat them bit for bit, and
/// only seams that were computed twice (cos 0 and cos 2π) need a tolerance. Triangles that lose a
/// corner have no area and are dropped.
/// @param formats   Formats besides the common ones are read on request only.
/// @throws InputError if the file cannot be read, has no triangle or a vertex that is not finite.
MeshFile read_welded(const std::filesystem::path& file, scene::MeshFormats formats);

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
