// Leaves the crate of a scene to the sea, pushes it for a second, and prints where it floats.
#include <cstdio>

#include "app/assembly/build.h"
#include "app/scene/reader.h"
#include "engine/simulation.h"

int main(int, char** arguments) {
  const scene::Scene crate = scene::read(arguments[1], {{"bodies[crate].density", "300"}});
  assembly::AddedMassStore store(assembly::cache_folder());
  engine::Simulation simulation(assembly::build(crate, store).spec);
  const hydro::Wrench push = {.force = {200, 0, 0}, .moment = {0, 0, 0}};
  while (simulation.time() < crate.duration) {
    if (simulation.time() < 1) simulation.apply(0, push);
    simulation.step();
  }
  const hydro::BodyState& last = simulation.states()[0];
  std::printf("draught %.3f m, by Archimedes 0.150 m; drifted by %.2f m\n",
              0.25 - last.position.z(), last.position.x());
}
