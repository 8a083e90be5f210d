#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/pictures/shot_spool.h"
#include "app/render/annotation.h"
#include "app/scene/scene.h"
#include "engine/base/spec.h"
#include "hydro/loads/loads.h"

/// @file
/// Forces and centres of bodies as arrows and marks on their pictures.

namespace app {

/// Finds the arrows and marks of each picture of a sequence. Arrows share one scale: the arrow of
/// the largest force in the included shots is a fifth of a picture's height.
class ForceAnnotations {
 public:
  /// Both arguments must outlive the object.
  ForceAnnotations(const scene::Render& look, const engine::SimulationSpec& spec);

  /// Extends scale and legend to the forces in a shot; does nothing unless forces are shown.
  void include(const Shot& shot);

  /// @param picture_size    Height of the picture at the point looked at [m].
  render::Annotations of(const Shot& shot, double picture_size) const;

 private:
  /// @param scale   Length of an arrow per force [m/N].
  void add_forces(std::size_t body, const Shot& shot, double scale,
                  render::Annotations& notes) const;
  void add_centres(std::size_t body, const Shot& shot, render::Annotations& notes) const;

  const scene::Render& look_;
  const engine::SimulationSpec& spec_;
  std::vector<hydro::Hull> hulls_;          ///< Hulls of the bodies, if forces are shown.
  std::vector<render::LegendLine> legend_;  ///< Lines of the forces that occur.
  double largest_ = 0;                      ///< Largest force [N].
};

/// Returns a force with its unit: `120 kN`.
std::string force_text(double newtons);

/// Returns the centroid of the submerged volume of a closed mesh [m, W]; none if the mesh is dry.
/// In waves the depth of a point is measured from the surface above it.
std::optional<Eigen::Vector3d> centre_of_buoyancy(const hydro::TriMesh& mesh_B,
                                                  const hydro::BodyState& state,
                                                  const hydro::Sea& sea, double time);

}  // namespace app
