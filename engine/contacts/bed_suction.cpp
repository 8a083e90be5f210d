#include "engine/contacts/bed_suction.h"

#include <algorithm>
#include <span>
#include <stdexcept>

#include "engine/base/constants.h"
#include "hydro/mesh/convex_polygon.h"

namespace engine {
namespace {

using Eigen::Vector3d;

/// The part of the bed that a body covers.
struct Footprint {
  double area = 0;  ///< [m^2]; 0 on an edge or a corner.
  Vector3d centre_B = Vector3d::Zero();
  Vector3d normal_B = Vector3d::UnitZ();  ///< Unit, out of the bed.
};

/// The hull of the points of contact, seen from above.
Footprint footprint(std::span<const ContactForce> forces, const Vector3d& up_B, double margin) {
  hydro::Polygon points;
  for (const ContactForce& force : forces) points.push_back(force.place_B);
  const hydro::Polygon hull = hydro::convex_hull(std::move(points), up_B, 0);
  if (!hydro::has_area(hull, margin)) return {};
  Vector3d sum = Vector3d::Zero(), moment = Vector3d::Zero();
  for (std::size_t i = 2; i < hull.size(); ++i) {
    const Vector3d a = hull[i - 1] - hull[0], b = hull[i] - hull[0], part = a.cross(b) / 2;
    sum += part;
    moment += part.norm() * (hull[0] + (a + b) / 3);
  }
  const double area = sum.norm();
  return {.area = area, .centre_B = moment / area, .normal_B = sum / area};
}

/// Width of a footprint below which it is an edge: the depth of rest.
double edge_width(const MovingBody& moving) { return kContactDepth * moving.body.radius; }

/// Lets the bed hold a footprint by what is left of the bond.
void hold(const BedSuction& bed, const Footprint& foot, Suction& suction) {
  suction.force = suction.bond * bed.pressure * foot.area;
  suction.place_B = foot.centre_B;
  suction.into_bed_B = -foot.normal_B;
}

Vector3d up_B(const hydro::BodyState& state) {
  return state.orientation.conjugate() * Vector3d::UnitZ();
}

/// Advances the suction of one body. @param forces   Of its contacts with the ground.
void advance(const BedSuction& bed, std::span<const ContactForce> forces, double step,
             MovingBody& moving) {
  const hydro::BodyState& state = moving.motion.state;
  Suction& suction = *moving.motion.suction;
  if (forces.empty()) {
    const Vector3d out_W = state.orientation * -suction.into_bed_B;
    if (state.linear_velocity.dot(out_W) > 0) suction.bond = suction.force = 0;
    return;
  }
  const Footprint foot = footprint(forces, up_B(state), edge_width(moving));
  const double whole = bed.pressure * foot.area;
  if (whole > 0) {
    double pressing = 0;  // The forces act on the ground, which is the first of each pair.
    for (const ContactForce& force : forces) pressing -= force.force_B.dot(foot.normal_B);
    const double change = step * (pressing - suction.force) / (whole * bed.time);
    suction.bond = std::clamp(suction.bond + change, 0.0, 1.0);
  }
  hold(bed, foot, suction);
}

}  // namespace

void check_suction(const SimulationSpec& spec) {
  if (!spec.suction) return;
  if (!(spec.suction->pressure >= 0) || !(spec.suction->time > 0))
    throw std::invalid_argument("a bed's suction needs a pressure >= 0 and a time > 0");
  if (std::holds_alternative<std::monostate>(spec.ground))
    throw std::invalid_argument("a bed's suction needs a ground");
  if (spec.integrator.method == Integrator::Method::ode)
    throw std::invalid_argument("method ode knows no suction of the bed");
}

void begin_suction(World& world, const BedSuction& bed, double step,
                   std::vector<MovingBody>& bodies) {
  std::vector<World::Placed> lowered;
  std::vector<Pair> pairs;
  for (const MovingBody& moving : bodies) {
    if (!moving.motion.suction || world.shape_box(moving.id).isEmpty()) continue;
    const hydro::BodyState& start = moving.motion.state;
    const Pair pair(kWorld, moving.id);
    const Vector3d sink(0, 0, -kContactDepth * world.thickness(pair));
    World::Placed low{.body = moving.id, .state = start, .start = start, .inertia = {}};
    low.state.position += sink;
    // Contacts are trusted as deep as bodies can have come in the last steps.
    low.state.linear_velocity = sink / step;
    lowered.push_back(low);
    pairs.push_back(pair);
  }
  const auto state_of = [&](BodyId id) {
    return std::ranges::find(lowered, id, &World::Placed::body)->state;
  };
  const auto forces = remembered(world.collide(lowered, pairs, step).points, state_of);
  for (const World::Placed& low : lowered) {
    MovingBody& moving = bodies[low.body];
    world.set_state(low.body, low.start);
    const auto touching = forces_of({kWorld, low.body}, forces);
    if (touching.empty()) continue;
    moving.motion.suction->bond = 1;
    hold(bed, footprint(touching, up_B(low.start), edge_width(moving)), *moving.motion.suction);
  }
}

void advance_suction(const BedSuction& bed, const std::vector<ContactForce>& forces, double step,
                     std::vector<MovingBody>& bodies) {
  for (MovingBody& moving : bodies)
    if (moving.motion.suction) advance(bed, forces_of({kWorld, moving.id}, forces), step, moving);
}

}  // namespace engine
