#include <ode/ode.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "engine/base/constants.h"
#include "engine/base/spatial_vector.h"
#include "engine/base/stopwatch.h"
#include "engine/contacts/ode_world.h"
#include "engine/contacts/world.h"

namespace engine {
namespace {

// ODE counts the contacts of one pair in 16 bits.
constexpr std::size_t kMostPoints = 0xffff;
constexpr std::size_t kUsualPoints = 256;
constexpr double kGridShift = 3.1e-5;  // [m]; the cells of ODE's grid of contacts are of 1e-4 m
constexpr int kMostGridShifts = 8;

std::size_t find_overlaps(dxGeom* first, dxGeom* second, std::vector<dContactGeom>& points) {
  return static_cast<std::size_t>(dCollide(first, second, static_cast<int>(points.size()),
                                           points.data(), sizeof(dContactGeom)));
}

void shift(dxGeom* geom, const Eigen::Vector3d& by) {
  const Eigen::Vector3d place = vector_from_ode(dGeomGetPosition(geom)) + by;
  dGeomSetPosition(geom, place.x(), place.y(), place.z());
}

/// Overlaps found with both geometries shifted.
std::size_t find_shifted(dxGeom* first, dxGeom* second, const Eigen::Vector3d& by,
                         std::vector<dContactGeom>& points) {
  const Eigen::Vector3d there[] = {vector_from_ode(dGeomGetPosition(first)),
                                   vector_from_ode(dGeomGetPosition(second))};
  const auto restore = [&] {
    dGeomSetPosition(first, there[0].x(), there[0].y(), there[0].z());
    dGeomSetPosition(second, there[1].x(), there[1].y(), there[1].z());
  };
  shift(first, by);
  shift(second, by);
  std::size_t found = 0;
  try {
    found = find_overlaps(first, second, points);
  } catch (const OdeFault&) {
    restore();
    throw;
  }
  restore();
  for (std::size_t i = 0; i < found; ++i)
    for (int k = 0; k < 3; ++k) points[i].pos[k] -= by[k];
  return found;
}

/// Overlaps of two geometries, as many as there is room for. ODE merges points of meshes that lie
/// close together by the cells of a grid, and fails where many are in one cell; elsewhere on the
/// grid it does not.
std::size_t find_robustly(dxGeom* first, dxGeom* second, std::vector<dContactGeom>& points) {
  for (int trial = 0;; ++trial) {
    try {
      if (trial == 0) return find_overlaps(first, second, points);
      return find_shifted(first, second, trial * kGridShift * Eigen::Vector3d(1, 1.3, 1.7), points);
    } catch (const OdeFault&) {
      if (trial == kMostGridShifts) throw;
    }
  }
}

/// All overlaps of two geometries.
std::vector<dContactGeom> overlaps(dxGeom* first, dxGeom* second) {
  std::vector<dContactGeom> points;
  for (std::size_t capacity = kUsualPoints;; capacity = std::min(8 * capacity, kMostPoints)) {
    points.resize(capacity);
    const std::size_t found = find_robustly(first, second, points);
    if (found == capacity && capacity < kMostPoints) continue;
    points.resize(found);
    return points;
  }
}

/// ODE's points, without those whose normal is not a direction, which two triangles that touch in
/// a point can give.
std::vector<ContactPoint> contact_points(const std::vector<dContactGeom>& overlaps) {
  std::vector<ContactPoint> points;
  points.reserve(overlaps.size());
  for (const dContactGeom& overlap : overlaps) {
    const ContactPoint point{.position_W = vector_from_ode(overlap.pos),
                             .normal_W = vector_from_ode(overlap.normal),
                             .depth = overlap.depth};
    const bool sound = point.position_W.allFinite() && std::isfinite(point.depth) &&
                       std::abs(point.normal_W.norm() - 1) < 1e-6;
    if (sound) points.push_back(point);
  }
  return points;
}

/// Box around a geometry, in W; empty for none.
Eigen::AlignedBox3d box_around(dxGeom* geom) {
  if (!geom) return {};
  std::array<dReal, 6> box{};
  dGeomGetAABB(geom, box.data());
  return {Eigen::Vector3d(box[0], box[2], box[4]), Eigen::Vector3d(box[1], box[3], box[5])};
}

struct DestroyGeom {
  void operator()(dxGeom* geom) const { dGeomDestroy(geom); }
};
using BoxHandle = std::unique_ptr<dxGeom, DestroyGeom>;

bool is_sphere(dxGeom* geom) { return dGeomGetClass(geom) == dSphereClass; }
bool is_mesh(dxGeom* geom) { return dGeomGetClass(geom) == dTriMeshClass; }

}  // namespace

Eigen::AlignedBox3d World::ground_box() const { return box_around(ground_); }

void World::collide(double step) {
  open_ode();
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const Body& body : bodies_) boxes.push_back(box_around(body.geom));
  boxes.push_back(ground_box());
  contacts_ = contacts_of(touchable(overlapping(boxes)), step);
  dJointGroupEmpty(contact_joints_.get());
  for (const Contact& contact : contacts_.points)
    add_contact(world_.get(), contact_joints_.get(), contact, handle_of(contact.pair.first),
                handle_of(contact.pair.second));
}

