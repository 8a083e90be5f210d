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

/// Advances the suction of one body. @param forces   Of its contacts with the ground.
void advance(const BedSuction& bed, std::span<const ContactForce> forces, double time, double step,
             Motion& motion) {
  Suction& suction = *motion.suction;
  const double held_with = suction.force;
  suction.force = 0;
  if (forces.empty()) {
    if (time > kLainTime) suction.bond = 0;
    return;
  }
  const Vector3d up_B = motion.state.orientation.conjugate() * Vector3d::UnitZ();
  const Footprint foot = footprint(forces, up_B);
  const double whole = bed.pressure * foot.area;
  if (!(whole > 0)) return;
  double pressing = 0;  // The forces act on the ground, which is the first of each pair.
  for (const ContactForce& force : forces) pressing -= force.force_B.dot(foot.normal_B);
  const double change = step * (pressing - held_with) / (whole * bed.time);
  suction = {.bond = std::clamp(suction.bond + change, 0.0, 1.0),
             .place_B = foot.centre_B,
             .into_bed_B = -foot.normal_B};
  suction.force = suction.bond * whole;
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

void advance_suction(const BedSuction& bed, const std::vector<ContactForce>& forces, double time,
                     double step, std::vector<MovingBody>& bodies) {
  for (MovingBody& moving : bodies)
    if (moving.motion.suction)
      advance(bed, forces_of({kWorld, moving.id}, forces), time, step, moving.motion);
}

}  // namespace engine
