#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/assembly/rest_states.h"
#include "app/assembly/rigid_group.h"
#include "app/scene/body.h"
#include "hydro/radiation/radiation_data.h"

/// @file
/// The hulls of a scene, and the poses about which they move.

namespace assembly {

/// A body, or bodies that fixed joints hold together, as one hull. Frame B is that of its first
/// body, which leads.
struct RadiatingHull {
  RigidGroup group;
  engine::BodyId lead = 0;
  std::vector<hydro::TriMesh> parts_B;  ///< The surfaces that the sea outside sees, a body each.
  hydro::TriMesh mesh_B;                ///< All of them, side by side.
  double mass = 0;                      ///< Without the water inside [kg].
  double water = 0;                     ///< Mass of that water [kg].
  /// Centre of mass without that water [m].
  Eigen::Vector3d com_B = Eigen::Vector3d::Zero();
  std::vector<hydro::Tank> tanks_B;  ///< Tanks with that water.
};

/// Joins the bodies of a group in their poses at the start.
RadiatingHull radiating_hull(const engine::SimulationSpec& spec, const RigidGroup& group,
                             engine::BodyId lead);

/// The union of the parts that are wet in a pose, or why they have none.
struct WetSurface {
  hydro::TriMesh mesh_B;
  std::string fault;  ///< Empty if there is a union.
};
WetSurface wet_surface(const engine::SimulationSpec& spec, const RadiatingHull& hull,
                       const hydro::MeanPose& pose);

/// A mean pose, and how it was found.
struct FoundPose {
  hydro::MeanPose pose;
  std::string holder;       ///< Holder of the hull besides the water; empty: none.
  bool at_rest = false;     ///< It is in equilibrium; otherwise the pose is that of the start.
  double start_tilt = 0;    ///< Angle between the verticals of this pose and the start [rad].
  double start_volume = 0;  ///< Displaced at the start over that displaced here [-].
};

/// Attitude of a hull that floats at rest, and height of its lead's centre of mass over the water.
struct FreeRest {
  engine::BodyId lead = 0;
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  double height = 0;  ///< [m]
};

/// Finds mean poses; a group that is held comes to rest once for all of its bodies.
class MeanPoses {
 public:
  explicit MeanPoses(const engine::SimulationSpec& spec);

  /// Returns the holder of a hull besides the water; empty: none.
  std::string holder(const RadiatingHull& hull) const;

  /// @param hull     One that nothing holds must be able to float.
  /// @param wanted   None: equilibrium.
  FoundPose find(const RadiatingHull& hull, const std::optional<scene::Radiation::Pose>& wanted);

 private:
  /// The state of the hull's lead at rest; none where it does not come to rest near its start.
  std::optional<hydro::BodyState> held_rest(const RadiatingHull& hull, std::size_t group);

  /// The rest of a hull that the water alone carries. Bodies that float alike share it.
  FreeRest free_rest(const RadiatingHull& hull);

  const engine::SimulationSpec& spec_;
  std::vector<FreeRest> known_;  ///< Rests of single bodies, one for all that float alike.
  std::vector<HeldGroup> groups_;
  std::vector<std::size_t> group_of_;  ///< Per body, an index of `groups_`.
  std::map<std::size_t, std::optional<Rest>> rests_;
};

}  // namespace assembly
