#include "app/run/resolved_scene.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "app/assembly/build_radiation.h"
#include "app/base/console.h"
#include "app/run/body_tables.h"
#include "app/run/contact_text.h"
#include "app/run/resolved_rig.h"
#include "app/run/summary.h"
#include "engine/motion/locks.h"

namespace app {
namespace {

std::string irregular_text(const assembly::IrregularSea& sea) {
  return fmt::format("{} of H_s {:.3g} m and T_p {:.3g} s",
                     sea.fit ? "measured waves" : "a spectrum", sea.significant_height,
                     sea.peak_period);
}

std::string surface_text(const scene::Water& water, const assembly::BuiltScene& built) {
  if (std::holds_alternative<scene::HeightField>(water.surface)) return "a height field";
  const auto* waves = std::get_if<std::vector<scene::Wave>>(&water.surface);
  if (waves == nullptr && !built.irregular_sea) return "flat";
  const bool airy = water.kinematics == hydro::Kinematics::airy;
  return (waves != nullptr ? counted(waves->size(), "wave", "waves")
                           : irregular_text(*built.irregular_sea)) +
         (airy ? "" : " with hydrostatic pressure");
}

std::string water_text(const scene::Scene& scene, const assembly::BuiltScene& built) {
  if (!scene.water) return "no water";
  const scene::Water& water = *scene.water;
  const std::string depth = water.depth ? fmt::format(", {:g} m deep", *water.depth) : "";
  using Kind = scene::SimulatedWater::Kind;
  const std::string simulated =
      built.spec.water ? fmt::format(", simulated on {0} x {0} cells of {1:.3g} m",
                                     built.spec.water->square.cells, built.spec.water->square.cell)
      : water.simulated.kind == Kind::picture ? ", with bodies' waves in the pictures"
                                              : "";
  return fmt::format("water of {:g} kg/m^3 ({}{}{})", water.density, surface_text(water, built),
                     depth, simulated);
}

/// Describes the wind, if there is any: `, wind of 8 m/s`.
std::string wind_text(const scene::Scene& scene) {
  if (!scene.air) return "";
  const double speed = scene.air->wind.velocity.norm();
  return speed > 0 ? fmt::format(", wind of {:.3g} m/s", speed) : ", calm air";
}

std::string headline(const scene::Scene& scene, const assembly::BuiltScene& built) {
  const engine::SimulationSpec& spec = built.spec;
  std::string text = fmt::format("{}: {}", scene.file.stem().string(),
                                 counted(spec.bodies.size(), "body", "bodies"));
  if (!spec.joints.empty()) text += ", " + counted(spec.joints.size(), "joint", "joints");
  if (!spec.lines.empty()) text += ", " + counted(spec.lines.size(), "line", "lines");
  const std::size_t machines = spec.propellers.size() + spec.foils.size();
  if (machines > 0) text += ", " + counted(machines, "machine", "machines");
  return text + fmt::format("; {:g} s in steps of {:.4g} s; {}{}; {}", scene.duration, scene.step,
                            water_text(scene, built), wind_text(scene),
                            counted(spec.threads, "thread", "threads"));
}

/// Lists the names of bodies, or counts them if there are many.
std::string named_bodies(const std::vector<std::string>& names, std::size_t all) {
  constexpr std::size_t kMostNames = 3;
  if (names.size() == all && all > 1) return "all bodies";
  if (names.size() > kMostNames) return fmt::format("{} bodies", names.size());
  return fmt::format("{}", fmt::join(names, ", "));
}

/// Explains why a body has no added mass.
std::string reason_for_no_added_mass(const engine::SimulationSpec& spec,
                                     const engine::BodySpec& body,
                                     const assembly::RadiationChoice& choice) {
  if (choice.lead && spec.bodies[static_cast<std::size_t>(*choice.lead)].radiation)
    return choice.reason;
  if (spec.integrator.method == engine::Integrator::Method::ode) return "method ode has none";
  if (!body.wet) return "no load of the water acts on it";
  if (engine::immovable(body.locked)) return "held in all six";
  return "added_mass: none";
}

/// A quantity that is not computed for some bodies.
struct Omission {
  std::string what;
  std::string reason;
  std::vector<std::string> names;
};

void note_omission(const std::string& what, const std::string& reason, const std::string& name,
                   std::vector<Omission>& omissions) {
  auto found = std::find_if(omissions.begin(), omissions.end(), [&](const Omission& omission) {
    return omission.what == what && omission.reason == reason;
  });
  if (found == omissions.end()) found = omissions.insert(found, {what, reason, {}});
  found->names.push_back(name);
}

/// Returns the quantities that are not computed for single bodies.
std::vector<Omission> body_omissions(const assembly::BuiltScene& built) {
  std::vector<Omission> omissions;
  const engine::SimulationSpec& spec = built.spec;
  for (std::size_t i = 0; i < spec.bodies.size(); ++i) {
    const engine::BodySpec& body = spec.bodies[i];
    for (const std::string& load : unused_loads(body))
      if (load != "lift")  // It is off unless it is asked for.
        note_omission(load, "switched off", body.name, omissions);
    if (!built.added_mass[i])
      note_omission("added mass", reason_for_no_added_mass(spec, body, built.radiation[i].choice),
                    body.name, omissions);
    else if (!built.radiation[i].model && !built.radiation[i].choice.reason.empty())
      note_omission("radiation", built.radiation[i].choice.reason, body.name, omissions);
  }
  return omissions;
}

/// Omissions of one quantity for as many reasons as can be read; those of the fewest bodies, of
/// which each has a number of its own in its reason, are counted.
constexpr std::size_t kMostReasons = 4;

std::vector<Omission> readable(std::vector<Omission> omissions) {
  const auto more = [](const Omission& a, const Omission& b) {
    return a.names.size() > b.names.size();
  };
  std::stable_sort(omissions.begin(), omissions.end(), more);
  std::vector<Omission> kept;
  for (Omission& omission : omissions) {
    const auto same = [&](const Omission& other) { return other.what == omission.what; };
    if (std::count_if(kept.begin(), kept.end(), same) < static_cast<long>(kMostReasons))
      kept.push_back(std::move(omission));
    else
      for (const std::string& name : omission.names)
        note_omission(omission.what, "for reasons like these", name, kept);
  }
  return kept;
}

std::vector<std::string> omission_texts(const assembly::BuiltScene& built,
                                        const engine::Skips& skips,
                                        const std::string& no_pictures) {
  const engine::SimulationSpec& spec = built.spec;
  std::vector<std::string> texts;
  if (!spec.bodies.empty() && skips.water)
    texts.push_back(spec.sea ? "water (none of its loads acts on a body)"
                             : "water (there is none)");
  if (!spec.bodies.empty() && skips.collision) texts.push_back("collisions (nothing can collide)");
  if (!skips.water)
    for (const Omission& omission : readable(body_omissions(built)))
      texts.push_back(fmt::format("{} of {} ({})", omission.what,
                                  named_bodies(omission.names, spec.bodies.size()),
                                  omission.reason));
  if (!no_pictures.empty()) texts.push_back("pictures (" + no_pictures + ")");
  return texts;
}

}  // namespace

std::vector<std::string> resolved_scene(const scene::Scene& scene,
                                        const assembly::BuiltScene& built,
                                        const engine::Skips& skips,
                                        const std::string& no_pictures) {
  std::vector<std::string> lines = {headline(scene, built)};
  const auto add = [&](const std::vector<std::string>& more) {
    lines.insert(lines.end(), more.begin(), more.end());
  };
  const BodyTables tables(scene, built);
  add(tables.sizes());
  add(tables.hollows());
  add(tables.added_mass());
  const std::vector<std::string> radiation = tables.radiation();
  add(radiation);
  if (!radiation.empty())
    lines.push_back(fmt::format("  assumed: {}",
                                fmt::join(assembly::assumptions({.depth = built.spec.sea->depth},
                                                                built.spec.water.has_value()),
                                          ", ")));
  add(tables.resistance());
  const std::string surfaces = contact_text(built.spec);
  if (!surfaces.empty()) lines.push_back("  contacts: " + surfaces);
  add(resolved_rig(scene, built));
  const std::vector<std::string> omitted = omission_texts(built, skips, no_pictures);
  if (!omitted.empty())
    lines.push_back(fmt::format("  not computed: {}", fmt::join(omitted, "; ")));
  return lines;
}

}  // namespace app
