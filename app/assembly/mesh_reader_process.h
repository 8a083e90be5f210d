#pragma once

#include <filesystem>

#include "app/assembly/mesh_parser.h"
#include "app/base/forked_call.h"

namespace assembly {

/// Reads the triangles of a mesh file, as parse_mesh does, in a process of its own
/// (app/base/forked_call.h). All parts become one mesh in the file's own axes and unit, and
/// coinciding vertices are welded.
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
///
/// assimp 5.2 can be made to crash, to run on and to fill the memory by damaged files of most
/// formats. A crash of the process becomes a fault of the file. It may compute for 2 s and another
/// second per 4 MB of the file, and use 4 GiB and another 64 bytes per byte of the file, but no
/// more than the machine has free.
/// @param formats   Formats besides the common ones are read on request only.
/// @throws InputError if the file cannot be read, has no triangle or a vertex that is not finite,
///     ends the process or exceeds its limits
MeshFile read_welded(const std::filesystem::path& file, scene::MeshFormats formats);

/// The limits of a process that reads a mesh file.
app::CallLimits mesh_limits(const std::filesystem::path& file);

}  // namespace assembly
