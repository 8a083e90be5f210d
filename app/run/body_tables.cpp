#include "app/run/body_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>

#include "app/assembly/build_start.h"
#include "app/base/console.h"
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

Cells body_row(const engine::BodySpec& body, bool afloat) {
  const double volume = hydro::solid_properties(body.mesh_B).volume;
  return {std::to_string(body.mesh_B.face_count()), size_of(body.mesh_B), number_text(volume, 4),
          number_text(body.mass, 5), afloat ? "afloat" : "given"};
}

Cells added_mass_row(const assembly::AddedMassReport& report) {
  Cells row = {source_of(report)};
  for (int i = 0; i < 6; ++i) row.push_back(number_text(report.matrix(i, i), 3));
  return row;
}

Cells radiation_row(const assembly::RadiationReport& report) {
  if (!report.model) return {};
  if (report.choice.simulated)
    return {"simulated water", "", number_text(report.choice.draught, 3), "", ""};
  const hydro::RadiationMemory& memory = report.model->memory();
  const auto& database = report.choice.database;
  return {database                    ? database->file.filename().string()
          : report.stored->from_store ? "from store"
                                      : "solved now",
          std::to_string(report.model->data().frequencies.size()),
          number_text(report.choice.draught, 3), std::to_string(memory.size()),
          number_text(100 * memory.rms_error.maxCoeff(), 2)};
}

/// Describes the resistance of a body along its motion.
Cells resistance_row(const engine::BodySpec& body, const assembly::ResistanceReport& report) {
  if (!body.resistance) return {};
  const std::vector<double>& speeds = body.resistance->curve.speeds();
  const std::vector<double>& forces = body.resistance->curve.forces();
  const auto largest = std::ranges::max_element(forces);
  return {!report.ship        ? "file"
          : report.from_store ? "Michell, from store"
                              : "Michell, solved now",
          number_text(speeds.back(), 3), number_text(*largest, 3),
          number_text(speeds[static_cast<std::size_t>(largest - forces.begin())], 3)};
}

/// Describes the pockets of a body at its start.
Cells hollow_row(const engine::BodySpec& body, double level) {
  if (body.interior == engine::Interior::wet || !body.closed_mesh_B) return {};
  const Eigen::Vector3d up_B = body.initial.orientation.toRotationMatrix().row(2);
  const auto interior = engine::pockets_at(body, up_B);
  if (!interior) return {};
  const hydro::Pockets& found = interior->division;
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
          std::to_string(body.openings.size()),
          std::to_string(body.pumps.size())};
}

std::string word_of(const std::string& name, assembly::SaidBy who) {
  return who == assembly::SaidBy::file ? name + " (file)" : name;
}

/// Describes the mesh files of a body whose axes or units are changed, one after the other.
Cells source_cells(const std::vector<assembly::MeshSource>& sources) {
  Cells cells;
  for (const assembly::MeshSource& source : sources) {
    const assembly::AppliedFrame& frame = source.frame;
    if (frame.changes_nothing()) continue;
    cells.insert(
        cells.end(),
        {source.file.filename().string(), word_of(scene::name_of(frame.up), frame.up_by),
         word_of(scene::name_of_unit(frame.unit), frame.unit_by), number_text(frame.scale, 3)});
  }
  return cells;
}

/// Describes the mesh files that were mended: file, volumes, changes.
Cells mended_cells(const std::vector<assembly::MeshSource>& sources) {
  Cells cells;
  for (const assembly::MeshSource& source : sources) {
    if (!source.mended) continue;
    const assembly::MendingRecord& record = *source.mended;
    std::string changes;
    for (const std::string& change : record.changes)
      changes += (changes.empty() ? "" : "; ") + change;
    cells.insert(cells.end(),
                 {source.file.filename().string(),
                  record.volume_before ? number_text(*record.volume_before, 4) : "open",
                  number_text(record.volume_after, 4),
                  changes.empty() ? "nothing had to be changed" : changes});
  }
  return cells;
}

}  // namespace

