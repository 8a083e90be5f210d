#pragma once

#include <functional>

#include "app/databases/body_data.h"
#include "app/databases/database.h"
#include "app/databases/heading_grid.h"

/// @file
/// Checks of a database, each of which refuses contradictions and notes what is slightly wrong.
/// @throws InputError each

namespace databases {

/// Makes A, B and A∞ symmetric, and takes the small negative eigenvalues out of B. Frequencies at a
/// bad end (bad_ends.h) are left out and noted, or single bad ones.
/// @param lever   Length by which moments are compared with forces [m].
void check_matrices(Database& database, double lever, BodyData& found);

/// Compares displaced volume and waterplane with those of the mesh.
void check_statics(const Database& database, const FloatingMesh& body, BodyData& found);

/// Compares the damping with that of Haskind's relation, for loads over the whole circle, and the
/// phase of the longest waves' push with that of the water's acceleration.
void check_loads(const Database& database, double lever, BodyData& found);

/// The columns of the other bodies at a frequency; empty without others.
using Neighbours = std::function<Eigen::Matrix<double, 6, 3>(std::size_t)>;

/// Compares forces and moments of waves with those that the mesh lets expect: at one frequency the
/// Froude-Krylov forces, where the file has them; else in its longest waves, if the body is small
/// in them, the whole excitation, which is then the Froude-Krylov force and that of the water's
/// acceleration on the added mass. This finds a wrong point of reference, phase or heading.
/// @param froude_krylov   The file's, or what takes its place.
/// @param neighbours      `Database::neighbours` about the body's centre of mass, in H.
void check_loads_by_mesh(const Database& database, const FloatingMesh& body,
                         const LoadTable& froude_krylov, const LoadTable& diffraction,
                         const Neighbours& neighbours, double lever, BodyData& found);

}  // namespace databases
