#pragma once

#include <memory>
#include <string>

#include "engine/base/spec.h"

/// @file
/// Shapes and added mass of the bodies of the stress test.

namespace stress {

/// Surface and mass properties of a body with its centre of mass in the origin.
struct Shape {
  hydro::TriMesh mesh_B;         ///< Mesh whose largest extent is the size [m].
  hydro::TriMesh closed_mesh_B;  ///< The same with the mouths of its pockets closed.
  double volume = 0;             ///< Of the closed mesh [m^3].
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< For a mass of 1 kg [m^2].
};

/// cube: 12 triangles; ball: an icosphere of 320 triangles; shell: a hollow ball; plate: 1 × 1 ×
/// 0.01; needle: 1 × 0.01 × 0.01; tub: a box that is open at the top; tank: the same, divided by a
/// wall; teapot: 1,240 triangles; teapot80k: 79,656 triangles.
/// @throws std::invalid_argument for another name.
Shape make_shape(const std::string& name, double size);

/// The grid of simulated water for a body, as build_water.h has it: cells of a quarter of its
/// breadth, and no waves too fast for the step.
hydro::PeriodicSquare square_for(const engine::BodySpec& body, const hydro::Sea& sea, double step);

/// Gives the body what the run's value `added` names: none; deep; waves, which it makes as if it
/// floated half immersed; simulated, the same in simulated water for a step [s], where it is wider
/// than a cell; or a number, which is the largest ratio of A to M: A then differs between
/// the axes and couples surge with pitch.
void add_inertia_of_water(const std::string& added, const std::string& shape, double size,
                          const hydro::Sea& sea, double step, engine::BodySpec& body);

}  // namespace stress
