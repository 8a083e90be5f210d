#include "engine/step/substep.h"

#include <algorithm>
#include <cassert>
#include <optional>

#include "engine/base/constants.h"
#include "engine/base/stopwatch.h"
#include "engine/hollows/flooding.h"
#include "engine/hollows/streams.h"
#include "engine/motion/energy.h"
#include "engine/step/constrained_update.h"
#include "engine/step/joint_closing.h"
#include "engine/step/substep_limit.h"

namespace engine {
namespace {

/// Δu over the substep, by the history of accelerations.
Vector6d change_by_history(const Motion& halfway, double h) {
  return h * rotate(halfway.state.orientation.toRotationMatrix(),
                    halfway.accelerations.expected(h / 2));
}

/// Sets what a substep takes as constant: the water about a body, its wake halfway, and its rotors.
void hold_surroundings(const SubstepBody& b, double time, double h, Motion& motion) {
  {
    std::optional<Stopwatch> stopwatch;
    if (b.body().has_flow) stopwatch.emplace(b.moving->cache.sea_seconds);
    motion.flow = flow_about(b.body(), motion.state, time, h / 2);
  }
  advance_wake(b.body(), h / 2, motion);
  if (b.moving->machines) motion.rotors_B = b.moving->machines->rotors_B(b.id, time + h / 2);
}

/// Drifts a free body to the middle of the substep, from its corrected state (E9).
void begin_free(SubstepBody& b, double time, double h) {
  b.halfway = b.moving->motion;
  if (b.halfway.constrained) b.halfway.accelerations.clear();
  b.halfway.constrained = false;
  hold_surroundings(b, time, h, b.halfway);
  b.correction = find_correction(b.body(), b.halfway, h);
  if (b.correction) correct(b.body(), *b.correction, 1, b.halfway);
  b.start = b.halfway.state;
  drift(b.body(), b.halfway, h / 2);
  b.predicted = change_by_history(b.halfway, h);
}

/// Takes what the first linearisation of the loads needs from the last substep.
void begin_constrained(SubstepBody& b, double h) {
  const Motion& motion = b.moving->motion;
  b.start = motion.state;
  b.load_acceleration_W = motion.load_acceleration_W;
  // A contact of the last or of this substep says nothing of the next change.
  const bool smooth = b.halfway.constrained && !b.touching;
  b.predicted = smooth ? change_by_history(b.halfway, h) : Vector6d(Vector6d::Zero());
}

/// A in a state at or near the end of the substep, in the axes of the body halfway.
Matrix6d added_mass_halfway(const SubstepBody& b, const Matrix6d& added_B,
                            const hydro::BodyState& at) {
  return after_turn(b.body(), added_B, b.halfway.carried_water.get(),
                    at.orientation.conjugate() * b.halfway.state.orientation);
}

/// Finds A where the body is expected at the end of the substep: one in contact goes on as it did.
void expect_added_mass(SubstepBody& b, double end, double h) {
  const Stopwatch stopwatch(b.moving->cache.seconds);
  const hydro::BodyState& halfway = b.halfway.state;
  const Vector6d change = b.touching ? Vector6d(h * b.moving->motion.acceleration_W) : b.predicted;
  const Vector6d u = velocity(halfway, Eigen::Vector3d::Zero()) + change;
  b.added_at = displaced(b.body(), halfway, h / 2 * u);
  const Matrix6d added_B = added_mass(b.body(), b.added_at, b.halfway.carried_water.get(), end);
  b.added_B = added_mass_halfway(b, added_B, b.added_at);
}

/// True if the body has ended so near to the pose of `added_B` that its added mass is the same, if
/// that goes on to change as it has on the way to there. In waves, and with water in the body, it
/// does not tell how the added mass changes with the pose.
bool ends_as_expected(const SubstepBody& b) {
  const Environment& environment = b.body().environment;
  if (environment.uneven() || b.end.carried_water) return false;
  const double error = pose_distance(b.body(), b.added_at, b.end.state);
  const double path = dip_distance(b.body(), b.start, b.added_at);
  const double change = scaled_change(b.body(), b.added_B, b.added_B - b.halfway.added());
  return change > 0 && change * error <= kForeseenAddedMass * path;
}

/// The load of the rows of an island on a body: moment about the centre of mass, in W.
Vector6d row_load(const Island& island, const SubstepBody& b) {
  Vector6d load = Vector6d::Zero();
  for (const ForceRow& row : island.rows) {
    if (row.first != b.id && row.second != b.id) continue;
    const Eigen::Vector3d push = (row.second == b.id ? row.force : -row.force) * row.direction_W;
    if (row.turns)
      load.tail<3>() += push;
    else
      load += to_vector6(push, (row.point_W - b.halfway.state.position).cross(push));
  }
  return load;
}

/// The second half of the substep, with the added mass of its end.
void finish(const Island& island, SubstepBody& b, double h) {
  const bool constrained = island.constrained;
  const VelocityUpdate& update = b.update;
  const Eigen::Matrix3d R_BW = b.midpoint.R_WB.transpose();
  Motion& end = b.end = b.halfway;
  if (b.body().has_added_mass) set_added_mass(end, b.added_B);
  // Explicit changes do not follow from implicit ones, nor from those by contacts. Under joints an
  // implicit change is left out of the history, so that what the joints do to it is judged.
  const bool tells = !b.touching && !(constrained && update.implicit);
  if (update.implicit || update.unpredicted || b.touching) end.accelerations.clear();
  if (tells) end.accelerations.add(1 / h * rotate(R_BW, update.change), h, b.body().radius);
  if (!b.touching && !update.implicit) end.accelerations.set_slope(rotate(R_BW, update.slope));
  end.constrained = constrained;
  end.acceleration_W = update.change / h;
  end.load_acceleration_W = b.load_acceleration_W;
  end.state = with_velocity(end.state, b.midpoint.after + update.change, end.flow);
  check_state(*b.moving, end.state);
  advance_memory(b.body(), b.midpoint, update.change, b.moving->cache.memory_rule, end);
  if (end.work) {
    const Vector6d reaction = rotate(b.midpoint.R_WB, b.reaction_B);
    const Vector6d rows = row_load(island, b);
    record_update(*b.moving, b.midpoint,
                  {.change = update.change,
                   .h = h,
                   .implicit = update.implicit,
                   .reaction = constrained ? &reaction : nullptr,
                   .rows = island.rows.empty() ? nullptr : &rows},
                  end);
  }
  drift(b.body(), end, h / 2);
  end_wake(b.body(), b.start, h, end);
  check_state(*b.moving, end.state);
  const double spin = std::max(b.start.angular_velocity.norm(), end.state.angular_velocity.norm());
  if (spin * h > kLargestTrendTurn) end.accelerations.clear();
}

/// Velocity, in W, at which reactions do their work over the substep.
Vector6d working_velocity(const SubstepBody& b) {
  return b.midpoint.after + b.update.change / 2 + to_vector6(b.end.flow, Eigen::Vector3d::Zero());
}

/// Work of the rows of an island on a body over the substep [J].
double row_work(const Island& island, const SubstepBody& b, double h) {
  if (island.rows.empty()) return 0;
  return h * row_load(island, b).dot(working_velocity(b));
}

/// True if the update changes the motion by much more or less than extrapolation predicts.
bool is_unpredictable(const SubstepBody& b, double h) {
  const AccelerationHistory& history = b.halfway.accelerations;
  const Eigen::Matrix3d R_BW = b.midpoint.R_WB.transpose();
  const double radius = b.body().radius;
  const Vector6d error = rotate(R_BW, b.update.change) - h * history.expected(h / 2);
  const Vector6d after = b.midpoint.after + b.update.change;
  return scaled_norm(error, radius) > kAbruptLoad * scaled_norm(after, radius);
}

/// True if the loads halfway were those of a dry body.
bool was_dry(const SubstepBody& b) {
  const hydro::Wrench water = b.moving->cache.loads.water.total();
  return water.force.isZero(0) && water.moment.isZero(0);
}

/// True if the loads halfway may not have been those on the way of a free body.
bool is_abrupt(const SubstepBody& b, double h) {
  if (b.update.implicit || !b.body().wet) return b.update.implicit;
  if (b.end.state.angular_velocity.norm() * h > kJudgedTurn || is_unpredictable(b, h) ||
      !can_be_followed(b.body(), b.end, h))
    return true;
  const SurfaceCrossing crossing = surface_crossing(b.body(), b.start, b.end.state);
  return crossing.abrupt() ||
         (crossing.meets && (!is_smooth(b.end.accelerations, h) || was_dry(b)));
}

/// True if the update counted added mass that the body has not reached, because that mass has
/// slowed it: a flat bottom that would meet the surface within the substep ends just above it.
bool is_stopped_short(const SubstepBody& b, const Matrix6d& found_B) {
  const Vector6d inertia = (b.body().rigid_B + b.added_B).diagonal();
  const auto sum = [&](const Matrix6d& change) {
    return change.diagonal().cwiseQuotient(inertia).sum();
  };
  return sum(b.added_B - b.halfway.added()) > 0 && sum(found_B - b.added_B) < 0;
}

/// Finds the added mass of the final poses, for another pass of updates. After the last pass the
/// bodies share their momentum with it (E4), except where a body is stopped short: it keeps the
/// added mass of its update, which the next substep would otherwise count again.
/// @return the worst agreement with what the updates were taken with
AddedMassMatch match_added_mass(Island& island, double time, bool last_pass) {
  auto worst = AddedMassMatch::equal;
  for (SubstepBody* b : island.bodies) {
    if (!b->body().has_added_mass || ends_as_expected(*b)) continue;
    const Stopwatch stopwatch(b->moving->cache.seconds);
    const Matrix6d added_B = added_mass(b->body(), b->end.state, b->end.carried_water.get(), time);
    const Matrix6d found_B = added_mass_halfway(*b, added_B, b->end.state);
    const auto match = compare_added_mass(b->body(), b->halfway.added(), b->added_B, found_B);
    if (match == AddedMassMatch::equal) continue;
    worst = std::max(worst, match);
    if (last_pass && match == AddedMassMatch::distant && is_stopped_short(*b, found_B)) continue;
    if (last_pass) b->end = share_momentum(b->body(), b->end, added_B);
    b->added_B = found_B;
    b->added_at = b->end.state;
  }
  return worst;
}

/// Lets water run between the pockets of a body and the sea. Under a height field it may come from
/// above the still water level, a pump lifts it, and trapped air pushes it out: this brings energy.
void let_water_in(SubstepBody& b, double time, double h) {
  const std::shared_ptr<const CarriedWater> carried = b.end.carried_water;
  const std::vector<double> rates = pump_rates(*b.moving, time - h / 2);
  let_water_run(b.body(), b.moving->motion.state, time, h, rates, b.end);
  b.inflow_work = 0;
  const Environment& environment = b.body().environment;
  const bool driven = environment.uneven() || pumping(rates) || b.body().spec->air;
  const bool judged = driven && must_not_gain_energy(b.body());
  if (!judged || b.end.carried_water == carried) return;
  Motion before = b.end;
  before.carried_water = carried;
  const double brought = potential_energy(b.body(), b.end) - potential_energy(b.body(), before);
  b.inflow_work = std::max(0.0, brought);
}

/// Counts the substep, tells whether it is to be judged, takes the correction back, and lets water
/// run. @param time   At the end of the substep [s].
void conclude(const Island& island, SubstepBody& b, double time, double h) {
  const bool constrained = island.constrained;
  Counts& counts = b.moving->counts;
  counts.implicit += b.update.implicit;
  counts.unconverged += b.update.unsolved;
  counts.constrained += constrained;
  ++counts.substeps;
  b.row_work = constrained ? row_work(island, b, h) : 0;
  b.needs_energy_check = constrained
                             ? b.body().wet && crosses_surface(b.body(), b.start, b.end.state)
                             : is_abrupt(b, h);
  if (b.correction) {
    const auto after = find_correction(b.body(), b.end, h).value_or(*b.correction);
    correct(b.body(), after, -1, b.end);
  }
  let_water_in(b, time, h);
}

/// Solves an island with its rows, again where they turn out to pull much harder.
void solve_constrained(const StepContext& context, Island& island, double time, double h) {
  for (int i = 0; i < kMostTensionSolves; ++i) {
    context.rig.find_rows(context.bodies, island, time, h);
    constrained_update(context, island, time, h);
    if (Rig::bounds_tensions(island)) break;
  }
  context.rig.find_reactions(context.bodies, island);
}

}  // namespace

void drift_halfway(SubstepBody& b, double time, double h) {
  b.halfway = b.moving->motion;
  hold_surroundings(b, time, h, b.halfway);
  drift(b.body(), b.halfway, h / 2);
  check_state(*b.moving, b.halfway.state);
}

void take_substep(const StepContext& context, Island& island, double time, double h) {
  assert(h > 0 && !island.bodies.empty());
  assert(std::ranges::is_sorted(island.bodies, {}, &SubstepBody::id));
  const bool constrained = island.constrained;
  for (SubstepBody* b : island.bodies) {
    context.check_stop();
    constrained ? begin_constrained(*b, h) : begin_free(*b, time, h);
    if (b->body().has_added_mass) expect_added_mass(*b, time + h, h);
  }
  context.rig.find_loads(context.bodies, island, time + h / 2, h);
  // Updates are repeated until the added mass that they are taken with is that of the final pose.
  const int limit = constrained ? kMostConstrainedPasses : kMostFreePasses;
  auto match = AddedMassMatch::distant;
  for (int pass = 1; pass <= limit && match != AddedMassMatch::equal; ++pass) {
    for (SubstepBody* b : island.bodies) {
      const bool projects = !constrained && b->body().has_added_mass;
      b->midpoint = make_midpoint(b->body(), b->halfway, b->added_B,
                                  projects ? mobility(b->body(), b->halfway.state) : Mobility{});
      WaveMemoryRule& rule = b->moving->cache.memory_rule;
      b->midpoint.memory = memory_effect(b->body(), b->midpoint, time + h / 2, h, rule);
      if (b->midpoint.memory)
        b->midpoint.memory->turning = turning_load(b->body(), b->midpoint, time + h / 2, rule);
      b->midpoint.rig_inertia = b->rig_inertia;
    }
    if (constrained) {
      solve_constrained(context, island, time + h / 2, h);
    } else {
      for (SubstepBody* b : island.bodies) {
        context.check_stop();
        b->update = pass == 1
                        ? free_update(*b->moving, b->midpoint, time + h / 2, h)
                        : resolve_with_inertia(*b->moving, b->midpoint, b->update, time + h / 2, h);
      }
    }
    for (SubstepBody* b : island.bodies) finish(island, *b, h);
    if (constrained) close_joints(context, island);
    if (match == AddedMassMatch::near) break;
    match = match_added_mass(island, time + h, pass == limit);
  }
  if (constrained) stop_joints(context, island, h);
  for (SubstepBody* b : island.bodies) conclude(island, *b, time + h, h);
}

}  // namespace engine
