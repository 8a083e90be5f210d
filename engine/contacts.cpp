#include "engine/contacts.h"

#include <ode/ode.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "engine/world.h"

namespace engine {
namespace {

// ODE counts the contacts of one pair in 16 bits.
constexpr std::size_t kMostPoints = 0xffff;
constexpr std::size_t kUsualPoints = 256;
// Regularisation of friction relative to the inertia it works on: equation (3).
constexpr double kSlip = 1e-6;
// Extent of points that are all one [m]; its square can still be divided by.
constexpr double kLeastExtent = 1e-100;
// By which overlaps are left where there is no weight [m/s^2].
constexpr double kLeastGravity = 1;
// Steps in which an overlap can have come about before it is told from an artefact. Fewer would let
// a fast edge through a wall that it meets where it also touches the ground.
constexpr double kReachInSteps = 3;

/// All overlaps of two geometries.
std::vector<dContactGeom> overlaps(dxGeom* first, dxGeom* second) {
  std::vector<dContactGeom> points;
  std::size_t room = kUsualPoints;
  while (true) {
    points.resize(room);
    const int found =
        dCollide(first, second, static_cast<int>(room), points.data(), sizeof(dContactGeom));
    if (static_cast<std::size_t>(found) < room || room == kMostPoints) {
      points.resize(static_cast<std::size_t>(found));
      return points;
    }
    room = std::min(8 * room, kMostPoints);
  }
}

/// The points in ODE's words, without those whose normal is not a direction: two triangles that
/// touch in a point can give one.
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

dContact contact_joint(const ContactPoint& point, const ContactStiffness& stiffness, double erp,
                       const Eigen::Vector3d& velocity) {
  dContact contact{};
  Eigen::Map<Eigen::Vector3d>(contact.geom.pos) = point.position_W;
  Eigen::Map<Eigen::Vector3d>(contact.geom.normal) = point.normal_W;
  contact.geom.depth = point.depth;
  contact.surface.mode =
      dContactSoftERP | dContactSoftCFM | dContactSlip1 | dContactSlip2 | dContactApprox1;
  contact.surface.mu = kFriction;
  contact.surface.soft_erp = erp;
  contact.surface.soft_cfm = stiffness.cfm;
  contact.surface.slip1 = contact.surface.slip2 = stiffness.slip;

  const Eigen::Vector3d sliding = velocity - velocity.dot(point.normal_W) * point.normal_W;
  if (sliding.norm() > 1e-9 * velocity.norm()) {
    contact.surface.mode |= dContactFDir1;
    Eigen::Map<Eigen::Vector3d>(contact.fdir1) = sliding.normalized();
  }
  return contact;
}

/// Distance of two points as `representative` understands it: in place relative to the extent of
/// them all, and in direction.
double distance(const ContactPoint& a, const ContactPoint& b, double extent) {
  return (a.position_W - b.position_W).squaredNorm() / (extent * extent) +
         (a.normal_W - b.normal_W).squaredNorm();
}

/// True if `deep` lies in the overlap of the far shallower contact `shallow` in another direction.
bool explains(const ContactPoint& shallow, const ContactPoint& deep) {
  return shallow.depth < 0.2 * deep.depth && shallow.normal_W.dot(deep.normal_W) < 0.7 &&
         std::abs((deep.position_W - shallow.position_W).dot(shallow.normal_W)) <
             1.5 * shallow.depth;
}

/// Least overlap along a world axis of the boxes around two solids [m].
double box_overlap(dxGeom* first, dxGeom* second) {
  std::array<dReal, 6> a{}, b{};
  dGeomGetAABB(first, a.data());
  dGeomGetAABB(second, b.data());
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t low = 0; low < 6; low += 2)
    least = std::min(least, std::min(a[low + 1], b[low + 1]) - std::max(a[low], b[low]));
  return least;
}

bool is_sphere(dxGeom* geom) { return dGeomGetClass(geom) == dSphereClass; }
bool is_mesh(dxGeom* geom) { return dGeomGetClass(geom) == dTriMeshClass; }

double extent_of(const std::vector<ContactPoint>& points) {
  Eigen::AlignedBox3d box;
  for (const ContactPoint& point : points) box.extend(point.position_W);
  return std::max(box.diagonal().norm(), kLeastExtent);
}

void note_near_pair(void* pairs, dxGeom* first, dxGeom* second) {
  const auto id = [](dxGeom* geom) {
    return static_cast<BodyId>(reinterpret_cast<std::intptr_t>(dGeomGetData(geom)));
  };
  static_cast<std::vector<std::pair<BodyId, BodyId>>*>(pairs)->push_back(
      std::minmax(id(first), id(second)));
}

}  // namespace

std::vector<ContactPoint> without_artefacts(const std::vector<ContactPoint>& points, double reach,
                                            double boxes) {
  std::vector<ContactPoint> touching;
  const auto overlap = [](const ContactPoint& point) { return point.depth > 0; };
  std::copy_if(points.begin(), points.end(), std::back_inserter(touching), overlap);
  const auto artefact = [&](const ContactPoint& point) {
    if (point.depth <= reach) return false;
    return point.depth > 2 * boxes ||
           std::any_of(touching.begin(), touching.end(),
                       [&](const ContactPoint& other) { return explains(other, point); });
  };
  std::vector<ContactPoint> contacts;
  std::remove_copy_if(touching.begin(), touching.end(), std::back_inserter(contacts), artefact);
  return contacts;
}

