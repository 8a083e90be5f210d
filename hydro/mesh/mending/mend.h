#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hydro/mesh/mesh.h"
#include "hydro/mesh/mesh_check.h"

/// @file
/// Makes a solid of a mesh that is not one, where there is one right answer.

namespace hydro {

/// Steps of mending that are not always taken.
struct MendOptions {
  std::optional<double> weld;       ///< Widest crack that is closed [m]; default_weld() if none.
  bool cap = false;                 ///< Fill flat open loops (cap.h).
  std::optional<int> mirror;        ///< Axis normal to the plane of symmetry (mirror.h).
  bool unite = false;               ///< Unite closed parts that overlap (solid_union.h).
  std::optional<double> thickness;  ///< Thickness of plates that open parts become (thicken.h) [m].
  bool operator==(const MendOptions&) const = default;
};

/// Width of the cracks that are closed by default: 1e-5 of the diagonal of the mesh's box [m]. It
/// is a hundred times the resolution of the floats in mesh files, and a millimetre on a ship.
double default_weld(const TriMesh& mesh);

/// A mesh after it was mended.
struct MendedMesh {
  TriMesh mesh;
  MeshReport report;                  ///< On the mended mesh; it may still have faults.
  std::vector<std::string> changes;   ///< The changes, one sentence each.
  std::vector<std::string> failures;  ///< Steps that were asked for and impossible, likewise.
};

/// Mends a mesh in this order: vertices of open edges that lie within the crack are welded, faces
/// without area and repeated ones are dropped, T-junctions are stitched, walls inside are dropped
/// (clean_faces.h), faces are turned consistently; the half is mirrored, loops are filled, what is
/// still open becomes plates, faces are turned outward, overlapping parts are united. The same mesh
/// gives the same result to the last bit.
/// @param mesh   Its vertices must be finite.
MendedMesh mended(TriMesh mesh, const MendOptions& options);

}  // namespace hydro