void World::set_contact_inertia(BodyId id, const Inertia& inertia) {
  bodies_.at(id).inertia = inertia;
}

World::Contacts World::collide(const std::vector<Placed>& bodies, const std::vector<Pair>& pairs,
                               double step) {
  const std::lock_guard lock(*mutex_);
  const Stopwatch stopwatch(collision_seconds_);
  open_ode();
  for (const Placed& placed : bodies) {
    set_state(placed.body, placed.state);
    set_contact_inertia(placed.body, placed.inertia);
  }
  Contacts contacts = contacts_of(pairs, step);
  add_followers(bodies, pairs, step, contacts);
  return contacts;
}

std::vector<double> World::closing_times(
    const std::vector<std::pair<BodyId, hydro::BodyState>>& places, const Pair& pair, double slow) {
  const std::lock_guard lock(*mutex_);
  const Stopwatch stopwatch(collision_seconds_);
  open_ode();
  for (const auto& [body, state] : places) set_state(body, state);
  std::vector<double> times;
  for (const ContactPoint& point : touching_points(pair, 0)) {
    const double speed = -point.normal_W.dot(approach(pair, point.position_W, 0));
    if (speed > slow) times.push_back(point.depth / speed);
  }
  return times;
}

bool World::meets(BodyId body, const hydro::BodyState& place, const OrientedBox& box) {
  const std::lock_guard lock(*mutex_);
  const Stopwatch stopwatch(collision_seconds_);
  open_ode();
  if (body != kWorld) set_state(body, place);
  const BoxHandle probe(dCreateBox(nullptr, box.sizes.x(), box.sizes.y(), box.sizes.z()));
  dGeomSetPosition(probe.get(), box.center_W.x(), box.center_W.y(), box.center_W.z());
  dGeomSetRotation(probe.get(), to_ode(box.axes_W).data());
  dContactGeom point;
  return dCollide(geom_of(body), probe.get(), 1, &point, sizeof point) > 0;
}

bool World::is_ball(BodyId body) const { return body != kWorld && is_sphere(geom_of(body)); }

double World::thickness(const Pair& pair) const {
  double least = std::numeric_limits<double>::infinity();
  for (const BodyId id : {pair.first, pair.second})
    if (id != kWorld) least = std::min(least, bodies_[id].shape_B.sizes().minCoeff());
  return least;
}

double World::reach(const Pair& pair) const {
  if (pair.first == kWorld && dGeomGetClass(ground_) == dPlaneClass)
    return std::numeric_limits<double>::infinity();
  return thickness(pair) / 2;
}

