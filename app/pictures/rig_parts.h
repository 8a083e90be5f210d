#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "app/pictures/drawn_rig.h"
#include "engine/base/spec.h"
#include "hydro/mesh/mesh.h"

/// @file
/// The solid parts of a rig in pictures and in the replay of a report: propellers, rudders and
/// sails, anchors and joints. Sizes that a scene does not give are in proportion to its bodies.

namespace app {

/// The pose of a body in W.
Eigen::Isometry3d pose_of(const hydro::BodyState& state);

/// A part that moves with a body.
struct RigPart {
  enum class Kind { propeller, foil, fixed };
  std::string
      name;  ///< As in logs: `propellers[main]`, and of the fixed end of a line `ropes[tow]`.
  Kind kind = Kind::fixed;
  std::size_t index = 0;                 ///< Index of the propeller or foil.
  engine::BodyId body = engine::kWorld;  ///< The body that it is fixed to.
  std::shared_ptr<const hydro::TriMesh> mesh_P;
  Eigen::Isometry3d X_BP = Eigen::Isometry3d::Identity();  ///< Its place while nothing is turned.
  Eigen::Vector3d color = {0.5, 0.5, 0.5};

  /// The pose in B as its machine is turned.
  Eigen::Isometry3d turned_B(const engine::SimulationSpec& spec, const DrawnRig& rig) const;
};

/// Returns the parts of a scene: propellers, foils, anchors and the fixed ends of lines; with
/// `joints` also pins, balls and bars of the joints.
std::vector<RigPart> rig_parts(const engine::SimulationSpec& spec, bool joints);

/// The drawn radius of a line [m]: half the diameter for its drag if it has one, else in
/// proportion to the smaller body that it holds.
double line_radius(const engine::SimulationSpec& spec, const engine::LineSpec& line);

/// The length that hangs from each body of a broken line [m]: a third of it, up to a limit.
double broken_length(const engine::SimulationSpec& spec, const engine::LineSpec& line);

/// The coil of a drawn spring.
struct Coil {
  double radius = 0;  ///< [m]
  int turns = 1;
};
Coil coil_of(const engine::SimulationSpec& spec, const engine::LineSpec& line);

}  // namespace app
