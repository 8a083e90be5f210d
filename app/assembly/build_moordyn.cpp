#include "app/assembly/build_moordyn.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "engine/rig/moordyn/moordyn_system.h"

namespace assembly {
namespace {

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

void build_moordyn(engine::SimulationSpec& spec, BuildLog& log, const Attach& attach) {
  if (!log.scene.moordyn) return;
  const scene::MoorDyn& given = *log.scene.moordyn;
  const auto fault = [&](const char* key, const std::string& message) {
    log.faults.add(log.scene.places, key, message);
  };
  engine::MoorDynSpec moordyn{.file = given.file, .text = text_of(given.file)};
  try {
    const engine::MoorDynSystem system(
        given.file, moordyn.text,
        {.gravity = spec.gravity, .sea = spec.sea ? &*spec.sea : nullptr});
    const std::size_t points = system.coupled_points().size();
    if (given.bodies.size() != 1 && given.bodies.size() != points)
      return fault("moorings.bodies",
                   fmt::format("found a list of {}, expected one name, or one for each of the {} "
                               "coupled points of the file",
                               given.bodies.size(), points));
    for (std::size_t i = 0; i < points; ++i)
      moordyn.points.push_back(
          attach(given.bodies[given.bodies.size() == 1 ? 0 : i], system.coupled_points()[i]));
    moordyn.lines = system.lines();
    for (const std::string& warning : system.warnings())
      log.warnings.push_back("moorings.moordyn: MoorDyn: " + warning);
  } catch (const engine::MoorDynFault& error) {
    return fault("moorings.moordyn", error.what());
  }
  spec.moordyn = std::move(moordyn);
}

}  // namespace assembly