std::vector<Pair> World::touchable(
    const std::vector<std::pair<std::size_t, std::size_t>>& pairs) const {
  std::vector<Pair> found;
  for (const auto& [first, second] : pairs) {
    const auto a = static_cast<BodyId>(first), b = static_cast<BodyId>(second);
    const Pair pair = second == bodies_.size() ? Pair(kWorld, a) : Pair(a, b);
    if ((handle_of(pair.first) || handle_of(pair.second)) &&
        !std::binary_search(jointed_.begin(), jointed_.end(), pair))
      found.push_back(pair);
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<ContactPoint> World::touching_points(const Pair& pair, double step) const {
  dxGeom* first = geom_of(pair.first);
  dxGeom* second = geom_of(pair.second);
  // Ground is a sheet: its box does not bound the depth of a body in it.
  const double boxes = box_around(first).intersection(box_around(second)).sizes().minCoeff();
  if (boxes < 0) return {};
  const std::vector<ContactPoint> all = contact_points(overlaps(first, second));
  if (all.empty()) return {};
  const double reach = kReachInSteps * step * approach(pair, all.front().position_W, step).norm();
  std::vector<ContactPoint> points = without_artefacts(
      all, reach, pair.first == kWorld ? std::numeric_limits<double>::infinity() : boxes);
  if (is_sphere(first) || is_sphere(second)) points = supporting_a_sphere(std::move(points));
  const std::size_t limit = is_mesh(first) || is_mesh(second) ? kContactsOfPair : kContactsOfFace;
  std::vector<ContactPoint> kept;
  for (const std::size_t i : representative(points, limit)) kept.push_back(points[i]);
  return kept;
}

Eigen::Vector3d World::approach(const Pair& pair, const Eigen::Vector3d& point_W,
                                double step) const {
  return velocity_without_contact(pair.first, point_W, step) -
         velocity_without_contact(pair.second, point_W, step);
}

ContactLaw World::law_of(const Pair& pair, std::size_t points) const {
  ContactLaw law{
      .points = points, .rest = kContactDepth * thickness(pair), .fall = 0, .gravity = gravity_};
  for (const BodyId id : {pair.first, pair.second}) {
    if (!handle_of(id)) continue;
    law.mass = std::max(law.mass, bodies_[id].inertia.mass);
    law.fall = std::max(law.fall, bodies_[id].inertia.fall);
  }
  return law;
}

Contact World::contact_at(const Pair& pair, const ContactPoint& point, const Surface& surface,
                          const ContactLaw& law, double step) const {
  const double closing = -point.normal_W.dot(approach(pair, point.position_W, 0));
  Contact contact{.pair = pair,
                  .point = point,
                  .row = contact_row(point.depth, law, step),
                  .friction = surface.friction,
                  .restitution = surface.restitution,
                  .rebounds = closing > impact_speed(gravity_),
                  .sliding_W = approach(pair, point.position_W, step)};
  if (contact.rebounds)
    contact.row.speed = std::max(contact.row.speed, surface.restitution * closing);
  return contact;
}

World::Contacts World::contacts_of(const std::vector<Pair>& pairs, double step) const {
  Contacts contacts;
  for (const Pair& pair : pairs) {
    const std::vector<ContactPoint> points = touching_points(pair, step);
    if (points.empty()) continue;
    contacts.pairs.push_back(pair);
    const Surface surface = surfaces_.between(pair);
    const ContactLaw law = law_of(pair, points.size());
    for (const ContactPoint& point : points)
      contacts.points.push_back(contact_at(pair, point, surface, law, step));
  }
  return contacts;
}

Eigen::Vector3d World::velocity_without_contact(BodyId id, const Eigen::Vector3d& point_W,
                                                double step) const {
  if (!handle_of(id)) return Eigen::Vector3d::Zero();
  const hydro::BodyState now = state(id);
  return now.linear_velocity + now.angular_velocity.cross(point_W - now.position) +
         step * bodies_[id].inertia.acceleration;
}

}  // namespace engine
