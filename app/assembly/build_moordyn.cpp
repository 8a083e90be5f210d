#include "app/assembly/build_moordyn.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>

#include "app/assembly/moordyn_file.h"
#include "engine/rig/dynamic_lines.h"

namespace assembly {
namespace {

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// A line between two of the points, whose first end is on a body.
engine::LineSpec line_of(const MoorDynLine& given, engine::AttachmentPoint first,
                         engine::AttachmentPoint second, const engine::SimulationSpec& spec) {
  if (first.body == engine::kWorld) std::swap(first, second);
  const double area = std::numbers::pi / 4 * given.diameter * given.diameter;
  const double density = spec.sea ? spec.sea->density : 0;
  engine::LineSpec line{.name = given.id,
                        .kind = engine::LineSpec::Kind::mooring,
                        .first = first,
                        .second = second,
                        .length = given.length,
                        .stiffness = given.stiffness,
                        .inertia = engine::LineInertia{.segments = given.segments,
                                                       .mass = given.mass,
                                                       .drag_along = given.drag_along,
                                                       .added_mass = given.added_mass},
                        .weight = spec.gravity * (given.mass - density * area),
                        .on_bottom = false,
                        .drag_diameter = given.diameter,
                        .drag_coefficient = given.drag};
  if (!spec.sea || !std::isfinite(spec.sea->depth)) return line;
  line.inertia->bottom = spec.sea->level - spec.sea->depth;
  line.on_bottom = second.body == engine::kWorld &&
                   std::abs(second.at.z() - line.inertia->bottom) <= 1e-3 * spec.sea->depth;
  return line;
}

}  // namespace

void build_moordyn(engine::SimulationSpec& spec, BuildLog& log, const Attach& attach) {
  if (!log.scene.moordyn) return;
  const scene::MoorDyn& given = *log.scene.moordyn;
  const auto fault = [&](const char* key, const std::string& message) {
    log.faults.add(log.scene.places, key, message);
  };
  try {
    const MoorDynFile file = read_moordyn(text_of(given.file));
    const auto coupled = static_cast<std::size_t>(
        std::ranges::count_if(file.points, [](const MoorDynPoint& p) { return p.coupled; }));
    if (given.bodies.size() != 1 && given.bodies.size() != coupled)
      return fault("moorings.bodies",
                   fmt::format("found a list of {}, expected one name, or one for each of the {} "
                               "coupled points of the file",
                               given.bodies.size(), coupled));
    std::vector<engine::AttachmentPoint> points;
    std::size_t next = 0;
    const Eigen::Vector3d level(0, 0, spec.sea ? spec.sea->level : 0);
    for (const MoorDynPoint& point : file.points)
      points.push_back(point.coupled
                           ? attach(given.bodies[given.bodies.size() == 1 ? 0 : next++], point.at)
                           : engine::AttachmentPoint{.at = point.at + level});
    for (const MoorDynLine& line : file.lines) {
      spec.lines.push_back(line_of(line, points[static_cast<std::size_t>(line.first)],
                                   points[static_cast<std::size_t>(line.second)], spec));
      const double longest = engine::longest_step(spec, spec.lines.back());
      if (spec.step > longest)
        fault("moorings.moordyn",
              fmt::format("line {} between two bodies needs a step of {:.3g} s or less; the "
                          "scene's is {:g} s",
                          line.id, longest, spec.step));
    }
    for (const std::string& what : file.left_out)
      log.warnings.push_back(fmt::format("moorings.moordyn: {} of the file is left out", what));
  } catch (const MoorDynFault& error) {
    return fault("moorings.moordyn", error.what());
  }
}

}  // namespace assembly
