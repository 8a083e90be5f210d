#pragma once

#include <optional>
#include <vector>

#include "hydro/mesh/mending/mend.h"
#include "hydro/mesh/mesh.h"
#include "hydro/mesh/mesh_check.h"
#include "hydro/mesh/open_loops.h"

/// @file
/// Says what a mesh is, and what makes a solid of it.

namespace hydro {

/// A set of faces that edges connect.
struct DiagnosedPart {
  Eigen::Index faces = 0;
  Eigen::AlignedBox3d box;  ///< [m]
  int open_loops = 0;
  double area = 0;    ///< [m^2]
  double volume = 0;  ///< Enclosed, whichever way the faces look [m^3]; 0 if the part is open.
  bool closed = false;
};

/// Two closed parts that overlap.
struct DiagnosedOverlap {
  int first = 0, second = 0;     ///< Parts.
  std::optional<double> volume;  ///< Volume that they share [m^3]; none if it cannot be found.
};

struct MeshDiagnosis {
  MeshReport report;
  std::vector<DiagnosedPart> parts;  ///< In the order of their lowest faces.
  std::vector<OpenLoop> loops;       ///< As they are once the faces agree.
  std::vector<int> part_of_loop;
  std::vector<DiagnosedOverlap> overlaps;
  Eigen::Index t_junctions =
      0;            ///< Vertices that lie on open sides of faces, within default_weld().
  double area = 0;  ///< [m^2]
};

/// Looks at a mesh as its file has it, with coinciding vertices welded. Vertices must be finite.
MeshDiagnosis diagnosed(const TriMesh& mesh);

/// Options that make a solid of a mesh, and the volume that it then has [m^3].
struct Remedy {
  MendOptions options;
  double volume = 0;
};

/// Tries what `mended` does, from the least on: nothing else; wider cracks, up to a thousandth of
/// the size; the mirror image, of a mesh that is open at the plane y = 0 or x = 0; caps; united
/// parts.
/// @return the first that gives a solid; none if none does. No thickness is guessed.
std::optional<Remedy> remedy_for(const TriMesh& mesh);

}  // namespace hydro