std::vector<ContactPoint> holding_a_sphere(std::vector<ContactPoint> points) {
  const auto deeper = [](const auto& a, const auto& b) { return a.depth > b.depth; };
  std::stable_sort(points.begin(), points.end(), deeper);
  std::vector<ContactPoint> kept;
  for (const ContactPoint& point : points) {
    const bool left = std::all_of(kept.begin(), kept.end(), [&](const ContactPoint& other) {
      return point.depth > other.depth * other.normal_W.dot(point.normal_W);
    });
    if (left) kept.push_back(point);
  }
  return kept;
}

std::vector<std::size_t> representative(const std::vector<ContactPoint>& points, std::size_t most) {
  if (points.empty()) return {};
  const auto deeper = [](const auto& a, const auto& b) { return a.depth < b.depth; };
  auto next = static_cast<std::size_t>(std::max_element(points.begin(), points.end(), deeper) -
                                       points.begin());
  const double extent = extent_of(points);

  std::vector<std::size_t> taken;
  std::vector<double> gap(points.size(), std::numeric_limits<double>::infinity());
  while (taken.size() < most) {
    taken.push_back(next);
    for (std::size_t i = 0; i < points.size(); ++i) {
      gap[i] = std::min(gap[i], distance(points[i], points[next], extent));
    }
    const auto farthest = std::max_element(gap.begin(), gap.end());
    if (*farthest == 0) break;  // every point left coincides with one taken
    next = static_cast<std::size_t>(farthest - gap.begin());
  }
  return taken;
}

ContactStiffness contact_stiffness(double mass, std::size_t points, double step) {
  const double tau = std::max(step, kShortestContact);
  const double share = static_cast<double>(points) / mass;
  return {.erp = step / (step + 2 * tau),
          .cfm = share * tau * tau / (step + 2 * tau),
          .slip = kSlip * step * share};
}

double limited_erp(double erp, double depth, double gravity, double step) {
  return std::min(erp, step * std::sqrt(2 * std::max(gravity, kLeastGravity) / depth));
}

void World::collide(double step) {
  open_ode();
  dJointGroupEmpty(contacts_.get());
  touching_.clear();
  deepest_contact_ = 0;
  for (const Pair& pair : near_pairs()) join_contacts(pair, step);
}

std::vector<World::Pair> World::near_pairs() const {
  std::vector<Pair> pairs;
  dSpaceCollide(space_.get(), &pairs, note_near_pair);
  std::erase_if(pairs, [this](const Pair& pair) { return !may_touch(pair); });
  // The order in which the space finds them depends on what was found before.
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

bool World::may_touch(const Pair& pair) const {
  const bool moves = handle_of(pair.first) || handle_of(pair.second);
  return moves && !std::binary_search(jointed_.begin(), jointed_.end(), pair);
}

void World::join_contacts(const Pair& pair, double step) {
  dxGeom* first = geom_of(pair.first);
  dxGeom* second = geom_of(pair.second);
  const std::vector<ContactPoint> all = contact_points(overlaps(first, second));
  if (all.empty()) return;
  const auto approach = [&](const Eigen::Vector3d& point_W) -> Eigen::Vector3d {
    return velocity_without_contact(pair.first, point_W, step) -
           velocity_without_contact(pair.second, point_W, step);
  };
  // Ground is a sheet: its box says nothing of how deep a body lies in it.
  const double boxes =
      pair.first == kWorld ? std::numeric_limits<double>::infinity() : box_overlap(first, second);
  const double reach = kReachInSteps * step * approach(all.front().position_W).norm();
  std::vector<ContactPoint> points = without_artefacts(all, reach, boxes);
  if (is_sphere(first) || is_sphere(second)) points = holding_a_sphere(std::move(points));
  const std::size_t most = is_mesh(first) || is_mesh(second) ? kContactsOfPair : kContactsOfFace;
  const std::vector<std::size_t> kept = representative(points, most);
  if (kept.empty()) return;
  touching_.push_back(pair);
  const ContactStiffness stiffness =
      contact_stiffness(unit_ * contact_mass(pair), kept.size(), step);
  const double fall = contact_fall(pair);
  for (const std::size_t i : kept) {
    deepest_contact_ = std::max(deepest_contact_, points[i].depth);
    const double erp = limited_erp(stiffness.erp, points[i].depth / fall, gravity_, step);
    const dContact contact =
        contact_joint(points[i], stiffness, erp, approach(points[i].position_W));
    dxJoint* joint = dJointCreateContact(world_.get(), contacts_.get(), &contact);
    dJointAttach(joint, handle_of(pair.first), handle_of(pair.second));
  }
}

double World::contact_mass(const Pair& pair) const {
  double mass = 0;
  for (const BodyId id : {pair.first, pair.second}) {
    if (handle_of(id)) mass = std::max(mass, bodies_[static_cast<std::size_t>(id)].contact_mass);
  }
  return mass;
}

double World::contact_fall(const Pair& pair) const {
  double fall = 0;
  for (const BodyId id : {pair.first, pair.second}) {
    if (handle_of(id)) fall = std::max(fall, bodies_[static_cast<std::size_t>(id)].contact_fall);
  }
  return fall;
}

Eigen::Vector3d World::velocity_without_contact(BodyId id, const Eigen::Vector3d& point_W,
                                                double step) const {
  if (!handle_of(id)) return Eigen::Vector3d::Zero();
  const Body& body = bodies_[static_cast<std::size_t>(id)];
  const hydro::BodyState now = state(id);
  const Eigen::Vector3d acceleration =
      body.acceleration.value_or(body.load.force / body.mass - gravity_ * Eigen::Vector3d::UnitZ());
  return now.linear_velocity + now.angular_velocity.cross(point_W - now.position) +
         step * acceleration;
}

}  // namespace engine
