#pragma once

/// @file
/// Estimates of the time that solutions of meshes take.

namespace assembly {

/// Returns the wall time of the solution of a mesh's added mass [s], within a factor of three for
/// meshes of 1,000 to 80,000 triangles.
double added_mass_seconds(double triangles, int threads);

/// Returns the same of the solution of radiation and diffraction [s].
double radiation_seconds(double triangles, int threads);

}  // namespace assembly
