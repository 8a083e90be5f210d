#include "app/force_notes.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "hydro/clip.h"

namespace app {
namespace {

using Eigen::Vector3d;
using render::Rgb;

/// Longest arrow, as a part of the picture's height.
constexpr double kLongest = 0.2;

/// Shorter ones than this part of it are left out.
constexpr double kShortest = 2e-3;

const char* const kBuoyancy = "buoyancy";

struct NamedForce {
  std::string name;
  Rgb color;
  hydro::Wrench wrench;  ///< About the centre of mass, W.
};

std::array<NamedForce, 5> forces_on(const engine::BodySpec& body, const hydro::Hull& hull,
                                    const engine::SimulationSpec& spec,
                                    const hydro::BodyState& state, double time) {
  hydro::Loads loads;
  if (spec.sea && body.wet)
    loads = hydro::compute_loads(hull, state, *spec.sea, time, body.coefficients, body.summation);
  return {{{"weight", {70, 70, 75}, {.force = {0, 0, -body.mass * spec.gravity}}},
           {kBuoyancy, {20, 90, 200}, loads.buoyancy},
           {"pressure drag", {200, 30, 40}, loads.pressure_drag},
           {"viscous drag", {235, 125, 0}, loads.viscous_drag},
           {"lift", {20, 140, 60}, loads.lift}}};
}

/// The point nearest to the centre of mass on the line that a force acts along.
Vector3d point_on_line(const hydro::Wrench& wrench) {
  return wrench.force.cross(wrench.moment) / wrench.force.squaredNorm();
}

/// 1, 2 or 5 times a power of ten, not more than `value`.
double round_down(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double factor : {5.0, 2.0})
    if (value >= factor * power) return factor * power;
  return power;
}

std::string force_text(double newtons) {
  if (newtons >= 1e6) return fmt::format("{:g} MN", newtons / 1e6);
  if (newtons >= 1e3) return fmt::format("{:g} kN", newtons / 1e3);
  return fmt::format("{:g} N", newtons);
}

}  // namespace

ForceNotes::ForceNotes(const RenderScene& look, const engine::SimulationSpec& spec,
                       const std::vector<Shot>& shots, double picture_size)
    : look_(look), spec_(spec) {
  if (!look.show.forces) return;
  for (const engine::BodySpec& body : spec.bodies) hulls_.push_back(hydro::make_hull(body.mesh_B));
  double largest = 0;
  for (const Shot& shot : shots)
    for (std::size_t i = 0; i < hulls_.size(); ++i)
      for (const NamedForce& force :
           forces_on(spec.bodies[i], hulls_[i], spec, shot.states[i], shot.time)) {
        if (force.wrench.force.isZero(0)) continue;
        largest = std::max(largest, force.wrench.force.norm());
        if (std::ranges::find(legend_, force.name, &render::LegendLine::name) == legend_.end())
          legend_.push_back({force.name, force.color});
      }
  if (largest == 0) return;
  length_per_force_ = kLongest * picture_size / largest;
  shortest_ = kShortest * kLongest * picture_size;
  scale_force_ = round_down(0.5 * largest);
}

render::Annotations ForceNotes::of(const Shot& shot) const {
  render::Annotations notes;
  for (std::size_t i = 0; i < spec_.bodies.size(); ++i) {
    if (length_per_force_ > 0) add_forces(i, shot, notes);
    if (look_.show.centres) add_centres(i, shot, notes);
  }
  if (length_per_force_ > 0) {
    notes.scale_length = length_per_force_ * scale_force_;
    notes.scale_name = force_text(scale_force_);
    notes.legend = legend_;
  }
  return notes;
}

void ForceNotes::add_forces(std::size_t body, const Shot& shot, render::Annotations& notes) const {
  const hydro::BodyState& state = shot.states[body];
  for (const NamedForce& force :
       forces_on(spec_.bodies[body], hulls_[body], spec_, state, shot.time)) {
    const Vector3d along = length_per_force_ * force.wrench.force;
    if (length_per_force_ * force.wrench.force.norm() < shortest_) continue;
    const auto centre = force.name == kBuoyancy ? centre_of_buoyancy(spec_.bodies[body].mesh_B,
                                                                     state, *spec_.sea, shot.time)
                                                : std::nullopt;
    const Vector3d from = centre ? *centre : state.position + point_on_line(force.wrench);
    notes.arrows.push_back({from, from + along, force.color});
  }
}

void ForceNotes::add_centres(std::size_t body, const Shot& shot, render::Annotations& notes) const {
  const hydro::BodyState& state = shot.states[body];
  notes.marks.push_back({state.position, "G", {30, 30, 35}});
  if (!spec_.sea) return;
  const auto centre = centre_of_buoyancy(spec_.bodies[body].mesh_B, state, *spec_.sea, shot.time);
  if (centre) notes.marks.push_back({*centre, "B", {20, 90, 200}, true});
}

/// With the depth h and its gradient −e_z, volume and centre are V = −∫ h n_z dS,
/// V x = −∫ h x n_z dS and V h_c = −∫ ½ h² n_z dS over the wet surface: the lid, where h = 0, has
/// no part in them.
std::optional<Vector3d> centre_of_buoyancy(const hydro::TriMesh& mesh_B,
                                           const hydro::BodyState& state, const hydro::Sea& sea,
                                           double time) {
  const Eigen::Matrix3Xd r = state.orientation.toRotationMatrix() * mesh_B.vertices;
  double volume = 0;
  Vector3d first = Vector3d::Zero();  // Of x, y and the depth.
  for (Eigen::Index face = 0; face < mesh_B.face_count(); ++face) {
    hydro::Panel panel;
    Vector3d depth;
    for (int i = 0; i < 3; ++i) {
      panel[static_cast<std::size_t>(i)] = r.col(mesh_B.faces(i, face));
      const Vector3d p_W = state.position + panel[static_cast<std::size_t>(i)];
      depth[i] = hydro::surface_height(sea, p_W.x(), p_W.y(), time) - p_W.z();
    }
    for (const hydro::PanelPart& part : hydro::positive_part(panel, depth)) {
      const double down = -hydro::area_vector(part.panel).z();
      const Vector3d& h = part.value;
      volume += down * h.mean();
      first.z() += down / 12 * (h.squaredNorm() + h.sum() * h.sum()) / 2;
      for (std::size_t i = 0; i < 3; ++i)
        first.head<2>() +=
            down / 12 * (h[static_cast<Eigen::Index>(i)] + h.sum()) * part.panel[i].head<2>();
    }
  }
  if (!(volume > 0)) return std::nullopt;
  Vector3d centre = state.position;
  centre.head<2>() += first.head<2>() / volume;
  centre.z() = hydro::surface_height(sea, centre.x(), centre.y(), time) - first.z() / volume;
  return centre;
}

}  // namespace app
