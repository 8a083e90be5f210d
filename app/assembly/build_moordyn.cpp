#include "app/assembly/build_moordyn.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "engine/moordyn_system.h"

namespace assembly {
namespace {

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

engine::BodyId body_named(const engine::SimulationSpec& spec, const std::string& name) {
  const auto body = std::ranges::find(spec.bodies, name, &engine::BodySpec::name);
  return static_cast<engine::BodyId>(body - spec.bodies.begin());
}

}  // namespace

void build_moordyn(BuiltScene& built, BuildLog& log) {
  if (!log.scene.moordyn) return;
  const scene::MoorDyn& given = *log.scene.moordyn;
  const auto fault = [&](const char* key, const std::string& message) {
    log.faults.add(log.scene.places, key, message);
  };
  engine::SimulationSpec& spec = built.spec;
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
    for (std::size_t i = 0; i < points; ++i) {
      const engine::BodyId body = body_named(spec, given.bodies[given.bodies.size() == 1 ? 0 : i]);
      const Eigen::Vector3d com_M = built.centers_of_mass[static_cast<std::size_t>(body)];
      moordyn.points.push_back({.body = body, .at = system.coupled_points()[i] - com_M});
    }
    moordyn.lines = system.lines();
    for (const std::string& warning : system.warnings())
      log.warnings.push_back("moorings.moordyn: MoorDyn: " + warning);
  } catch (const engine::MoorDynFault& error) {
    return fault("moorings.moordyn", error.what());
  }
  spec.moordyn = std::move(moordyn);
}

}  // namespace assembly
