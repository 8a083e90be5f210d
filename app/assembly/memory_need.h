#pragma once

#include "app/scene/shape.h"
#include "hydro/added_mass/added_mass.h"

/// @file
/// Estimates of the memory that parts of a scene take, before they take it. Each is within a factor
/// of two of what was measured (tests/app/assembly/memory_need_test.cpp).

namespace assembly {

/// Returns the number of triangles of a shape; 0 for a mesh, which its file knows.
double triangles_of(const scene::Shape& shape);

/// Returns the memory for a body of so many triangles while it is built and simulated [bytes]: its
/// mesh and copies of it, the tables of the check, the panels and the tree of its hull.
double body_bytes(double triangles);

/// Returns the memory for the solution of a mesh's added mass [bytes]. Up to 5000 panels it is that
/// of a matrix of n² doubles with two unknowns per panel; small meshes are split into up to
/// AddedMassOptions::most_panels of them. Beyond, interactions are compressed.
double added_mass_bytes(double triangles, const hydro::AddedMassOptions& options = {});

}  // namespace assembly
