// Reads a scene and prints its bodies, or every fault of its file.
#include <cstdio>

#include "app/scene/reader.h"

int main(int, char** arguments) {
  try {
    const scene::Scene input = scene::read(arguments[1], {{"bodies[0].position", "[0, 0, 2]"}});
    for (const scene::Body& body : input.bodies)
      std::printf("%s starts at z = %g m\n", body.name.c_str(), body.position.z());
  } catch (const scene::InputError& error) {
    std::printf("%s\n", error.what());
    return 1;
  }
}
