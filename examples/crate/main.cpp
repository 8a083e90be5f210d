// Leaves a crate to the sea and prints where it floats.
#include <cstdio>

#include "engine/simulation.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/primitives.h"

int main() {
  const double density = 400;  // kg/m³

  engine::BodySpec crate;
  crate.name = "crate";
  crate.mesh_B = hydro::make_box({1, 1, 0.5}, 4);
  const hydro::SolidProperties solid = hydro::solid_properties(crate.mesh_B);
  crate.mass = density * solid.volume;
  crate.inertia_B = density * solid.inertia;
  crate.initial.position = {0, 0, 0.1};

  engine::SimulationSpec scene;
  scene.sea.emplace();  // Fresh water, still.
  scene.bodies.push_back(crate);

  engine::Simulation simulation(scene);
  while (simulation.time() < 60) simulation.step();

  const double draught = 0.25 - simulation.states()[0].position.z();
  std::printf("draught %.3f m, by Archimedes %.3f m\n", draught, 0.5 * density / 1000);
}
