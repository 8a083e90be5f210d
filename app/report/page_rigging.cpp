#include <algorithm>
#include <cmath>
#include <utility>

#include "app/logs/read_log.h"
#include "app/pages/packing.h"
#include "app/pages/thinning.h"
#include "app/pictures/rig_history.h"
#include "app/pictures/rigging.h"
#include "app/report/page_data.h"

namespace app {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using Json = nlohmann::ordered_json;

/// Points of a line that is not straight, with its ends.
constexpr Index kShapePoints = 24;

/// Fewer rows would not show a motion.
constexpr std::size_t kLeastRigRows = 16;

Json numbers(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// The instants that the page has.
struct Instants {
  std::vector<double> times;
  std::vector<std::vector<hydro::BodyState>> states;
  std::vector<DrawnRig> rigs;
};

Instants instants_of(const LoggedRun& run, const PageLimits& limits) {
  const engine::SimulationSpec& spec = run.built.spec;
  const std::size_t a_row =
      spec.lines.size() * (3 * kShapePoints) + 2 * spec.propellers.size() + spec.foils.size() + 1;
  const RigHistory history(spec, trajectory_of(run.path));
  Instants instants;
  for (const std::size_t row :
       spread_rows(run.rows, std::max(kLeastRigRows, limits.rigging / a_row))) {
    const double time = run.trajectory.tracks.begin()->second.times[row];
    std::vector<hydro::BodyState> states;
    for (const engine::BodySpec& body : spec.bodies)
      states.push_back(run.trajectory.tracks.at(body.name).states[row]);
    instants.times.push_back(time);
    instants.rigs.push_back(history.at(time, states));
    instants.states.push_back(std::move(states));
  }
  return instants;
}

/// Collects a number of each instant.
template <class Value>
std::vector<double> over_time(const Instants& instants, Value&& value) {
  std::vector<double> column;
  for (const DrawnRig& rig : instants.rigs) column.push_back(value(rig));
  return column;
}

/// Returns `kShapePoints` points of a polyline at equal distances along it.
Eigen::Matrix3Xd evenly(const Eigen::Matrix3Xd& points) {
  Eigen::VectorXd reached = Eigen::VectorXd::Zero(points.cols());
  for (Index i = 1; i < points.cols(); ++i)
    reached[i] = reached[i - 1] + (points.col(i) - points.col(i - 1)).norm();
  Eigen::Matrix3Xd even(3, kShapePoints);
  Index next = 1;
  for (Index k = 0; k < kShapePoints; ++k) {
    const double wanted = reached[reached.size() - 1] * static_cast<double>(k) / (kShapePoints - 1);
    while (next + 1 < points.cols() && reached[next] < wanted) ++next;
    const double step = reached[next] - reached[next - 1];
    const double part = step > 0 ? std::clamp((wanted - reached[next - 1]) / step, 0.0, 1.0) : 0;
    even.col(k) = points.col(next - 1) + part * (points.col(next) - points.col(next - 1));
  }
  return even;
}

/// Returns how far the inner points of a line lie from those of its chord, over all instants; null
/// if it is always straight.
Json shapes_of(const engine::SimulationSpec& spec, std::size_t line, const Instants& instants,
               const GroundHeight& ground) {
  const double radius = line_radius(spec, spec.lines[line]);
  std::vector<float> off;
  bool bent = false;
  for (std::size_t i = 0; i < instants.times.size(); ++i) {
    const Eigen::Matrix3Xd points = shape_of(spec.lines[line], instants.rigs[i].lines[line],
                                             instants.states[i], ground, radius);
    bent = bent || points.cols() > 2;
    const Eigen::Matrix3Xd even = evenly(points);
    const Vector3d first = points.leftCols<1>(), chord = points.rightCols<1>() - first;
    for (Index k = 1; k + 1 < kShapePoints; ++k) {
      const Vector3d d = even.col(k) - first - static_cast<double>(k) / (kShapePoints - 1) * chord;
      for (const double number : d) off.push_back(static_cast<float>(number));
    }
  }
  return bent ? Json(packed<float>(off)) : Json(nullptr);
}

/// Returns the places of `kShapePoints` points of a line with inertia at each instant; null if its
/// nodes are known at none. A line that breaks keeps the places of the instant before.
Json path_of(const engine::SimulationSpec& spec, std::size_t line, const Instants& instants,
             const Vector3d& origin, const GroundHeight& ground) {
  if (!spec.lines[line].inertia) return nullptr;
  const double radius = line_radius(spec, spec.lines[line]);
  std::vector<float> path;
  Eigen::Matrix3Xf even;
  bool known = false;
  for (std::size_t i = 0; i < instants.times.size(); ++i) {
    const DrawnLine& now = instants.rigs[i].lines[line];
    known = known || !now.nodes_W.empty();
    if (i == 0 || !now.broken) {
      const Eigen::Matrix3Xd points =
          shape_of(spec.lines[line], now, instants.states[i], ground, radius);
      even = (evenly(points).colwise() - origin).cast<float>();
    }
    path.insert(path.end(), even.data(), even.data() + even.size());
  }
  return known ? Json(packed<float>(path)) : Json(nullptr);
}

Json end_of(const engine::AttachmentPoint& end, const Vector3d& origin) {
  const bool fixed = end.body == engine::kWorld;
  return {{"body", end.body}, {"at", numbers(fixed ? Vector3d(end.at - origin) : end.at)}};
}

Json page_line(const engine::SimulationSpec& spec, std::size_t index, const Instants& instants,
               const Vector3d& origin, const GroundHeight& ground) {
  const engine::LineSpec& line = spec.lines[index];
  Json page = {
      {"name", line.name},
      {"ends", {end_of(line.first, origin), end_of(line.second, origin)}},
      {"hanging", broken_length(spec, line)},
      {"tension", packed_column(over_time(
                      instants, [&](const DrawnRig& rig) { return rig.lines[index].tension; }))},
      {"broken", packed_column(over_time(instants, [&](const DrawnRig& rig) {
         return rig.lines[index].broken ? 1.0 : 0.0;
       }))}};
  if (Json path = path_of(spec, index, instants, origin, ground); !path.is_null())
    page["path"] = std::move(path);
  else
    page["shape"] = shapes_of(spec, index, instants, ground);
  if (line.kind == engine::LineSpec::Kind::spring) {
    const Coil coil = coil_of(spec, line);
    page["coil"] = {{"radius", coil.radius}, {"turns", coil.turns}};
  }
  return page;
}

/// The turns of a part about its place, the last one first.
Json page_turns(const engine::SimulationSpec& spec, const RigPart& part, const Instants& instants) {
  Json turns = Json::array();
  const auto add = [&](const Vector3d& axis, const std::vector<double>& angles) {
    turns.push_back({{"axis", numbers(axis)}, {"angle", packed_column(angles)}});
  };
  if (part.kind == RigPart::Kind::propeller) {
    const engine::PropellerSpec& propeller = spec.propellers[part.index];
    const double sign = propeller.right_handed ? 1 : -1;
    add(propeller.pivot_B, over_time(instants, [&](const DrawnRig& rig) {
          return rig.propellers[part.index].azimuth;
        }));
    add(propeller.axis_B, over_time(instants, [&](const DrawnRig& rig) {
          return sign * rig.propellers[part.index].turn;
        }));
  }
  if (part.kind == RigPart::Kind::foil)
    add(-spec.foils[part.index].span_B,
        over_time(instants, [&](const DrawnRig& rig) { return rig.foil_angles[part.index]; }));
  return turns;
}

Json page_part(const engine::SimulationSpec& spec, const RigPart& part, const Instants& instants,
               const Vector3d& origin) {
  const Eigen::Matrix3Xf vertices = (part.X_BP.linear() * part.mesh_P->vertices).cast<float>();
  const Eigen::Matrix3Xi& faces = part.mesh_P->faces;
  const Vector3d at = part.X_BP.translation();
  return {
      {"body", part.body},
      {"at", numbers(part.body == engine::kWorld ? Vector3d(at - origin) : at)},
      {"color", numbers(part.color)},
      {"turns", page_turns(spec, part, instants)},
      {"mesh",
       {{"vertices", packed<float>({vertices.data(), static_cast<std::size_t>(vertices.size())})},
        {"triangles",
         packed<std::int32_t>({faces.data(), static_cast<std::size_t>(faces.size())})}}}};
}

/// The scale of tensions: its upper end, evenly spaced colours up to it, and that of a push.
Json page_tensions(const engine::SimulationSpec& spec, const Instants& instants) {
  RigPictures pictures(spec, false);
  for (const DrawnRig& rig : instants.rigs) {
    Shot shot;
    shot.rig = rig;
    pictures.include(shot);
  }
  Json colors = Json::array();
  for (const double share : {0.0, 1.0 / 3, 2.0 / 3, 1.0})
    colors.push_back(numbers(tension_color(share)));
  return {{"top", pictures.scale_top()},
          {"pushes", pictures.pushes()},
          {"colors", colors},
          {"push", numbers(tension_color(-1))}};
}

}  // namespace

Json page_rigging(const LoggedRun& run, const Vector3d& origin, const PageLimits& limits) {
  const engine::SimulationSpec& spec = run.built.spec;
  const bool joints = run.scene.render && run.scene.render->show.joints;
  const std::vector<RigPart> rig = rig_parts(spec, joints);
  if (spec.lines.empty() && rig.empty()) return nullptr;
  const Instants instants = instants_of(run, limits);
  const GroundHeight ground(spec.ground);
  Json lines = Json::array(), parts = Json::array();
  for (std::size_t i = 0; i < spec.lines.size(); ++i)
    lines.push_back(page_line(spec, i, instants, origin, ground));
  for (const RigPart& part : rig) parts.push_back(page_part(spec, part, instants, origin));
  return {{"times", packed<double>(instants.times)},
          {"points", kShapePoints},
          {"tensions", page_tensions(spec, instants)},
          {"lines", lines},
          {"parts", parts}};
}

}  // namespace app
