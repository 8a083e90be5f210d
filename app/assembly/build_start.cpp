#include "app/assembly/build_start.h"

#include <fmt/format.h>

#include "app/assembly/build_interior.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/statics/equilibrium.h"

namespace assembly {

std::string why_not_afloat(double mass, double volume, double density) {
  const double most = density * volume;
  // Round-off of a mesh's volume is larger than that of a double; within 1e-12 the masses are
  // equal.
  if (mass < (1 - 1e-12) * most) return "";
  return fmt::format(
      "it {}: its mass is {:.7g} kg and its volume of {:.7g} m^3 displaces {:.7g} kg",
      mass > (1 + 1e-12) * most ? "sinks" : "hovers in the water, as heavy as it", mass, volume,
      most);
}

void put_afloat(const Eigen::Vector3d& position, const Eigen::Vector3d& com_M,
                const std::string& key_path, engine::BodySpec& body, BuildLog& log) {
  const scene::Water& water = *log.scene.water;
  const hydro::TriMesh& mesh_B = engine::outside_B(body);
  const double volume = hydro::solid_properties(mesh_B).volume;
  const double mass = mass_afloat(body, water.density);
  const std::string reason = why_not_afloat(mass, volume, water.density);
  if (!reason.empty()) return log.faults.add(log.scene.places, key_path + ".start", reason);
  hydro::BodyState& state = body.initial;
  const double heading = hydro::euler_angles(state.orientation)[2];
  const hydro::Flotation rest =
      hydro::equilibrium(mesh_B, mass / water.density, state.orientation, tanks_of(body));
  state.orientation = hydro::with_heading(rest.orientation, heading);
  state.position = position + state.orientation * com_M;
  state.position.z() = water.level + rest.height;
}

}  // namespace assembly
