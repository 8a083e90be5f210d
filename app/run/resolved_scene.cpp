#include "app/run/resolved_scene.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <span>

#include "app/assembly/build_radiation.h"
#include "app/base/console.h"
#include "app/base/table.h"
#include "app/run/contact_text.h"
#include "app/run/resolved_rig.h"
#include "app/run/summary.h"
#include "engine/locks.h"
#include "hydro/interior/pockets.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/mesh.h"

namespace app {
namespace {

/// Largest number of kinds of bodies that have rows.
constexpr std::size_t kMostKinds = 3;

/// Formats a number with `digits` significant digits and all digits before the point, without an
/// exponent unless the number is very large or small.
std::string number_text(double value, int digits) {
  constexpr double kLongest = 1e9;
  const bool fits = std::abs(value) < kLongest && std::abs(value) >= std::pow(10, digits);
  return fits ? fmt::format("{:.0f}", value) : fmt::format("{:.{}g}", value, digits);
}

/// Least and largest value of a quantity over several bodies.
struct Spread {
  double least = std::numeric_limits<double>::infinity();
  double largest = -std::numeric_limits<double>::infinity();

  void add(double value) {
    least = std::min(least, value);
    largest = std::max(largest, value);
  }
  void add(const Spread& range) {
    add(range.least);
    add(range.largest);
  }
  std::string text() const {
    const std::string from = number_text(least, 3), to = number_text(largest, 3);
    return from == to ? from : from + " to " + to;
  }
  /// Formats a range of heights; if all are negative, as distances on the other side.
  std::string text_or(const char* other_side) const {
    if (largest >= 0) return text();
    return fmt::format("{} {}", Spread{-largest, -least}.text(), other_side);
  }
};

/// Returns the lowest and highest z of a body in its initial pose.
Spread height_of(const engine::BodySpec& body) {
  const Eigen::RowVector3d up = body.initial.orientation.toRotationMatrix().row(2);
  Spread range;
  for (const auto& vertex : body.mesh_B.vertices.colwise())
    range.add(body.initial.position.z() + up * vertex);
  return range;
}

std::string size_of(const hydro::TriMesh& mesh) {
  const Eigen::Vector3d size = hydro::bounding_box(mesh).sizes();
  return fmt::format("{} x {} x {}", number_text(size[0], 3), number_text(size[1], 3),
                     number_text(size[2], 3));
}

/// Names the origin of a body's added mass.
std::string source_of(const assembly::AddedMassReport& report) {
  if (report.surface) return "surface";
  if (report.model == scene::AddedMass::Model::automatic) return "mean pose";
  if (!report.stored) return "given";
  return report.stored->from_store ? "deep, from store" : "deep, solved now";
}

/// Bodies whose descriptions differ only in their positions.
struct BodyKind {
  Cells body;        ///< Triangles, size, volume, mass, start.
  Cells added_mass;  ///< Source and diagonal; empty without added mass.
  Cells radiation;   ///< Source and size; empty without radiation.
  Cells hollows;     ///< Number, volume, rim and water; empty without pockets.
  std::vector<std::string> names;
  Spread draught;    ///< Depth of the lowest point below the still water [m].
  Spread freeboard;  ///< Height of the highest point above it [m].
  Spread triangles;
  Spread mass;  ///< [kg]

