#pragma once

#include <optional>
#include <vector>

#include "app/pictures/shot_spool.h"
#include "app/render/annotation.h"
#include "app/scene/scene.h"
#include "engine/spec.h"
#include "hydro/loads/loads.h"

/// @file
/// Forces and centres of bodies as arrows and marks on their pictures.

namespace app {

/// Finds what is to be drawn on each picture of a sequence. Arrows have one scale: that of the
/// largest force in the shots included is a fifth of a picture's height.
class ForceAnnotations {
 public:
  /// Both must outlive it.
  ForceAnnotations(const scene::Render& look, const engine::SimulationSpec& spec);

  /// Lets scale and legend cover the forces in a shot; does nothing unless they are shown.
  void include(const Shot& shot);

  /// @param picture_size    Height of the picture at the point looked at [m].
  render::Annotations of(const Shot& shot, double picture_size) const;

 private:
  /// @param scale   [m/N]
  void add_forces(std::size_t body, const Shot& shot, double scale,
                  render::Annotations& notes) const;
  void add_centres(std::size_t body, const Shot& shot, render::Annotations& notes) const;

  const scene::Render& look_;
  const engine::SimulationSpec& spec_;
  std::vector<hydro::Hull> hulls_;          ///< Of the bodies, if forces are shown.
  std::vector<render::LegendLine> legend_;  ///< Of the forces that occur.
  double largest_ = 0;                      ///< [N]
};

/// Centre of the volume of a closed mesh under the water [m, W]; none of a dry one. In waves the
/// depth of a point is that below the surface over it.
std::optional<Eigen::Vector3d> centre_of_buoyancy(const hydro::TriMesh& mesh_B,
                                                  const hydro::BodyState& state,
                                                  const hydro::Sea& sea, double time);

}  // namespace app
