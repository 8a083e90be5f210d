#pragma once

#include <optional>
#include <vector>

#include "app/render/annotation.h"
#include "app/scene/scene.h"
#include "app/shots.h"
#include "engine/spec.h"
#include "hydro/loads.h"

/// @file
/// Forces and centres of bodies as arrows and marks on their pictures.

namespace app {

/// Finds what is to be drawn on each picture of a sequence. Arrows of all of them have one scale:
/// the longest is a fifth of the picture's height.
class ForceNotes {
 public:
  /// @param shots           Of the sequence, for the scale; looked at only if forces are shown.
  /// @param picture_size    Height of the picture at the point looked at [m].
  ForceNotes(const RenderScene& look, const engine::SimulationSpec& spec,
             const std::vector<Shot>& shots, double picture_size);

  render::Annotations of(const Shot& shot) const;

 private:
  void add_forces(std::size_t body, const Shot& shot, render::Annotations& notes) const;
  void add_centres(std::size_t body, const Shot& shot, render::Annotations& notes) const;

  const RenderScene& look_;
  const engine::SimulationSpec& spec_;
  std::vector<hydro::Hull> hulls_;          ///< Of the bodies.
  std::vector<render::LegendLine> legend_;  ///< Of the forces that occur.
  double length_per_force_ = 0;             ///< [m/N]
  double shortest_ = 0;                     ///< Arrow [m].
  double scale_force_ = 0;                  ///< That the legend shows [N].
};

/// Centre of the volume of a closed mesh under the water [m, W]; none of a dry one. In waves the
/// depth of a point is that below the surface over it.
std::optional<Eigen::Vector3d> centre_of_buoyancy(const hydro::TriMesh& mesh_B,
                                                  const hydro::BodyState& state,
                                                  const hydro::Sea& sea, double time);

}  // namespace app
