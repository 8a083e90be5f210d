// Drops a crate into the sea and prints where it floats after a minute.
#include <cstdio>

#include "engine/simulation.h"
#include "hydro/added_mass/deep_added_mass.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/primitives.h"

int main() {
  const hydro::TriMesh box = hydro::make_box({1, 1, 0.5});
  const auto solution = hydro::solve_added_mass(box, {.tolerance = 1e-2});
  engine::BodySpec crate = {.name = "crate", .mesh_B = box, .mass = 150};
  crate.inertia_B = 300 * hydro::solid_properties(box).inertia;
  crate.initial.position = {0, 0, 0.25};
  crate.coefficients = hydro::for_mesh({}, box, 1.0034e-6);
  crate.added_mass = std::make_shared<hydro::DeepAddedMass>(box, solution);
  engine::Simulation simulation({.sea = hydro::Sea(), .bodies = {crate}});
  while (simulation.time() < 60) simulation.step();
  std::printf("draught %.3f m\n", 0.25 - simulation.states()[0].position.z());
}