  /// Returns a body's name and the number of bodies like it.
  std::string title() const {
    return names.size() == 1 ? names.front()
                             : fmt::format("{} like {}", names.size(), names.front());
  }
};

Cells body_row(const scene::Body& scene, const engine::BodySpec& body) {
  const double volume = hydro::solid_properties(body.mesh_B).volume;
  return {std::to_string(body.mesh_B.face_count()), size_of(body.mesh_B), number_text(volume, 4),
          number_text(body.mass, 5), scene.start == scene::Start::equilibrium ? "afloat" : "given"};
}

/// True if the simulation uses a body's added mass, which the method `ode` ignores.
bool has_added_mass(const assembly::BuiltScene& built, std::size_t body) {
  return built.spec.integrator.method != engine::Integrator::Method::ode &&
         built.added_mass[body].has_value();
}

Cells added_mass_row(const assembly::AddedMassReport& report) {
  Cells row = {source_of(report)};
  for (int i = 0; i < 6; ++i) row.push_back(number_text(report.matrix(i, i), 3));
  return row;
}

Cells radiation_row(const assembly::RadiationReport& report) {
  if (!report.model) return {};
  const hydro::RadiationMemory& memory = report.model->memory();
  const auto& database = report.choice.database;
  return {database                    ? database->file.filename().string()
          : report.stored->from_store ? "from store"
                                      : "solved now",
          std::to_string(report.model->data().frequencies.size()),
          number_text(report.choice.draught, 3), std::to_string(memory.size()),
          number_text(100 * memory.rms_error.maxCoeff(), 2)};
}

/// Describes the pockets of a body at its start.
Cells hollow_row(const engine::BodySpec& body, double level) {
  if (body.interior == engine::Interior::wet || !body.closed_mesh_B) return {};
  const Eigen::Vector3d up_B = body.initial.orientation.toRotationMatrix().row(2);
  const hydro::Pockets found = hydro::find_pockets(body.mesh_B, up_B);
  double capacity = 0, rim = std::numeric_limits<double>::infinity(), water = 0;
  for (const hydro::Pocket& pocket : found.pockets) capacity += pocket.capacity;
  for (const hydro::SillEdge& edge : found.sills)
    for (const int v : {edge.from, edge.to})
      if (edge.other == hydro::kSea)
        rim = std::min(rim, body.initial.position.z() + up_B.dot(body.mesh_B.vertices.col(v)));
  for (const engine::WaterAtStart& inside : body.interior_water) water += inside.volume;
  return {body.interior == engine::Interior::dry ? "stay dry" : "may flood",
          std::to_string(found.pockets.size()),
          number_text(capacity, 4),
          std::isfinite(rim) ? number_text(rim - level, 3) : "closed",
          number_text(water, 4),
          std::to_string(body.openings.size())};
}

/// Returns the kinds of bodies, the most frequent first.
std::vector<BodyKind> kinds_of(const scene::Scene& scene, const assembly::BuiltScene& built) {
  std::vector<BodyKind> kinds;
  std::map<std::array<Cells, 4>, std::size_t> known;
  const double level = scene.water ? scene.water->level : 0;
  for (std::size_t i = 0; i < built.spec.bodies.size(); ++i) {
    const engine::BodySpec& body = built.spec.bodies[i];
    const Cells row = body_row(scene.bodies[i], body);
    const Cells added_mass =
        has_added_mass(built, i) ? added_mass_row(*built.added_mass[i]) : Cells();
    const Cells radiation = radiation_row(built.radiation[i]);
    const Cells hollows = hollow_row(body, level);
    const auto [place, is_new] =
        known.emplace(std::array{row, added_mass, radiation, hollows}, kinds.size());
    if (is_new)
      kinds.push_back({.body = row,
                       .added_mass = added_mass,
                       .radiation = radiation,
                       .hollows = hollows,
                       .names = {}});
    BodyKind& kind = kinds[place->second];
    kind.names.push_back(body.name);
    const Spread height = height_of(body);
    kind.draught.add(level - height.least);
    kind.freeboard.add(height.largest - level);
    kind.triangles.add(static_cast<double>(body.mesh_B.face_count()));
    kind.mass.add(body.mass);
  }
  std::stable_sort(kinds.begin(), kinds.end(), [](const BodyKind& a, const BodyKind& b) {
    return a.names.size() > b.names.size();
  });
  return kinds;
}

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
  return fmt::format("water of {:g} kg/m^3 ({}{})", water.density, surface_text(water, built),
                     depth);
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
  const std::size_t lines = spec.lines.size() + (spec.moordyn ? spec.moordyn->lines.size() : 0);
  if (lines > 0) text += ", " + counted(lines, "line", "lines");
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
                                     const engine::BodySpec& body) {
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
      note_omission(load, "switched off", body.name, omissions);
    if (!has_added_mass(built, i))
      note_omission("added mass", reason_for_no_added_mass(spec, body), body.name, omissions);
    else if (!built.radiation[i].model && !built.radiation[i].choice.reason.empty())
      note_omission("radiation", built.radiation[i].choice.reason, body.name, omissions);
  }
  return omissions;
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
    for (const Omission& omission : body_omissions(built))
      texts.push_back(fmt::format("{} of {} ({})", omission.what,
                                  named_bodies(omission.names, spec.bodies.size()),
                                  omission.reason));
  if (!no_pictures.empty()) texts.push_back("pictures (" + no_pictures + ")");
  return texts;
}

/// Describes the kinds of bodies without rows.
std::string rest_of(const std::vector<BodyKind>& kinds) {
  std::size_t bodies = 0;
  Spread triangles, mass;
  for (std::size_t i = kMostKinds; i < kinds.size(); ++i) {
    bodies += kinds[i].names.size();
    triangles.add(kinds[i].triangles);
    mass.add(kinds[i].mass);
  }
  return fmt::format("  and {} of {}: {} triangles, {} kg", counted(bodies, "body", "bodies"),
                     counted(kinds.size() - kMostKinds, "more kind", "more kinds"),
                     triangles.text(), mass.text());
}