/// Bodies whose descriptions differ only in their positions.
struct BodyTables::Kind {
  Cells body;        ///< Triangles, size, volume, mass, start.
  Cells added_mass;  ///< Source and diagonal; empty without added mass.
  Cells radiation;   ///< Source and size; empty without radiation.
  Cells resistance;  ///< Source, range and largest force; empty without a resistance.
  Cells hollows;     ///< Number, volume, rim and water; empty without pockets.
  Cells meshes;      ///< Four cells per mesh file whose coordinates are changed.
  Cells mended;      ///< Four cells per mesh file that was mended.
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

BodyTables::BodyTables(const scene::Scene& scene, const assembly::BuiltScene& built)
    : water_(scene.water.has_value()) {
  std::map<std::array<Cells, 7>, std::size_t> known;
  const double level = scene.water ? scene.water->level : 0;
  const std::vector<bool> afloat = assembly::starts_afloat(scene, built.spec);
  for (std::size_t i = 0; i < built.spec.bodies.size(); ++i) {
    const engine::BodySpec& body = built.spec.bodies[i];
    const Cells row = body_row(body, afloat[i]);
    const Cells added_mass = built.added_mass[i] ? added_mass_row(*built.added_mass[i]) : Cells();
    const Cells radiation = radiation_row(built.radiation[i]);
    const Cells resistance = resistance_row(body, built.resistance[i]);
    const Cells hollows = hollow_row(body, level);
    const Cells meshes = source_cells(built.mesh_sources[i]);
    const Cells mended = mended_cells(built.mesh_sources[i]);
    const auto [place, is_new] = known.emplace(
        std::array{row, added_mass, radiation, resistance, hollows, meshes, mended}, kinds_.size());
    if (is_new)
      kinds_.push_back({.body = row,
                        .added_mass = added_mass,
                        .radiation = radiation,
                        .resistance = resistance,
                        .hollows = hollows,
                        .meshes = meshes,
                        .mended = mended,
                        .names = {}});
    Kind& kind = kinds_[place->second];
    kind.names.push_back(body.name);
    const Spread height = height_of(body);
    kind.draught.add(level - height.least);
    kind.freeboard.add(height.largest - level);
    kind.triangles.add(static_cast<double>(body.mesh_B.face_count()));
    kind.mass.add(body.mass);
  }
  std::ranges::stable_sort(kinds_, std::ranges::greater(),
                           [](const Kind& kind) { return kind.names.size(); });
}

BodyTables::~BodyTables() = default;

std::size_t BodyTables::rows() const { return std::min(kinds_.size(), kMostKinds); }

/// Describes the kinds of bodies without rows.
std::string BodyTables::rest() const {
  std::size_t bodies = 0;
  Spread triangles, mass;
  for (std::size_t i = kMostKinds; i < kinds_.size(); ++i) {
    bodies += kinds_[i].names.size();
    triangles.add(kinds_[i].triangles);
    mass.add(kinds_[i].mass);
  }
  return fmt::format("  and {} of {}: {} triangles, {} kg", counted(bodies, "body", "bodies"),
                     counted(kinds_.size() - kMostKinds, "more kind", "more kinds"),
                     triangles.text(), mass.text());
}

std::vector<std::string> BodyTables::sizes() const {
  if (kinds_.empty()) return {};
  std::vector<Cells> table = {{"body", "triangles", "size m", "volume m^3", "mass kg", "start"}};
  if (water_) table.front().insert(table.front().end(), {"draught m", "freeboard m"});
  for (std::size_t i = 0; i < rows(); ++i) {
    const Kind& kind = kinds_[i];
    Cells& row = table.emplace_back(Cells{kind.title()});
    row.insert(row.end(), kind.body.begin(), kind.body.end());
    if (water_)
      row.insert(row.end(), {kind.draught.text_or("above"), kind.freeboard.text_or("below")});
  }
  std::vector<std::string> lines = aligned_lines(table);
  if (kinds_.size() > rows()) lines.push_back(rest());
  const std::vector<std::string> files = mesh_files();
  lines.insert(lines.end(), files.begin(), files.end());
  const std::vector<std::string> mended = mended_files();
  lines.insert(lines.end(), mended.begin(), mended.end());
  return lines;
}

/// Returns the table of the mesh files whose coordinates are turned or scaled.
std::vector<std::string> BodyTables::mesh_files() const {
  std::vector<Cells> table = {{"mesh files", "", "up", "unit", "scale"}};
  for (std::size_t i = 0; i < rows(); ++i) {
    const Cells& cells = kinds_[i].meshes;
    for (auto cell = cells.begin(); cell != cells.end(); cell += 4) {
      table.push_back({cell == cells.begin() ? kinds_[i].title() : ""});
      table.back().insert(table.back().end(), cell, cell + 4);
    }
  }
  return table.size() > 1 ? aligned_lines(table) : std::vector<std::string>();
}

/// Returns the table of the mesh files that were mended, and what was done to each.
std::vector<std::string> BodyTables::mended_files() const {
  std::vector<Cells> table = {{"mended meshes", "", "volume m^3 before", "after"}};
  std::vector<std::string> changes;
  for (std::size_t i = 0; i < rows(); ++i) {
    const Cells& cells = kinds_[i].mended;
    for (auto cell = cells.begin(); cell != cells.end(); cell += 4) {
      table.push_back({kinds_[i].title(), cell[0], cell[1], cell[2]});
      changes.push_back(fmt::format("    {}: {}", cell[0], cell[3]));
    }
  }
  if (table.size() == 1) return {};
  std::vector<std::string> lines = aligned_lines(table);
  lines.insert(lines.end(), changes.begin(), changes.end());
  return lines;
}

/// Returns the table of the kinds that have such a row.
std::vector<std::string> BodyTables::lines_of(Cells head, Cells Kind::*row) const {
  std::vector<Cells> table = {std::move(head)};
  for (std::size_t i = 0; i < rows(); ++i) {
    const Cells& cells = kinds_[i].*row;
    if (cells.empty()) continue;
    table.push_back({kinds_[i].title()});
    table.back().insert(table.back().end(), cells.begin(), cells.end());
  }
  return table.size() > 1 ? aligned_lines(table) : std::vector<std::string>();
}

std::vector<std::string> BodyTables::hollows() const {
  return lines_of({"hollows", "", "number", "volume m^3", "rim above water m", "water m^3",
                   "openings", "pumps"},
                  &Kind::hollows);
}

std::vector<std::string> BodyTables::added_mass() const {
  return lines_of({"added mass", "", "surge", "sway", "heave kg", "roll", "pitch", "yaw kg m^2"},
                  &Kind::added_mass);
}

std::vector<std::string> BodyTables::radiation() const {
  return lines_of({"radiation", "", "frequencies", "mean draught m", "oscillators", "fit error %"},
                  &Kind::radiation);
}

std::vector<std::string> BodyTables::resistance() const {
  return lines_of({"resistance", "", "up to m/s", "largest N", "at m/s"}, &Kind::resistance);
}

}  // namespace app
