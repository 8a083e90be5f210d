#include "engine/motion/body.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "engine/base/constants.h"
#include "engine/motion/free_motion.h"
#include "engine/motion/hulls.h"
#include "engine/motion/locks.h"
#include "hydro/airy_waves.h"
#include "hydro/decompositions.h"
#include "hydro/interior/pockets.h"
#include "hydro/mesh/mass_properties.h"

namespace engine {
namespace {

/// Largest component of a change of added mass, over the least inertia [-].
double relative_change(const Body& body, const Matrix6d& added_B, const Matrix6d& change) {
  return change.cwiseAbs().maxCoeff() / (body.rigid_B + added_B).diagonal().minCoeff();
}

/// The state with the projection of its momentum on the reduced joint.
hydro::BodyState projected_motion(const Body& body, const Motion& motion) {
  const Vector6d u = velocity(motion.state, Eigen::Vector3d::Zero());
  const Matrix6d S = inertia_W(body, motion);
  const Vector6d projected = solve_free(S, S * u, mobility(body, motion.state));
  return with_velocity(motion.state, projected, Eigen::Vector3d::Zero());
}

/// The inertia of the water in a body's pockets, in B.
Matrix6d carried_inertia(const CarriedWater* carried) {
  return carried ? carried->inertia_B : Matrix6d(Matrix6d::Zero());
}

/// The part of A that turns with the body. The rest is constant in W and exerts no moment.
Matrix6d added_in_drift(const Body& body, const Motion& motion) {
  return body.rolls_free ? carried_inertia(motion.carried_water.get()) : motion.added();
}

/// A body without its hull.
Body make_dry_body(const SimulationSpec& spec, const Environment& environment, std::size_t index) {
  const BodySpec& s = spec.bodies[index];
  const bool movable = !immovable(s.locked);
  // Nobody needs the loads of a body that cannot move, unless they are logged.
  const bool loaded = spec.sea && (movable || spec.record_work);
  const bool split = spec.integrator.method == Integrator::Method::split;
  assert(s.mass > 0 && hydro::is_symmetric(s.inertia_B) && is_unit(s.initial.orientation));
  assert(s.mesh_B.face_count() > 0);
  const auto id = static_cast<BodyId>(index);
  Body body{.spec = &s,
            .environment = environment,
            .box_B = hydro::bounding_box(s.mesh_B),
            .radius = s.mesh_B.vertices.colwise().norm().maxCoeff(),
            .rigid_B = rigid_inertia(s),
            .inverse_inertia_B = s.inertia_B.inverse(),
            .wet = loaded && s.wet && (s.resistance || !hydro::no_load(s.coefficients)),
            .has_added_mass = loaded && s.added_mass,
            .has_wave_load = loaded && s.added_mass && hydro::has_airy_waves(*spec.sea) && split,
            .has_memory =
                loaded && s.radiation && (s.sources || s.radiation->memory().size() > 0) && split,
            .rolls_free = spec.sea && s.radiation &&
                          s.radiation->slides() == hydro::WaveFrameRule::Slides::all,
            .movable = movable,
            .locked = partly_locked(s.locked),
            .jointed = std::any_of(
                spec.joints.begin(), spec.joints.end(),
                [id](const JointSpec& joint) { return joint.first == id || joint.second == id; }),
            .reduced_joint = find_reduced_joint(spec, index)};
  body.hollow = spec.sea && s.wet && s.interior == Interior::flooding && s.coefficients.buoyancy &&
                !hydro::is_convex(s.mesh_B);
  const bool carries_water = body.hollow && loaded && split;
  body.has_added_mass = body.has_added_mass || carries_water;
  const bool in_shear = loaded && !spec.sea->profile.empty() && (body.wet || s.added_mass) && split;
  body.has_flow = body.has_wave_load || in_shear;
  if (spec.sea)
    body.displacement = spec.sea->density * std::abs(hydro::solid_properties(water_mesh(s)).volume);
  return body;
}

}  // namespace

Environment make_environment(const SimulationSpec& spec) {
  Environment environment{.gravity = spec.gravity};
  if (!spec.sea) return environment;
  const hydro::SurfaceBounds bounds = hydro::surface_bounds(*spec.sea);
  environment.sea = &*spec.sea;
  environment.level = spec.sea->level;
  environment.highest = bounds.highest;
  environment.lowest = bounds.lowest;
  return environment;
}

std::vector<Body> make_bodies(const SimulationSpec& spec) {
  const Environment environment = make_environment(spec);
  std::vector<Body> bodies;
  bodies.reserve(spec.bodies.size());
  Hulls hulls;
  for (std::size_t i = 0; i < spec.bodies.size(); ++i) {
    Body body = make_dry_body(spec, environment, i);
    body.feels_air = body.wet && spec.sea->air && !body.spec->coefficients.pressure_drag.none();
    if (body.wet) {
      body.hull = hulls.of(*body.spec);
      body.felt_sea = hulls.felt_sea(body.hull, *spec.sea, body.spec->summation);
    }
    // In an ideal fluid no wake separates.
    const bool sheds = body.wet && body.spec->added_mass &&
                       !body.spec->coefficients.pressure_drag.none() &&
                       spec.integrator.method == Integrator::Method::split;
    if (sheds) body.hull_lift = hulls.lift_of(*body.spec);
    // The wake of a body that is held cannot be judged by its motion.
    const hydro::PressureDrag& drag = body.spec->coefficients.pressure_drag;
    const bool steady = drag.none() || drag.blunt == 0 || body.held() ||
                        spec.integrator.method != Integrator::Method::split;
    if (body.wet && !steady) body.wake = hulls.wake_of(*body.spec);
    bodies.push_back(std::move(body));
  }
  return bodies;
}

Motion motion_at(const Body& body, const SimulationSpec& spec, const hydro::BodyState& state,
                 double time) {
  Motion motion{.state = state,
                .memory = still_memory(body),
                .water = still_water(body),
                .carried_water = water_at_start(body, state)};
  if (body.has_added_mass)
    set_added_mass(motion, added_mass(body, state, motion.carried_water.get(), time));
  if (body.reduced_joint) motion.state = projected_motion(body, motion);
  if (body.wake && may_be_wet(body, motion.state)) {
    const Eigen::Vector3d current =
        hydro::current_at(*body.environment.sea, motion.state.position.z());
    motion.wake = hydro::steady_wake(body.wake->scale, motion.state.orientation.toRotationMatrix(),
                                     velocity(motion.state, current));
  }
  if (spec.record_work) motion.work = {.added_energy_at_start = added_kinetic_energy(body, motion)};
  return motion;
}

VerticalExtent vertical_extent(const Body& body, const hydro::BodyState& state) {
  const Eigen::Quaterniond& q = state.orientation;
  const Eigen::Vector3d up_B(2 * (q.x() * q.z() - q.w() * q.y()),
                             2 * (q.y() * q.z() + q.w() * q.x()),
                             1 - 2 * (q.x() * q.x() + q.y() * q.y()));
  const double center = state.position.z() + up_B.dot(body.box_B.center());
  const double height = up_B.cwiseAbs().dot(body.box_B.sizes());
  return {.lowest = center - height / 2, .height = height};
}

bool may_be_wet(const Body& body, const hydro::BodyState& state) {
  return vertical_extent(body, state).lowest < body.environment.highest;
}

Mobility mobility(const Body& body, const hydro::BodyState& state) {
  if (body.held()) return {.locked = kAllDofs};
  if (body.reduced_joint) return {.subspace = motion_subspace(*body.reduced_joint, state)};
  if (body.locked) return {.locked = body.spec->locked};
  return {};
}

Matrix6d inertia_W(const Body& body, const Motion& motion) {
  return inertia_W(body, motion, motion.state.orientation.toRotationMatrix());
}

Matrix6d inertia_W(const Body& body, const Motion& motion, const Eigen::Matrix3d& R_WB) {
  if (motion.added_B) return rotate_tensor(R_WB, body.rigid_B + *motion.added_B);
  Matrix6d inertia = body.rigid_B;
  inertia.bottomRightCorner<3, 3>() = R_WB * body.spec->inertia_B * R_WB.transpose();
  return inertia;
}

Eigen::Vector3d flow_about(const Body& body, const hydro::BodyState& state, double time,
                           double ahead) {
  if (!body.has_flow || (body.reduced_joint && !body.held())) return body.current();
  const hydro::Sea& sea = *body.environment.sea;
  const Eigen::Matrix3d R_WB =
      rotated(state.orientation, ahead * state.angular_velocity).toRotationMatrix();
  const Eigen::Matrix3d half = R_WB * (body.box_B.sizes() / 2).asDiagonal();
  Eigen::Vector3d p = state.position + ahead * state.linear_velocity + R_WB * body.box_B.center();
  const double reach = half.row(2).cwiseAbs().sum();
  const double surface = sea.level + hydro::surface_elevation(sea, p.x(), p.y(), time + ahead);
  p.z() = (p.z() - reach + std::min(p.z() + reach, surface)) / 2;
  return hydro::mean_velocity(sea, p, surface - p.z(), half, time + ahead);
}

hydro::HullWater water_about(const Body& body, const hydro::BodyState& state, double time) {
  const hydro::Sea& sea = *body.environment.sea;
  const Eigen::Vector3d& p = state.position;
  return {.velocity = flow_about(body, state, time, 0),
          .surface = sea.level + hydro::surface_elevation(sea, p.x(), p.y(), time),
          .density = sea.density};
}

void advance_wake(const Body& body, double time, Motion& motion) {
  if (!body.wake) return;
  if (!may_be_wet(body, motion.state))
    motion.wake.setZero();
  else
    motion.wake =
        hydro::advanced_wake(body.wake->scale, motion.state.orientation.toRotationMatrix(),
                             motion.wake, velocity(motion.state, motion.flow), time);
}

void end_wake(const Body& body, const hydro::BodyState& start, double h, Motion& motion) {
  if (!body.wake) return;
  const double above = vertical_extent(body, start).lowest - body.environment.highest;
  const double below = body.environment.highest - vertical_extent(body, motion.state).lowest;
  advance_wake(body, above > 0 && below > 0 ? h * below / (above + below) : h / 2, motion);
}

double formed_wake(const Body& body, const Motion& motion, const hydro::BodyState& state) {
  if (!body.wake) return 1;
  return hydro::formed_wake(body.wake->scale, state.orientation.toRotationMatrix(), motion.wake);
}

hydro::BodyState state_after_drift(const Body& body, const Motion& motion,
                                   const Eigen::Vector3d& flow, double time) {
  if (!body.reduced_joint && !body.locked && !motion.added_B)
    return drifted(*body.spec, motion.state, time, motion.rotors_B);
  const Matrix6d S = body.rigid_B + added_in_drift(body, motion);
  if (body.reduced_joint)
    return advance_on_joint(*body.reduced_joint, S, motion.state, time, motion.rotors_B);
  if (!body.locked) return drifted(S, motion.state, flow, time, motion.rotors_B);
  return project_onto_locks(
      body.spec->locked, body.spec->initial,
      drifted(S, body.spec->locked, motion.state, flow, time, motion.rotors_B));
}

void drift(const Body& body, Motion& motion, double time) {
  std::optional<Motion> before;
  if (motion.work) before = motion;
  const Eigen::Quaterniond R_WB = motion.state.orientation;
  motion.state = state_after_drift(body, motion, motion.flow, time);
  if (motion.added_B)
    motion.added_B = after_turn(body, *motion.added_B, motion.carried_water.get(),
                                R_WB.conjugate() * motion.state.orientation);
  if (before) record_drift(body, *before, time, motion);
}

hydro::BodyState displaced(const Body& body, hydro::BodyState state, const Vector6d& change) {
  state.position += change.head<3>();
  state.orientation = rotated(state.orientation, change.tail<3>());
  if (body.reduced_joint) return project_onto_joint(*body.reduced_joint, state);
  return body.locked ? project_onto_locks(body.spec->locked, body.spec->initial, state) : state;
}

double contact_mass(const Body& body, const Motion& motion) {
  const double own = body.spec->mass;
  if (!motion.added_B) return own;
  const Eigen::Matrix3d added = motion.added_B->topLeftCorner<3, 3>();
  return own + hydro::eigenvalues(added)[2];
}

double contact_fall(const Body& body, const Motion& motion) {
  return std::min(1.0, (body.spec->mass + body.displacement) / contact_mass(body, motion));
}

Matrix6d added_mass(const Body& body, const hydro::BodyState& state, const CarriedWater* carried,
                    double time) {
  Matrix6d added = Matrix6d::Zero();
  if (!body.has_added_mass) return added;
  if (body.spec->added_mass) added = body.spec->added_mass->at(state, *body.environment.sea, time);
  if (carried) added += carried->inertia_B;
  return added;
}

Matrix6d after_turn(const Body& body, const Matrix6d& added_B, const CarriedWater* carried,
                    const Eigen::Quaterniond& turn) {
  if (!body.rolls_free) return added_B;
  const Matrix6d water_B = carried_inertia(carried);
  return water_B + rotate_tensor(turn.conjugate().toRotationMatrix(), added_B - water_B);
}

void set_added_mass(Motion& motion, const Matrix6d& added_B) {
  if (added_B.isZero(0))
    motion.added_B.reset();
  else
    motion.added_B = added_B;
}

double pose_distance(const Body& body, const hydro::BodyState& a, const hydro::BodyState& b) {
  const Eigen::Quaterniond turn = a.orientation.conjugate() * b.orientation;
  return (b.position - a.position).norm() + body.radius * 2 * turn.vec().norm();
}

double dip_distance(const Body& body, const hydro::BodyState& a, const hydro::BodyState& b) {
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d tilt = a.orientation.conjugate() * up - b.orientation.conjugate() * up;
  return std::abs(b.position.z() - a.position.z()) + body.radius * tilt.norm();
}

double scaled_change(const Body& body, const Matrix6d& added_B, const Matrix6d& change) {
  const Vector6d scale = (body.rigid_B + added_B).diagonal().cwiseSqrt().cwiseInverse();
  return (scale.asDiagonal() * change * scale.asDiagonal()).cwiseAbs().maxCoeff();
}

AddedMassMatch compare_added_mass(const Body& body, const Matrix6d& start_B,
                                  const Matrix6d& taken_B, const Matrix6d& found_B) {
  if (scaled_change(body, found_B, found_B - taken_B) <= kEqualAddedMass)
    return AddedMassMatch::equal;
  // An update leaves at most this part of a difference.
  const double error = relative_change(body, taken_B, found_B - taken_B);
  const double change = relative_change(body, taken_B, found_B - start_B);
  return error * std::max(error, change) <= kUnmatchedAddedMass ? AddedMassMatch::near
                                                                : AddedMassMatch::distant;
}

Motion share_momentum(const Body& body, const Motion& before, const Matrix6d& added_B) {
  Motion motion = before;
  const Eigen::Matrix3d R_WB = motion.state.orientation.toRotationMatrix();
  const Matrix6d change = rotate_tensor(R_WB, added_B - motion.added());
  const Vector6d u = inertia_change(inertia_W(body, motion), change, mobility(body, motion.state),
                                    velocity(motion.state, motion.flow))
                         .velocity;
  motion.state = with_velocity(motion.state, u, motion.flow);
  set_added_mass(motion, added_B);
  if (motion.work) record_added_mass(body, before, motion);
  return motion;
}

}  // namespace engine