template <class T>
void append_cells(std::vector<T>& target, const std::vector<T>& more) {
  target.insert(target.end(), more.begin(), more.end());
}

std::vector<Cells> body_table(std::span<const BodyKind> kinds, bool water) {
  std::vector<Cells> rows = {{"body", "triangles", "size m", "volume m^3", "mass kg", "start"}};
  if (water) append_cells(rows.front(), {"draught m", "freeboard m"});
  for (const BodyKind& kind : kinds) {
    rows.push_back({kind.title()});
    append_cells(rows.back(), kind.body);
    if (water)
      append_cells(rows.back(), {kind.draught.text_or("above"), kind.freeboard.text_or("below")});
  }
  return rows;
}

/// Returns the rows of the kinds that have added mass.
std::vector<Cells> added_mass_table(std::span<const BodyKind> kinds) {
  std::vector<Cells> rows = {
      {"added mass", "", "surge", "sway", "heave kg", "roll", "pitch", "yaw kg m^2"}};
  for (const BodyKind& kind : kinds) {
    if (kind.added_mass.empty()) continue;
    rows.push_back({kind.title()});
    append_cells(rows.back(), kind.added_mass);
  }
  return rows;
}

/// Returns the rows of the kinds that make waves.
std::vector<Cells> radiation_table(std::span<const BodyKind> kinds) {
  std::vector<Cells> rows = {
      {"radiation", "", "frequencies", "mean draught m", "oscillators", "fit error %"}};
  for (const BodyKind& kind : kinds) {
    if (kind.radiation.empty()) continue;
    rows.push_back({kind.title()});
    append_cells(rows.back(), kind.radiation);
  }
  return rows;
}

/// Returns the rows of the kinds that are hollow.
std::vector<Cells> hollow_table(std::span<const BodyKind> kinds) {
  std::vector<Cells> rows = {
      {"hollows", "", "number", "volume m^3", "rim above water m", "water m^3", "openings"}};
  for (const BodyKind& kind : kinds) {
    if (kind.hollows.empty()) continue;
    rows.push_back({kind.title()});
    append_cells(rows.back(), kind.hollows);
  }
  return rows;
}

/// Returns the kinds of bodies that have a row.
std::span<const BodyKind> shown_of(const std::vector<BodyKind>& kinds) {
  return std::span(kinds).first(std::min(kinds.size(), kMostKinds));
}

/// Returns the table of meshes, sizes and masses.
std::vector<std::string> size_lines(const scene::Scene& scene, const std::vector<BodyKind>& kinds) {
  std::vector<std::string> lines;
  if (kinds.empty()) return lines;
  append_cells(lines, aligned_lines(body_table(shown_of(kinds), scene.water.has_value())));
  if (kinds.size() > kMostKinds) lines.push_back(rest_of(kinds));
  return lines;
}

}  // namespace

std::vector<std::string> body_sizes(const scene::Scene& scene, const assembly::BuiltScene& built) {
  return size_lines(scene, kinds_of(scene, built));
}

std::vector<std::string> resolved_scene(const scene::Scene& scene,
                                        const assembly::BuiltScene& built,
                                        const engine::Skips& skips,
                                        const std::string& no_pictures) {
  std::vector<std::string> lines = {headline(scene, built)};
  const std::vector<BodyKind> kinds = kinds_of(scene, built);
  append_cells(lines, size_lines(scene, kinds));
  const std::span shown = shown_of(kinds);
  const std::vector<Cells> hollows = hollow_table(shown);
  if (hollows.size() > 1) append_cells(lines, aligned_lines(hollows));
  const std::vector<Cells> added_mass = added_mass_table(shown);
  if (added_mass.size() > 1) append_cells(lines, aligned_lines(added_mass));
  const std::vector<Cells> radiation = radiation_table(shown);
  if (radiation.size() > 1) {
    append_cells(lines, aligned_lines(radiation));
    lines.push_back(fmt::format(
        "  assumed: {}", fmt::join(assembly::assumptions({.depth = built.spec.sea->depth}), ", ")));
  }
  const std::string surfaces = contact_text(built.spec);
  if (!surfaces.empty()) lines.push_back("  contacts: " + surfaces);
  append_cells(lines, resolved_rig(scene, built));
  const std::vector<std::string> omitted = omission_texts(built, skips, no_pictures);
  if (!omitted.empty())
    lines.push_back(fmt::format("  not computed: {}", fmt::join(omitted, "; ")));
  return lines;
}

}  // namespace app
