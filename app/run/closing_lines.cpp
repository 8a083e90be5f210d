#include "app/run/closing_lines.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

#include "app/base/console.h"
#include "app/base/words.h"
#include "hydro/added_mass/surface_added_mass.h"

namespace app {
namespace {

/// Solutions that were not in the store. Bodies may share one.
struct Solved {
  std::set<const void*> added_mass, radiation;
  std::set<const void*> resistance;
  int at_the_surface = 0;
};

Solved solved_in(const assembly::BuiltScene& built) {
  Solved solved;
  std::set<const void*> surfaces;
  for (const auto& report : built.added_mass) {
    if (!report) continue;
    if (report->stored && !report->stored->from_store)
      solved.added_mass.insert(report->stored->solution.get());
    if (report->surface && surfaces.insert(report->surface.get()).second)
      solved.at_the_surface += report->surface->solves();
  }
  for (const assembly::RadiationReport& report : built.radiation)
    if (report.stored && !report.stored->from_store)
      solved.radiation.insert(report.stored->solution.get());
  for (const assembly::ResistanceReport& report : built.resistance)
    if (report.ship && !report.from_store) solved.resistance.insert(report.ship.get());
  return solved;
}

/// Returns `; solved: added mass of 1 mesh, …`; empty if all was known.
std::string solved_text(const assembly::BuiltScene& built) {
  const Solved solved = solved_in(built);
  std::vector<std::string> texts;
  if (!solved.added_mass.empty())
    texts.push_back("added mass of " + counted(solved.added_mass.size(), "mesh", "meshes"));
  if (!solved.radiation.empty())
    texts.push_back("radiation of " + counted(solved.radiation.size(), "mesh", "meshes"));
  if (!solved.resistance.empty())
    texts.push_back("wave resistance of " + counted(solved.resistance.size(), "hull", "hulls"));
  if (solved.at_the_surface > 0)
    texts.push_back(counted(static_cast<std::size_t>(solved.at_the_surface),
                            "added mass in the surface", "added masses in the surface"));
  return texts.empty() ? "" : fmt::format("; solved: {}", fmt::join(texts, ", "));
}

}  // namespace

std::vector<std::string> closing_lines(const RunSummary& summary,
                                       const std::filesystem::path& folder) {
  const engine::Timings& t = summary.timings;
  const std::string water = summary.built.spec.water ? fmt::format("water {:.2f}, ", t.water) : "";
  std::vector<std::string> lines = {fmt::format(
      "{}: {} steps, {:g} s simulated in {:.2f} s (added mass and radiation {:.2f}, hydro {:.2f}, "
      "collision {:.2f}, engine {:.2f}, {}log {:.2f}, pictures {:.2f}){}",
      folder.string(), summary.steps, summary.simulated, summary.wall,
      summary.built.added_mass_seconds, t.hydro, t.collision, t.engine, water, summary.wall_log,
      summary.wall_render, solved_text(summary.built))};
  for (std::string& line : error_lines(summary.built.spec, summary.errors))
    lines.push_back(std::move(line));
  if (!summary.pictures) return lines;
  if (const auto& names = summary.pictures->cameras; !names.empty())
    lines.push_back(fmt::format("{}: {} pictures, by the cameras {}", folder.string(),
                                summary.pictures->frames, enumerate(names, "and")));
  for (std::string& line : videos_made(*summary.pictures)) lines.push_back(std::move(line));
  return lines;
}

}  // namespace app
