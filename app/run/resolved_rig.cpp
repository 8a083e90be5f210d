#include "app/run/resolved_rig.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "app/assembly/build_rig.h"
#include "app/base/console.h"
#include "app/base/table.h"

namespace app {
namespace {

/// Most rows of a table beside its head.
constexpr std::size_t kMostRigRows = 6;

std::string three_digits(double value) {
  return std::abs(value) >= 1000 && std::abs(value) < 1e9 ? fmt::format("{:.0f}", value)
                                                          : fmt::format("{:.3g}", value);
}

std::string body_text(const engine::SimulationSpec& spec, engine::BodyId body) {
  return body == engine::kWorld ? "world" : spec.bodies[static_cast<std::size_t>(body)].name;
}

const char* kind_text(engine::LineSpec::Kind kind) {
  switch (kind) {
    case engine::LineSpec::Kind::spring:
      return "spring";
    case engine::LineSpec::Kind::rope:
      return "rope";
    case engine::LineSpec::Kind::mooring:
      break;
  }
  return "mooring";
}

/// Says between what a line runs, and into how many segments its inertia is divided.
std::string way_text(const engine::SimulationSpec& spec, const engine::LineSpec& line) {
  std::string text = body_text(spec, line.first.body) + " to ";
  text +=
      line.kind == engine::LineSpec::Kind::mooring ? "anchor" : body_text(spec, line.second.body);
  if (!line.inertia) return text;
  const auto segments = static_cast<std::size_t>(line.inertia->segments);
  return text + ", dynamic, " + counted(segments, "segment", "segments");
}

Cells line_row(const engine::SimulationSpec& spec, const engine::LineSpec& line) {
  const double span =
      (assembly::place_at_start(spec, line.second) - assembly::place_at_start(spec, line.first))
          .norm();
  const bool mooring = line.kind == engine::LineSpec::Kind::mooring;
  return {line.name,
          kind_text(line.kind),
          way_text(spec, line),
          three_digits(line.length),
          three_digits(span),
          three_digits(mooring ? line.stiffness / line.length : line.stiffness),
          three_digits(assembly::tension_at_start(spec, line))};
}

const char* model_text(const hydro::PropellerModel& model) {
  constexpr std::array<const char*, 3> names = {"wageningen", "open water", "four quadrants"};
  return names[model.index()];
}

/// Formats the value of a set point at the start, in the unit of its name.
std::string set_text(const engine::SimulationSpec& spec, engine::SetPointId id) {
  const engine::SetPointSpec& point = spec.set_points[static_cast<std::size_t>(id)];
  return fmt::format("{:.4g}", point.initial / point.unit);
}

Cells propeller_row(const engine::SimulationSpec& spec, const engine::PropellerSpec& propeller) {
  return {propeller.name,
          std::string("propeller, ") + model_text(propeller.screw.model),
          body_text(spec, propeller.body),
          three_digits(propeller.screw.diameter),
          set_text(spec, propeller.speed) + " 1/s",
          set_text(spec, propeller.azimuth)};
}

Cells foil_row(const engine::SimulationSpec& spec, const engine::FoilSpec& foil) {
  std::string kind = foil.fluid == engine::FoilSpec::Fluid::air ? "sail" : "rudder";
  if (foil.behind) kind += " behind " + spec.propellers[*foil.behind].name;
  return {foil.name,
          kind,
          body_text(spec, foil.body),
          fmt::format("{} x {}", three_digits(foil.foil.span), three_digits(foil.foil.chord)),
          "",
          set_text(spec, foil.angle)};
}

/// Says what a set point follows.
std::string source_text(const scene::Control& control) {
  if (const auto* file = std::get_if<scene::CommandFile>(&control.source))
    return file->file.filename().string();
  if (const auto* formula = std::get_if<std::string>(&control.source)) {
    constexpr std::size_t kLongest = 40;
    return formula->size() > kLongest ? formula->substr(0, kLongest) + "..." : *formula;
  }
  if (const auto* pid = std::get_if<scene::PidControl>(&control.source)) return "pid of " + pid->of;
  return "relay of " + std::get<scene::RelayControl>(control.source).of;
}

/// Adds the head and the first rows of a table, and counts the others.
void add_table(std::vector<Cells> rows, const char* one, const char* many,
               std::vector<std::string>& lines) {
  const std::size_t all = rows.size() - 1;
  if (all == 0) return;
  rows.resize(std::min(rows.size(), kMostRigRows + 1));
  for (std::string& line : aligned_lines(rows)) lines.push_back(std::move(line));
  if (all > kMostRigRows)
    lines.push_back(fmt::format("  and {}", counted(all - kMostRigRows, one, many)));
}

}  // namespace

std::vector<std::string> resolved_rig(const scene::Scene& scene,
                                      const assembly::BuiltScene& built) {
  const engine::SimulationSpec& spec = built.spec;
  std::vector<std::string> lines;
  std::vector<Cells> of_lines = {
      Cells{"line", "", "", "length m", "distance m", "stiffness N/m", "tension N"}};
  for (const engine::LineSpec& line : spec.lines) of_lines.push_back(line_row(spec, line));
  add_table(std::move(of_lines), "more line", "more lines", lines);

  std::vector<Cells> machines = {Cells{"machine", "", "body", "size m", "speed", "angle deg"}};
  for (const engine::PropellerSpec& propeller : spec.propellers)
    machines.push_back(propeller_row(spec, propeller));
  for (const engine::FoilSpec& foil : spec.foils) machines.push_back(foil_row(spec, foil));
  add_table(std::move(machines), "more machine", "more machines", lines);

  std::vector<Cells> controls = {Cells{"control", "by", "from s"}};
  for (const scene::Control& control : scene.controls)
    controls.push_back({control.set, source_text(control), fmt::format("{:g}", control.start)});
  add_table(std::move(controls), "more control", "more controls", lines);
  return lines;
}

}  // namespace app
