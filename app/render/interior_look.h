#pragma once

#include <Eigen/Core>
#include <vector>

#include "app/render/shaded_mesh.h"
#include "app/render/vertex_water.h"
#include "hydro/interior/pockets.h"
#include "hydro/mesh/mesh.h"
#include "hydro/sea.h"
#include "hydro/spatial.h"

/// @file
/// The hollows of a body in a picture: a pocket has the pressure of its own water, and none where
/// it is dry; the surface of that water is drawn, and the sea is left out of the mouth.

namespace render {

/// The hollows of a body.
enum class Hollows {
  none,     ///< All of its surface is in the sea.
  dry,      ///< The pockets of one attitude are dry.
  flooding  ///< The pockets of its pose are dry but for the water that is told.
};

/// Water in a pocket.
struct PocketLook {
  Eigen::Vector3d at_W = Eigen::Vector3d::Zero();  ///< A point straight above the pocket's surface.
  double level = 0;                                ///< z of the water's surface [m].
  bool flooded = false;                            ///< It is a part of the sea.

  bool operator==(const PocketLook&) const = default;
};

/// The water in the pockets of each body; pockets that are not named are dry.
using Interiors = std::vector<std::vector<PocketLook>>;

/// Triangles in W, each with three vertices of its own.
using Triangles = Eigen::Matrix3Xd;

/// The pockets of a drawn body in a pose.
class InteriorLook {
 public:
  /// @param mesh_B   The mesh that the skin was made of.
  /// @param up_B     The vertical for which the pockets are those of the body.
  InteriorLook(const hydro::TriMesh& mesh_B, const Eigen::Vector3d& up_B,
               const hydro::BodyState& state, const std::vector<PocketLook>& waters);

  bool has_pockets() const { return !division_.pockets.empty(); }

  /// Gives the vertices of pockets their own water; those of a sill keep the sea's.
  void set_water(const ShadedMesh& skin, const hydro::Sea& sea, VertexWater& water) const;

  /// The surfaces of the water in the pockets.
  Triangles surfaces() const;

  /// The surface of the sea where it would lie in pockets that it does not fill.
  Triangles openings(const hydro::Sea& sea, double time) const;

 private:
  bool stands_out(int pocket, const hydro::Sea& sea, double time) const;

  const hydro::TriMesh& mesh_B_;
  hydro::BodyState state_;
  Eigen::Matrix3Xd points_W_;  ///< The vertices.
  hydro::Pockets division_;
  std::vector<const PocketLook*> water_;  ///< Water of each pocket; null: it is dry.
};

}  // namespace render
