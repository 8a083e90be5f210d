#include <algorithm>

#include "engine/base/constants.h"
#include "engine/constraints/island.h"
#include "engine/rig/rig.h"
#include "hydro/decompositions.h"

namespace engine {
namespace {

using Eigen::Vector3d;

/// The body of an island; null if it is not in it.
SubstepBody* find(Island& island, BodyId id) {
  const auto place = std::lower_bound(island.bodies.begin(), island.bodies.end(), id,
                                      [](const SubstepBody* b, BodyId i) { return b->id < i; });
  return place != island.bodies.end() && (*place)->id == id ? *place : nullptr;
}

/// Adds a force at the point r from the centre of mass.
void add_force(hydro::Wrench& load, const Vector3d& force, const Vector3d& r) {
  load.force += force;
  load.moment += r.cross(force);
}

/// u·S⁻¹u for the direction of a unit force at r, or of a unit torque.
double mobility_along(const SubstepBody* b, const ForceRow& row) {
  if (!b) return 0;
  const Vector3d r = row.point_W - b->halfway.state.position;
  const Vector6d J = row.turns ? to_vector6(Vector3d::Zero(), row.direction_W)
                               : to_vector6(row.direction_W, r.cross(row.direction_W));
  return J.dot(hydro::Cholesky6(inertia_W(b->body(), b->midpoint)).solve(J));
}

const hydro::BodyState* state_in(const std::vector<MovingBody>& all, Island& island, BodyId id) {
  if (id == kWorld) return nullptr;
  const SubstepBody* b = find(island, id);
  return b ? &b->halfway.state : &all[id].motion.state;
}

}  // namespace

struct Rig::End {
  SubstepBody* body = nullptr;      ///< Null: it does not move.
  Vector3d r_W = Vector3d::Zero();  ///< From the centre of mass.
  LineEnd point;
};

Rig::End Rig::end_of(const std::vector<MovingBody>& all, Island& island,
                     const AttachmentPoint& point, double h, bool expected) const {
  if (point.body == kWorld) return {.body = nullptr, .point = {.place_W = point.at}};
  End end{.body = movable(point.body) ? find(island, point.body) : nullptr};
  const hydro::BodyState& state = *state_in(all, island, point.body);
  end.r_W = state.orientation * point.at;
  end.point.velocity_W = state.linear_velocity + state.angular_velocity.cross(end.r_W);
  if (end.body && expected) {
    const Vector6d& change = end.body->predicted;
    const Vector3d moved = change.head<3>() + change.tail<3>().cross(end.r_W);
    end.point.velocity_W += moved / 2;
    const Vector3d shift = h / 12 * moved;
    if (!island.constrained && shift.norm() <= kLargestShift * end.body->body().radius)
      end.r_W += shift;
  }
  end.point.place_W = state.position + end.r_W;
  return end;
}

LinePull Rig::pull_of_line(std::size_t index, const End& first, const End& second, double time) {
  LineState& state = lines_[index];
  const LinePull pull = pull_of(spec_->lines[index], length_at(index, time), first.point,
                                second.point, sea_, time, state.pull);
  if (pull.catenary) state.pull = {pull.catenary->horizontal, pull.catenary->vertical};
  return pull;
}

void Rig::add_line(const std::vector<MovingBody>& all, Island& island, std::size_t index,
                   double time, double h) {
  if (lines_[index].broken) return;
  const LineSpec& line = spec_->lines[index];
  const End first = end_of(all, island, line.first, h, true);
  const End second = end_of(all, island, line.second, h, true);
  const LinePull pull = pull_of_line(index, first, second, time);
  if (first.body) add_force(first.body->moving->rig_load, pull.force_W, first.r_W);
  if (second.body) add_force(second.body->moving->rig_load, -pull.force_W, second.r_W);
}

std::vector<Rig::LineToWorld> Rig::lines_to_world(const std::vector<MovingBody>& all,
                                                  Island& island, const SubstepBody& b, double time,
                                                  double h, bool expected) {
  std::vector<LineToWorld> lines;
  for (const std::size_t index : parts_[b.id].to_world) {
    if (lines_[index].broken) continue;
    const LineSpec& line = spec_->lines[index];
    const bool is_first = line.first.body == b.id;
    const End first = end_of(all, island, line.first, h, expected);
    const End second = end_of(all, island, line.second, h, expected);
    const LinePull pull = pull_of_line(index, first, second, time);
    const End& own = is_first ? first : second;
    const End& other = is_first ? second : first;
    const Vector3d path = other.point.place_W - own.point.place_W;
    const Vector3d rest_moves = -length_at(index, time).rate * path.stableNormalized();
    lines.push_back({.r_W = own.r_W,
                     .force_W = is_first ? pull.force_W : Vector3d(-pull.force_W),
                     .parting_W = own.point.velocity_W - rest_moves,
                     .stiffness = pull.stiffness,
                     .damping = pull.damping,
                     .mobility = mobility(b.id, is_first ? line.first.at : line.second.at)});
  }
  return lines;
}

void Rig::add_lines_to_world(const std::vector<MovingBody>& all, Island& island, SubstepBody& b,
                             double time, double h) {
  if (parts_[b.id].to_world.empty()) return;
  double stiffness = 0;
  hydro::Wrench load;
  for (const LineToWorld& line : lines_to_world(all, island, b, time, h, true)) {
    stiffness += (h * h * line.stiffness + 2 * h * line.damping).trace() * line.mobility;
    add_force(load, line.force_W, line.r_W);
  }
  if (stiffness > kStiffLine)
    load = add_implicit(lines_to_world(all, island, b, time, h, false), b, h);
  b.moving->rig_load += load;
}

hydro::Wrench Rig::add_implicit(const std::vector<LineToWorld>& lines, SubstepBody& b,
                                double h) const {
  const Eigen::Matrix3d R_WB = b.halfway.state.orientation.toRotationMatrix();
  const hydro::Cholesky6 S(rotate_tensor(R_WB, b.body().rigid_B + b.added_B));
  const double step = spec_->step;
  double springs = 0, dampers = 0;  // sums over the directions of (1/s)², and of 1/s
  const auto lever = [](const LineToWorld& line) {
    Eigen::Matrix<double, 3, 6> J;
    J << Eigen::Matrix3d::Identity(), -cross_matrix(line.r_W);
    return J;
  };
  for (const LineToWorld& line : lines) {
    const Eigen::Matrix<double, 3, 6> J = lever(line);
    Eigen::Matrix3d mobility;
    for (int i = 0; i < 3; ++i) mobility.col(i) = J * S.solve(J.row(i).transpose());
    springs += (line.stiffness * mobility).trace();
    dampers += (line.damping * mobility).trace();
  }
  const double damped = unresolved(std::max(step * std::sqrt(springs), step * dampers / 2));
  const auto [after, before] = spring_weights(damped, h, step);
  hydro::Wrench load;
  b.rig_inertia = Matrix6d::Zero();  // before rows add theirs
  for (const LineToWorld& line : lines) {
    const Vector3d ahead = h * (after - before) * line.stiffness * line.parting_W;
    add_force(load, line.force_W - ahead, line.r_W);
    const Eigen::Matrix3d X =
        h * h * after * line.stiffness + h * (0.5 + 0.5 * damped) * line.damping;
    *b.rig_inertia += lever(line).transpose() * X * lever(line);
  }
  return load;
}

void Rig::add_drive_load(const std::vector<MovingBody>& all, Island& island, std::size_t index,
                         double time) {
  const JointSpec& joint = spec_->joints[index];
  const Drive& drive = drives_[index];
  const JointBodies bodies{state_in(all, island, joint.first), state_in(all, island, joint.second)};
  const double effort = drive_load(joint.drive, *set_points_, time, drive.coordinate.value(bodies),
                                   drive.coordinate.rate(bodies), drive.stiff);
  if (effort == 0) return;
  const Vector3d push = effort * drive.coordinate.axis_W(bodies);
  const Vector3d place = drive.coordinate.place_W(bodies);
  for (const auto& [id, sign] : {std::pair(joint.first, -1.0), std::pair(joint.second, 1.0)}) {
    SubstepBody* b = movable(id) ? find(island, id) : nullptr;
    if (!b) continue;
    hydro::Wrench& load = b->moving->rig_load;
    if (drive.coordinate.turns())
      load.moment += sign * push;
    else
      add_force(load, sign * push, place - b->halfway.state.position);
  }
}

void Rig::add_lateral_inertia(const ForceRow& row, const End& end, const LineHold& hold,
                              double h) const {
  if (!end.body || !(row.tension_bound > 0)) return;
  const double lever = std::max(0.0, hold.pull_W.dot(end.r_W));
  const double square =
      sideways_phase(end.body->id, end.r_W, row.tension_bound, hold.distance, lever, h);
  if (square < kStiffLine) return;
  const double weight =
      h * h * spring_weights(unresolved(std::sqrt(square)), h, h).after * row.tension_bound;
  Matrix6d& more = *end.body->midpoint.rig_inertia;
  more.diagonal().head<3>().array() += weight / hold.distance;
  more.diagonal().tail<3>().array() += weight * (end.r_W.squaredNorm() / hold.distance + lever);
}

/// (hω)² of the motion across a line of length l under the tension T.
double Rig::sideways_phase(BodyId body, const Vector3d& r, double T, double l, double lever,
                           double h) const {
  const double turning = mobility(body, Vector3d::UnitX()) - 1 / spec_->bodies[body].mass;
  return h * h * T * (mobility(body, r) / l + lever * turning);
}

void Rig::find_loads(const std::vector<MovingBody>& all, Island& island, double time, double h) {
  for (SubstepBody* b : island.bodies) {
    b->moving->rig_load = {};
    b->rig_inertia.reset();
  }
  for (SubstepBody* b : island.bodies) {
    if (!acts_on_[b->id]) continue;
    for (const std::size_t line : parts_[b->id].lines) add_line(all, island, line, time, h);
    add_lines_to_world(all, island, *b, time, h);
    for (const std::size_t joint : parts_[b->id].drives) add_drive_load(all, island, joint, time);
    dynamic_->add_update(time, h, *b);
  }
}

void Rig::add_line_row(const std::vector<MovingBody>& all, Island& island, std::size_t index,
                       double found, double time, double h) {
  if (lines_[index].broken) return;
  const LineSpec& line = spec_->lines[index];
  const End first = end_of(all, island, line.first, h, false);
  const End second = end_of(all, island, line.second, h, false);
  const Vector3d path = first.point.place_W - second.point.place_W;
  const double distance = path.norm();
  const LineLength length = length_at(index, time);
  if (distance == 0) return;
  // The tension pulls the second body to the first: J u = −l'.
  ForceRow row{.first = line.first.body,
               .second = line.second.body,
               .point_W = second.point.place_W,
               .direction_W = path / distance,
               .one_sided = line.kind == LineSpec::Kind::rope,
               .owner = index};
  const double rate = row.direction_W.dot(second.point.velocity_W - first.point.velocity_W);
  // A slack rope is a row, too: loads may bring it taut before the next substep.
  const RowTerms terms =
      row_terms({.stiffness = line.stiffness,
                 .damping = line.damping,
                 .missing = distance - length.length,
                 .rest_rate = -length.rate,
                 .rate = rate,
                 .mobility = mobility_along(first.body, row) + mobility_along(second.body, row),
                 .one_sided = row.one_sided},
                h, spec_->step);
  row.target = terms.target;
  row.compliance = terms.compliance;
  row.tension_bound = std::max(lines_[index].tension, found);
  for (const auto& [end, sign] : {std::pair(&first, -1.0), std::pair(&second, 1.0)}) {
    add_lateral_inertia(row, *end, {.pull_W = sign * row.direction_W, .distance = distance}, h);
    if (end->body)
      row.sideways = std::max(
          row.sideways, sideways_phase(end->body->id, end->r_W, 1, distance,
                                       std::max(0.0, sign * row.direction_W.dot(end->r_W)), h));
  }
  island.rows.push_back(row);
}

void Rig::add_drive_rows(const std::vector<MovingBody>& all, Island& island, std::size_t index,
                         double time, double h) {
  const JointSpec& joint = spec_->joints[index];
  const Drive& drive = drives_[index];
  if (!drive.rows) return;
  const JointBodies bodies{state_in(all, island, joint.first), state_in(all, island, joint.second)};
  const Vector3d axis = drive.coordinate.axis_W(bodies);
  const Vector3d place = drive.coordinate.place_W(bodies);
  const auto inverse_inertia = [&](BodyId id) {
    const SubstepBody* b = movable(id) ? find(island, id) : nullptr;
    if (!b) return 0.0;
    const Vector3d r = place - b->halfway.state.position;
    const Vector6d N = drive.coordinate.turns() ? to_vector6(axis.cross(-r), axis)
                                                : to_vector6(axis, Vector3d::Zero());
    return 1 / N.dot(inertia_W(b->body(), b->midpoint) * N);
  };
  const DriveState state{
      .q = drive.coordinate.value(bodies),
      .rate = drive.coordinate.rate(bodies),
      .inertia = 1 / (inverse_inertia(joint.first) + inverse_inertia(joint.second)),
      .step = spec_->step,
      .stiff = drive.stiff};
  for (ForceRow& row :
       drive_rows(joint.drive, *set_points_, time, h, state, drive.coordinate.turns())) {
    row.direction_W = row.sign * axis;
    row.point_W = place;
    row.first = joint.first;
    row.second = joint.second;
    row.owner = index;
    island.rows.push_back(row);
  }
}

void Rig::find_reactions(const std::vector<MovingBody>& all, Island& island) const {
  for (JointReaction& reaction : island.reactions) {
    const JointSpec& joint = spec_->joints[reaction.joint];
    reaction.place_W = drives_[reaction.joint].coordinate.place_W(
        {state_in(all, island, joint.first), state_in(all, island, joint.second)});
  }
}

void Rig::find_rows(const std::vector<MovingBody>& all, Island& island, double time, double h) {
  const std::vector<ForceRow> before = std::move(island.rows);
  island.rows.clear();
  const auto found = [&](std::size_t line) {
    const auto row = std::ranges::find_if(
        before, [line](const ForceRow& r) { return r.of_line && r.owner == line; });
    return row == before.end() ? 0.0 : row->force;
  };
  for (SubstepBody* b : island.bodies) {
    b->midpoint.rig_inertia = b->rig_inertia;
    if (constrains_[b->id] && !b->rig_inertia) b->midpoint.rig_inertia = Matrix6d::Zero();
  }
  for (SubstepBody* b : island.bodies) {
    if (!constrains_[b->id]) continue;
    for (const std::size_t line : parts_[b->id].rows)
      add_line_row(all, island, line, found(line), time, h);
    for (const std::size_t joint : parts_[b->id].drives)
      add_drive_rows(all, island, joint, time, h);
  }
  for (SubstepBody* b : island.bodies)
    if (b->midpoint.rig_inertia && b->midpoint.rig_inertia->isZero(0))
      b->midpoint.rig_inertia.reset();
}

bool Rig::bounds_tensions(const Island& island) {
  return std::ranges::all_of(island.rows, [](const ForceRow& row) {
    return row.force <= kTensionExcess * row.tension_bound || row.force * row.sideways < kStiffLine;
  });
}

void Rig::add(const Island& island, double h, Record& record) {
  for (ForceRow row : island.rows) {
    row.force *= h;
    record.rows.push_back(row);
  }
  for (JointReaction reaction : island.reactions) {
    reaction.force_W *= h;
    reaction.moment_W *= h;
    record.reactions.push_back(reaction);
  }
}

void Rig::accept(const Record& record) {
  for (const ForceRow& row : record.rows) {
    if (row.of_line)
      lines_[row.owner].impulse += row.force;
    else
      joints_[row.owner].effort += row.sign * row.force;
    if (row.of_motor) joints_[row.owner].motor += row.sign * row.force;
  }
  for (const JointReaction& reaction : record.reactions) {
    JointState& joint = joints_[reaction.joint];
    const Vector3d arm = reaction.about_W - reaction.place_W;
    joint.force += reaction.force_W;
    joint.moment += reaction.moment_W + arm.cross(reaction.force_W);
  }
}

}  // namespace engine
