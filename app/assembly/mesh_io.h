#pragma once

#include <filesystem>

#include "app/base/reporter.h"
#include "hydro/mesh/mesh.h"

namespace assembly {

/// Reads the triangles of a mesh file in any format that assimp reads, all its parts as one mesh,
/// in the file's own frame and units, vertices that coincide welded into one.
///
/// Parts are placed by the file's own node transformations; polygons are cut into triangles; points
/// and lines are left out; so are vertices that no triangle uses. The format follows from the
/// extension. A Collada file names its unit and comes in metres; no axis is turned. Coordinates
/// have the precision of a float, 6e-8 of their size, whatever the file says: assimp holds no more.
/// Vertices are therefore welded if they differ by at most 1.2e-7 of the largest coordinate along
/// every axis, one step of a float there: formats that list the corners of each triangle repeat
/// them bit by bit, and only seams that were computed twice (cos 0 and cos 2π) need more. Triangles
/// that lose a corner by this are dropped.
/// @throws InputError if the file cannot be read, has no triangle or a vertex that is not finite.
hydro::TriMesh read_mesh(const std::filesystem::path& file);

/// Reads a mesh that must be a solid; one that is inward as a whole is turned outward.
/// @param reporter   Is told what was changed.
/// @throws InputError as read_mesh, and with everything that keeps the mesh from being a solid
hydro::TriMesh read_solid(const std::filesystem::path& file, app::Reporter& reporter);

}  // namespace assembly
