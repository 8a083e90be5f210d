#include "engine/body.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "engine/added_inertia.h"
#include "engine/applied_load.h"
#include "engine/free_motion.h"
#include "engine/locks.h"
#include "engine/wetness.h"
#include "hydro/decompositions.h"
#include "hydro/mesh/mass_properties.h"

namespace engine {
namespace {

bool has_joint(const SimulationSpec& spec, BodyId body) {
  return std::any_of(spec.joints.begin(), spec.joints.end(), [&](const JointSpec& joint) {
    return joint.first == body || joint.second == body;
  });
}

/// Finds the loads of the water, by a look above the surface, from the last time, or anew.
void find_water_loads(Body& body, const Surroundings& around, const hydro::BodyState& state,
                      double time) {
  if (lowest_point(body.box_B, state) >= around.highest) {
    ++body.cost.dry;
    body.loads.water = {};
    body.loaded_state.reset();
  } else if (body.loaded_state == state && !hydro::changes_with_time(*around.sea)) {
    ++body.cost.resting;
  } else {
    body.loads.water = hydro::compute_loads(*body.hull, state, *around.sea, time,
                                            body.spec->coefficients, body.spec->summation);
    body.loaded_state = state;
  }
}

// Difference of the added mass that a piece ends with from that of its pose, as a part of the
// inertia: its energy is uncertain by as much.
constexpr double kUnmetInertia = 1e-4;

/// Largest part of the inertia that a change of added mass makes up [-].
double part_of_inertia(const Body& body, const Matrix6d& added_B, const Matrix6d& change) {
  return change.cwiseAbs().maxCoeff() / (body.rigid_B + added_B).diagonal().minCoeff();
}

/// The initial state with what its joint leaves of its momentum.
hydro::BodyState put_on_guide(const Body& body) {
  const hydro::BodyState& state = body.motion.state;
  const Vector6d u = velocity(state, Eigen::Vector3d::Zero());
  const Matrix6d S = inertia_W(body, body.motion);
  const Vector6d left = solve_free(S, S * u, {.ways = ways(*body.guide, state)});
  return with_velocity(state, left, Eigen::Vector3d::Zero());
}

std::optional<Matrix6d> unless_zero(const Matrix6d& matrix) {
  return matrix.isZero(0) ? std::nullopt : std::optional<Matrix6d>(matrix);
}

/// All of it but its hull.
Body make_dry_body(const SimulationSpec& spec, std::size_t index) {
  const BodySpec& s = spec.bodies[index];
  Body body{.spec = &s,
            .box_B = hydro::bounding_box(s.mesh_B),
            .radius = s.mesh_B.vertices.colwise().norm().maxCoeff(),
            .rigid_B = rigid_inertia(s),
            .inverse_inertia_B = s.inertia_B.inverse(),
            .wet = spec.sea && feels_water(s),
            .adds = spec.sea && s.added_mass && !immovable(s.locked),
            .movable = !immovable(s.locked),
            .locked = partly_held(s.locked),
            .jointed = has_joint(spec, static_cast<BodyId>(index)),
            .guide = find_guide(spec, index)};
  if (spec.sea)
    body.displacement = spec.sea->density * std::abs(hydro::solid_properties(s.mesh_B).volume);
  body.motion.state = without_locked_motion(s.locked, s.initial);
  if (body.adds)
    body.motion.added_B = unless_zero(s.added_mass->at(body.motion.state, *spec.sea, 0));
  if (body.guide) body.motion.state = put_on_guide(body);
  if (spec.books)
    body.motion.ledger = {.added_energy_at_start =
                              added_kinetic_energy(body, surroundings(spec), body.motion)};
  return body;
}

bool uses_clusters(const Body& body) {
  const BodySpec& spec = *body.spec;
  return !spec.coefficients.viscous_drag.none() && spec.summation.branches &&
         spec.summation.wave_tolerance > 0;
}

std::shared_ptr<const hydro::Hull> make_hull_of(const Body& body) {
  return std::make_shared<hydro::Hull>(hydro::make_hull(body.spec->mesh_B, uses_clusters(body)));
}

}  // namespace

Surroundings surroundings(const SimulationSpec& spec) {
  Surroundings around{.gravity = spec.gravity};
  if (!spec.sea) return around;
  const hydro::SurfaceBounds bounds = hydro::surface_bounds(*spec.sea);
  around.sea = &*spec.sea;
  around.highest = bounds.highest;
  around.lowest = bounds.lowest;
  return around;
}

Body make_body(const SimulationSpec& spec, std::size_t index) {
  Body body = make_dry_body(spec, index);
  if (body.wet) body.hull = make_hull_of(body);
  return body;
}

std::vector<Body> make_bodies(const SimulationSpec& spec) {
  std::vector<Body> bodies;
  for (std::size_t i = 0; i < spec.bodies.size(); ++i) {
    Body body = make_dry_body(spec, i);
    if (body.wet) {
      const auto same = std::find_if(bodies.begin(), bodies.end(), [&](const Body& other) {
        return other.hull && uses_clusters(other) == uses_clusters(body) &&
               hydro::same_mesh(other.hull->mesh_B, body.spec->mesh_B);
      });
      body.hull = same != bodies.end() ? same->hull : make_hull_of(body);
    }
    bodies.push_back(std::move(body));
  }
  return bodies;
}

Freedom freedom(const Body& body, const hydro::BodyState& state) {
  if (!body.guide && !body.locked) return {};
  if (body.guide) return {.ways = ways(*body.guide, state)};
  return {.locked = body.spec->locked};
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

Matrix6d inertia_W(const Body& body, const Motion& motion) {
  return inertia_W(body, motion, motion.state.orientation.toRotationMatrix());
}

Matrix6d inertia_W(const Body& body, const Motion& motion, const Eigen::Matrix3d& R_WB) {
  if (motion.added_B) return turned_matrix(R_WB, body.rigid_B + *motion.added_B);
  Matrix6d inertia = body.rigid_B;
  inertia.bottomRightCorner<3, 3>() = R_WB * body.spec->inertia_B * R_WB.transpose();
  return inertia;
}

hydro::BodyState state_after_drift(const Body& body, const Surroundings& around,
                                   const Motion& motion, double time) {
  if (!body.guide && !body.locked && !motion.added_B)
    return drifted(*body.spec, motion.state, time);
  const Matrix6d S = body.rigid_B + motion.added();
  if (body.guide) return slid(*body.guide, S, motion.state, time);
  if (!body.locked) return drifted(S, motion.state, around.current(), time);
  return held(body.spec->locked, body.spec->initial,
              drifted(S, body.spec->locked, motion.state, around.current(), time));
}

void drift(const Body& body, const Surroundings& around, Motion& motion, double time) {
  if (!motion.ledger) {
    motion.state = state_after_drift(body, around, motion, time);
    return;
  }
  const Motion before = motion;
  motion.state = state_after_drift(body, around, motion, time);
  book_drift(body, around, before, time, motion);
}

hydro::BodyState displaced(const Body& body, hydro::BodyState state, const Vector6d& change) {
  state.position += change.head<3>();
  state.orientation = turned_by(change.tail<3>(), state.orientation);
  if (body.guide) return guided(*body.guide, state);
  return body.locked ? held(body.spec->locked, body.spec->initial, state) : state;
}

Matrix6d added_mass(const Body& body, const Surroundings& around, const hydro::BodyState& state,
                    double time) {
  return body.adds ? body.spec->added_mass->at(state, *around.sea, time)
                   : Matrix6d(Matrix6d::Zero());
}

void set_added_mass(Motion& motion, const Matrix6d& added_B, double step) {
  motion.added_rate_B = unless_zero((added_B - motion.added()) / step);
  motion.added_B = unless_zero(added_B);
}

Matrix6d expected_added_mass(const Body& body, const Motion& motion, double step) {
  const Matrix6d last = motion.added();
  if (!motion.added_rate_B) return last;
  const Matrix6d expected = last + step * *motion.added_rate_B;
  // Beyond an end, such as a body's leaving the water, the rate leads to what is no mass.
  const hydro::Cholesky6 left(0.99 * body.rigid_B + expected);
  return left.positive_definite() ? expected : last;
}

bool same_added_mass(const Body& body, const Matrix6d& a, const Matrix6d& b) {
  const Vector6d scale = (body.rigid_B + a).diagonal().cwiseSqrt().cwiseInverse();
  return (scale.asDiagonal() * (a - b) * scale.asDiagonal()).cwiseAbs().maxCoeff() <= 1e-9;
}

bool nearly_met(const Body& body, const Matrix6d& start_B, const Matrix6d& taken_B,
                const Matrix6d& found_B) {
  // What is left of a difference after a pass is this much of the inertia, or less.
  const double off = part_of_inertia(body, taken_B, found_B - taken_B);
  const double change = part_of_inertia(body, taken_B, found_B - start_B);
  return off * std::max(off, change) <= kUnmetInertia;
}

Motion settled(const Body& body, const Surroundings& around, const Motion& before,
               const Matrix6d& added_B) {
  Motion motion = before;
  const Eigen::Matrix3d R_WB = motion.state.orientation.toRotationMatrix();
  const Matrix6d change = turned_matrix(R_WB, added_B - motion.added());
  const Vector6d u = inertia_change(inertia_W(body, motion), change, freedom(body, motion.state),
                                    velocity(motion.state, around.current()))
                         .velocity;
  motion.state = with_velocity(motion.state, u, around.current());
  motion.added_B = unless_zero(added_B);
  motion.added_rate_B.reset();
  if (motion.ledger) book_added_mass(body, around, before, motion);
  return motion;
}

hydro::Wrench pull_on(const Body& body, const hydro::BodyState& state) {
  const Eigen::Matrix3d R_WB = state.orientation.toRotationMatrix();
  return wrench(*body.pull, inertia_W(body, body.motion, R_WB), state);
}

hydro::Wrench find_loads(Body& body, const Surroundings& around, const hydro::BodyState& state,
                         double time) {
  body.loads.applied.clear();
  for (const AppliedLoad& load : body.spec->loads)
    body.loads.applied.push_back(wrench(load, state, time));
  if (body.pull) body.loads.applied.push_back(pull_on(body, state));
  body.loads.weight = {.force = {0, 0, -body.spec->mass * around.gravity}};
  if (body.wet) {
    const auto start = std::chrono::steady_clock::now();
    ++body.cost.evaluations;
    find_water_loads(body, around, state, time);
    body.cost.load_seconds +=
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  const hydro::Wrench total = body.loads.total();
  if (!total.force.allFinite() || !total.moment.allFinite())
    throw MotionFault(body, load_fault(body.loads).value());
  return total;
}

void check_state(const Body& body, const hydro::BodyState& state) {
  if (const auto fault = state_fault(state))
    throw MotionFault(body, *fault + " after the step; " + largest_load(body.loads));
}

}  // namespace engine
