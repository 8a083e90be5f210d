#pragma once

#include "app/databases/body_data.h"
#include "app/databases/database.h"

namespace databases {

/// Brings a database to the body's frame H and its centre of mass, its loads to evenly spaced
/// headings, and checks it (physics of hydro/radiation/README.md):
/// - A, B and A∞ must be symmetric, and B and A∞ have no negative eigenvalues. A small asymmetry or
///   negative eigenvalue is removed.
/// - Loads of waves over the circle must radiate the damping (Haskind), and the slowest must push
///   the body as the water accelerates, which finds a wrong time convention.
/// - Volume and waterplane must be those of the mesh.
///
/// Where the file has no A∞ it follows from A and B by Ogilvie's relation. Where it has no
/// diffraction, that is its excitation less the Froude-Krylov force on the mesh.
/// @throws InputError for a check that fails, a missing A∞ that does not follow, and loads of waves
///     that are missing or do not cover the circle while the water has waves
BodyData fit_to_body(const Database& database, const scene::RadiationFile& source,
                     const FloatingMesh& body);

}  // namespace databases
