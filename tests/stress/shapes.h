#pragma once

#include <memory>
#include <string>

#include "engine/spec.h"

/// @file
/// The bodies of the stress test.

namespace stress {

/// A body's surface and mass, its centre of mass in the origin.
struct Shape {
  hydro::TriMesh mesh_B;                              ///< Its largest extent is its size [m].
  double volume = 0;                                  ///< [m^3]
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< For a mass of 1 kg [m^2].
};

/// cube: 12 triangles; ball: an icosphere of 320; shell: the same, hollow; plate: 1 × 1 × 0.01;
/// needle: 1 × 0.01 × 0.01; teapot: 1,240 triangles; teapot80k: 79,656 triangles.
/// @throws std::invalid_argument for another name.
Shape make_shape(const std::string& name, double size);

/// The model named by the run's value `added` for the shape: none, deep, or a number, the largest
/// ratio of A to M, which then differs between the axes and couples surge with pitch.
std::shared_ptr<const hydro::AddedMassModel> make_added_mass(const std::string& added,
                                                             const std::string& shape, double size,
                                                             const engine::BodySpec& body);

}  // namespace stress
