#include "engine/contacts/bed_suction.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <span>
#include <stdexcept>

#include "engine/base/constants.h"
#include "hydro/mesh/convex_polygon.h"

namespace engine {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// The part of the bed that a body covers.
struct Footprint {
  double area = 0;  ///< [m^2]; 0 on an edge or a corner.
  Vector3d centre_B = Vector3d::Zero();
  Vector3d normal_B = Vector3d::UnitZ();  ///< Unit, out of the bed.
};

/// Centre of the area of a convex polygon.
Vector3d centre_of(const hydro::Polygon& polygon) {
  Vector3d sum = Vector3d::Zero();
  double area = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Vector3d a = polygon[i - 1] - polygon[0], b = polygon[i] - polygon[0];
    const double part = a.cross(b).norm() / 2;
    sum += part * (polygon[0] + (a + b) / 3);
    area += part;
  }
  return sum / area;
}

Footprint footprint(std::span<const ContactForce> forces, const Vector3d& up_B) {
  if (forces.size() < 3) return {};
  Vector3d mean = Vector3d::Zero();
  for (const ContactForce& force : forces)
    mean += force.place_B / static_cast<double>(forces.size());
  Matrix3d spread = Matrix3d::Zero();
  for (const ContactForce& force : forces)
    spread += (force.place_B - mean) * (force.place_B - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(spread);
  Footprint found{.normal_B = axes.eigenvectors().col(0)};
  if (found.normal_B.dot(up_B) < 0) found.normal_B = -found.normal_B;
  hydro::Polygon points;
  for (const ContactForce& force : forces)
    points.push_back(force.place_B - (force.place_B - mean).dot(found.normal_B) * found.normal_B);
  const double margin = kFlatFootprint * std::sqrt(axes.eigenvalues()[2]);
  const hydro::Polygon hull = hydro::convex_hull(std::move(points), found.normal_B, margin);
  if (!hydro::has_area(hull, margin)) return {};
  found.area = hydro::area_of(hull);
  found.centre_B = centre_of(hull);
  return found;
}

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
             Motion& motion) {
  Suction& suction = *motion.suction;
  if (forces.empty()) {
    const Vector3d out_W = motion.state.orientation * -suction.into_bed_B;
    if (motion.state.linear_velocity.dot(out_W) > 0) suction.bond = suction.force = 0;
    return;
  }
  const Footprint foot = footprint(forces, up_B(motion.state));
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
  for (MovingBody& moving : bodies) {
    if (!moving.motion.suction) continue;
    moving.motion.suction->bond = 0;
    if (world.shape_box(moving.id).isEmpty()) continue;
    const Pair pair(kWorld, moving.id);
    const hydro::BodyState start = moving.motion.state;
    // Contacts are trusted as deep as bodies can have come in the last steps.
    const Vector3d sink(0, 0, -kLainDepth * world.thickness(pair));
    hydro::BodyState low = start;
    low.position += sink;
    low.linear_velocity = sink / step;
    const auto contacts =
        world.collide({{.body = moving.id, .state = low, .start = start}}, {pair}, step);
    world.set_state(moving.id, start);
    if (contacts.points.empty()) continue;
    moving.motion.suction->bond = 1;
    const auto forces = remembered(contacts.points, [&](BodyId) { return low; });
    hold(bed, footprint(forces, up_B(start)), *moving.motion.suction);
  }
}

void advance_suction(const BedSuction& bed, const std::vector<ContactForce>& forces, double step,
                     std::vector<MovingBody>& bodies) {
  for (MovingBody& moving : bodies)
    if (moving.motion.suction)
      advance(bed, forces_of({kWorld, moving.id}, forces), step, moving.motion);
}

}  // namespace engine
