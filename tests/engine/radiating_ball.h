#pragma once

#include "engine/motion/energy.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/primitives.h"
#include "tests/engine/prelude.h"
#include "tests/support/radiating_sphere.h"

/// Bodies that make waves.

namespace support {

inline constexpr double kRho = 1000;  ///< Density of the water [kg/m^3].

/// A sphere of 1 m that floats half submerged, without drag.
inline BodySpec radiating_ball(const hydro::RadiationData& data) {
  BodySpec body = sphere_body("ball", 1, 500, {0, 0, 0});
  body.mesh_B = hydro::make_icosphere(1, 3);
  body.mass = kRho / 2 * hydro::solid_properties(body.mesh_B).volume;
  body.wet = true;
  body.coefficients.pressure_drag = {0, 0};
  body.coefficients.lift = 0;
  body.coefficients.viscous_drag.law = hydro::ViscousDrag::Law::none;
  body.radiation = std::make_shared<hydro::FloatingBody>(body.mesh_B, data);
  body.added_mass = body.radiation;
  return body;
}
inline BodySpec radiating_ball() {
  static const BodySpec body = radiating_ball(radiating_sphere(1));
  return body;
}

/// The body in still water.
inline SimulationSpec afloat(const BodySpec& body, double step) {
  SimulationSpec spec = dry_world({body}, step);
  spec.sea = hydro::Sea{.density = kRho, .gravity = kGravity};
  return spec;
}

/// Waves that surge and sway make differently, of a body that is not round.
inline hydro::RadiationData uneven_data() {
  hydro::RadiationData data = radiating_sphere(1);
  for (const int turn : {3, 4, 5}) {
    data.infinite_added_mass(turn, turn) = 0.2;
    for (Matrix6d& mass : data.added_mass) mass(turn, turn) = 0.2;
  }
  for (Matrix6d& damping : data.damping) damping(0, 0) *= 0.1;
  for (Matrix6d& mass : data.added_mass)
    mass(0, 0) =
        data.infinite_added_mass(0, 0) + 0.1 * (mass(0, 0) - data.infinite_added_mass(0, 0));
  return data;
}

/// Of body and waves [J].
inline double energy(const engine::Body& body, const engine::Motion& motion) {
  return engine::kinetic_energy(body, motion, body.current()) +
         engine::potential_energy(body, motion) + engine::memory_energy(body, motion);
}

}  // namespace support
