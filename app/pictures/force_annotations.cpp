#include "app/pictures/force_annotations.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "hydro/statics/hydrostatics.h"

namespace app {
namespace {

using Eigen::Vector3d;
using render::Rgb;

/// Length of the longest arrow as a fraction of the picture's height.
constexpr double kLongest = 0.2;

/// Smallest force that is drawn, as a fraction of the largest.
constexpr double kShortest = 2e-3;

const char* const kBuoyancy = "buoyancy";

struct NamedForce {
  std::string name;
  Rgb color;
  hydro::Wrench wrench;  ///< About the centre of mass, W.
};

std::array<NamedForce, 7> forces_on(const engine::BodySpec& body, const hydro::Hull& hull,
                                    const engine::SimulationSpec& spec,
                                    const hydro::BodyState& state, double time) {
  hydro::Loads loads;
  if (spec.sea && body.wet)
    loads = hydro::compute_loads(hull, state, *spec.sea, time, body.coefficients, body.summation);
  if (spec.sea && body.resistance)
    loads.resistance =
        hydro::resistance_load(*body.resistance, state, spec.sea->current, loads.displaced_volume);
  return {{{"weight", {70, 70, 75}, {.force = {0, 0, -body.mass * spec.gravity}}},
           {kBuoyancy, {20, 90, 200}, loads.buoyancy},
           {"pressure drag", {200, 30, 40}, loads.pressure_drag},
           {"viscous drag", {235, 125, 0}, loads.viscous_drag},
           {"lift", {20, 140, 60}, loads.lift},
           {"wind", {0, 150, 170}, loads.wind},
           {"resistance", {60, 110, 80}, loads.resistance}}};
}

/// Returns the point on the line of action of a force that is nearest to the centre of mass.
Vector3d point_on_line(const hydro::Wrench& wrench) {
  return wrench.force.cross(wrench.moment) / wrench.force.squaredNorm();
}

/// Returns the largest of 1, 2, 5 times a power of ten that is at most `value`.
double round_down(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double factor : {5.0, 2.0})
    if (value >= factor * power) return factor * power;
  return power;
}

}  // namespace

std::string force_text(double newtons) {
  if (newtons >= 1e6) return fmt::format("{:g} MN", newtons / 1e6);
  if (newtons >= 1e3) return fmt::format("{:g} kN", newtons / 1e3);
  return fmt::format("{:g} N", newtons);
}

ForceAnnotations::ForceAnnotations(const scene::Render& look, const engine::SimulationSpec& spec)
    : look_(look), spec_(spec) {
  if (!look.show.forces) return;
  for (const engine::BodySpec& body : spec.bodies)
    hulls_.push_back(hydro::make_hull(engine::outside_B(body)));
}

void ForceAnnotations::include(const Shot& shot) {
  for (std::size_t i = 0; i < hulls_.size(); ++i)
    for (const NamedForce& force :
         forces_on(spec_.bodies[i], hulls_[i], spec_, shot.states[i], shot.time)) {
      if (force.wrench.force.isZero(0)) continue;
      largest_ = std::max(largest_, force.wrench.force.norm());
      if (std::ranges::find(legend_, force.name, &render::LegendLine::name) == legend_.end())
        legend_.push_back({force.name, force.color});
    }
}

render::Annotations ForceAnnotations::of(const Shot& shot, double picture_size) const {
  render::Annotations notes;
  const double scale = largest_ > 0 ? kLongest * picture_size / largest_ : 0;
  for (std::size_t i = 0; i < spec_.bodies.size(); ++i) {
    if (scale > 0) add_forces(i, shot, scale, notes);
    if (look_.show.centres) add_centres(i, shot, notes);
  }
  if (scale > 0) {
    const double shown = round_down(0.5 * largest_);
    notes.scale_length = scale * shown;
    notes.scale_name = force_text(shown);
    notes.legend = legend_;
  }
  return notes;
}

void ForceAnnotations::add_forces(std::size_t body, const Shot& shot, double scale,
                                  render::Annotations& notes) const {
  const hydro::BodyState& state = shot.states[body];
  for (const NamedForce& force :
       forces_on(spec_.bodies[body], hulls_[body], spec_, state, shot.time)) {
    if (force.wrench.force.norm() < kShortest * largest_) continue;
    const auto centre = force.name == kBuoyancy
                            ? centre_of_buoyancy(engine::outside_B(spec_.bodies[body]), state,
                                                 *spec_.sea, shot.time)
                            : std::nullopt;
    const Vector3d from = centre ? *centre : state.position + point_on_line(force.wrench);
    notes.arrows.push_back({from, from + scale * force.wrench.force, force.color});
  }
}

void ForceAnnotations::add_centres(std::size_t body, const Shot& shot,
                                   render::Annotations& notes) const {
  const hydro::BodyState& state = shot.states[body];
  const auto letter = [&](const char* text) { return look_.overlay ? text : ""; };
  notes.marks.push_back({state.position, letter("G"), {30, 30, 35}});
  if (!spec_.sea) return;
  const auto centre =
      centre_of_buoyancy(engine::outside_B(spec_.bodies[body]), state, *spec_.sea, shot.time);
  if (centre) notes.marks.push_back({*centre, letter("B"), {20, 90, 200}, true});
}

std::optional<Vector3d> centre_of_buoyancy(const hydro::TriMesh& mesh_B,
                                           const hydro::BodyState& state, const hydro::Sea& sea,
                                           double time) {
  const hydro::TriMesh mesh_G = {state.orientation.toRotationMatrix() * mesh_B.vertices,
                                 mesh_B.faces};
  const Eigen::Matrix3Xd p_W = mesh_G.vertices.colwise() + state.position;
  Eigen::RowVectorXd depths(p_W.cols());
  for (Eigen::Index i = 0; i < p_W.cols(); ++i)
    depths[i] = hydro::surface_height(sea, p_W(0, i), p_W(1, i), time) - p_W(2, i);
  const hydro::WetVolume wet = hydro::wet_volume(mesh_G, depths);
  if (wet.volume == 0) return std::nullopt;
  Vector3d centre = state.position;
  centre.head<2>() += wet.centre;
  centre.z() = hydro::surface_height(sea, centre.x(), centre.y(), time) - wet.depth;
  return centre;
}

}  // namespace app
