#include "app/pictures/drawn_rig.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace app {
namespace {

using Eigen::Vector3d;
using engine::LineSpec;

double tension_at_rest(const LineSpec& line, const Vector3d& first, const Vector3d& second) {
  const Vector3d chord = first - second;
  if (line.kind == LineSpec::Kind::mooring)
    return hydro::solve_catenary(catenary_of(line, line.length), chord.head<2>().norm(), chord.z(),
                                 line.on_bottom)
        .tension();
  const double tension = line.stiffness * (chord.norm() - line.length);
  return line.kind == LineSpec::Kind::rope ? std::max(tension, 0.0) : tension;
}

/// Moves a line, as it is at the end of a time, to a part of it from 0 to 1.
/// @param start   The line at the start of that time.
void move_back(const DrawnLine& start, double part, DrawnLine& line) {
  line.tension = std::lerp(start.tension, line.tension, part);
  line.length = std::lerp(start.length, line.length, part);
  if (start.nodes_W.size() != line.nodes_W.size()) line.nodes_W.clear();
  for (std::size_t i = 0; i < line.nodes_W.size(); ++i)
    line.nodes_W[i] = start.nodes_W[i] + part * (line.nodes_W[i] - start.nodes_W[i]);
}

}  // namespace

DrawnRig drawn_rig(const engine::RigReadings& readings) {
  DrawnRig rig;
  for (const engine::LineReading& line : readings.lines)
    rig.lines.push_back({.tension = line.tension,
                         .length = line.length,
                         .broken = line.broken,
                         .nodes_W = line.nodes_W});
  for (const engine::PropellerReading& propeller : readings.propellers)
    rig.propellers.push_back({.turn = propeller.turn, .azimuth = propeller.azimuth});
  for (const engine::FoilReading& foil : readings.foils) rig.foil_angles.push_back(foil.angle);
  return rig;
}

DrawnRig rig_at_rest(const engine::SimulationSpec& spec,
                     const std::vector<hydro::BodyState>& states, double time) {
  const auto initial = [&](engine::SetPointId id) {
    return spec.set_points.at(static_cast<std::size_t>(id)).initial;
  };
  DrawnRig rig;
  for (const LineSpec& line : spec.lines)
    rig.lines.push_back({.tension = tension_at_rest(line, place_of(line.first, states),
                                                    place_of(line.second, states)),
                         .length = line.length});
  for (const engine::PropellerSpec& propeller : spec.propellers)
    rig.propellers.push_back({.turn = 2 * M_PI * initial(propeller.speed) * time,
                              .azimuth = initial(propeller.azimuth)});
  for (const engine::FoilSpec& foil : spec.foils) rig.foil_angles.push_back(initial(foil.angle));
  return rig;
}

DrawnRig between(const DrawnRig& a, const DrawnRig& b, double part) {
  assert(a.lines.size() == b.lines.size() && a.propellers.size() == b.propellers.size() &&
         a.foil_angles.size() == b.foil_angles.size());
  DrawnRig rig = b;
  for (std::size_t i = 0; i < b.lines.size(); ++i) move_back(a.lines[i], part, rig.lines[i]);
  for (std::size_t i = 0; i < b.propellers.size(); ++i) {
    rig.propellers[i].turn = std::lerp(a.propellers[i].turn, b.propellers[i].turn, part);
    rig.propellers[i].azimuth = std::lerp(a.propellers[i].azimuth, b.propellers[i].azimuth, part);
  }
  for (std::size_t i = 0; i < b.foil_angles.size(); ++i)
    rig.foil_angles[i] = std::lerp(a.foil_angles[i], b.foil_angles[i], part);
  return rig;
}

Vector3d place_of(const engine::AttachmentPoint& point,
                  const std::vector<hydro::BodyState>& states) {
  if (point.body == engine::kWorld) return point.at;
  const hydro::BodyState& state = states[static_cast<std::size_t>(point.body)];
  return state.position + state.orientation * point.at;
}

hydro::CatenaryLine catenary_of(const LineSpec& line, double length) {
  return {.length = length,
          .weight = line.weight,
          .stiffness = line.stiffness,
          .friction = line.friction};
}

}  // namespace app
