#include "app/assembly/linear_body.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/rig/line_pull.h"
#include "hydro/radiation/wave_frame.h"
#include "hydro/statics/hydrostatics.h"

namespace assembly {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using hydro::cross_matrix;
using hydro::Matrix6d;

/// The place of a line's end, its body in the mean pose if that is the one of the motions.
engine::LineEnd end_of(const engine::AttachmentPoint& point, engine::BodyId body,
                       const hydro::BodyState& mean, const engine::SimulationSpec& spec) {
  if (point.body == engine::kWorld) return {.place_W = point.at};
  const hydro::BodyState& state =
      point.body == body ? mean : spec.bodies[static_cast<std::size_t>(point.body)].initial;
  return {.place_W = state.position + state.orientation * point.at};
}

/// Adds a line, whose other end is at rest: with the point r of the body, its force F on it and
/// J = (1, −[r]×), C = Jᵀ k J less the turn of the force's lever, [F]× [r]×.
void add_stiffness(const engine::LineSpec& line, engine::BodyId body, const hydro::BodyState& mean,
                   const engine::SimulationSpec& spec, hydro::LinearBody& linear) {
  const engine::LineEnd first = end_of(line.first, body, mean, spec),
                        second = end_of(line.second, body, mean, spec);
  const engine::LinePull pull =
      engine::pull_of(line, {.length = line.length}, first, second, nullptr, 0, std::nullopt);
  const bool is_first = line.first.body == body;
  const Matrix3d r = cross_matrix((is_first ? first : second).place_W - mean.position);
  const Matrix3d force = cross_matrix(is_first ? pull.force_W : Vector3d(-pull.force_W));
  Eigen::Matrix<double, 3, 6> J;
  J << Matrix3d::Identity(), -r;
  linear.stiffness += J.transpose() * pull.stiffness * J;
  linear.stiffness.bottomRightCorner<3, 3>() -= force * r;
  linear.damping += J.transpose() * pull.damping * J;
}

void add_lines(const engine::SimulationSpec& spec, engine::BodyId body,
               const hydro::BodyState& mean, LinearTerms& terms) {
  for (const engine::LineSpec& line : spec.lines) {
    const bool first = line.first.body == body, second = line.second.body == body;
    if (first == second) continue;  // A line within the body does not move it.
    add_stiffness(line, body, mean, spec, terms.body);
    if (line.first.body != engine::kWorld && line.second.body != engine::kWorld)
      terms.left_out.push_back(fmt::format("motion of the other body that {} holds", line.name));
    if (line.inertia) terms.left_out.push_back(fmt::format("inertia of {}", line.name));
  }
}

}  // namespace

Matrix6d hydrostatic_stiffness(const hydro::TriMesh& mesh_B, const hydro::MeanPose& pose,
                               const hydro::Sea& sea) {
  const hydro::TriMesh mesh_H = hydro::transformed(mesh_B, Eigen::Isometry3d(pose.orientation));
  Matrix6d stiffness = Matrix6d::Zero();
  stiffness.block<3, 3>(2, 2) =
      sea.density * sea.gravity *
      hydro::restoring_stiffness(hydro::hydrostatics(mesh_H, pose.height));
  return stiffness;
}

LinearTerms linear_terms(const engine::SimulationSpec& spec, engine::BodyId id,
                         const hydro::MeanPose& pose) {
  const engine::BodySpec& body = spec.bodies[static_cast<std::size_t>(id)];
  const hydro::Sea& sea = *spec.sea;
  const hydro::WaveFrame frame{.R_WH = body.initial.orientation * pose.orientation.conjugate()};
  LinearTerms terms{.heading = frame.heading()};
  const Matrix6d turn = hydro::turn_of_heading(terms.heading);
  const Matrix3d R_HB = pose.orientation.toRotationMatrix();
  Matrix6d inertia = Matrix6d::Zero();
  inertia.topLeftCorner<3, 3>() = body.mass * Matrix3d::Identity();
  inertia.bottomRightCorner<3, 3>() = R_HB * body.inertia_B * R_HB.transpose();
  terms.body.inertia = turn * inertia * turn.transpose();
  terms.body.stiffness =
      turn * hydrostatic_stiffness(engine::outside_B(body), pose, sea) * turn.transpose();
  terms.body.locked = body.locked;
  hydro::BodyState mean = body.initial;
  mean.position.z() = sea.level + pose.height;
  mean.orientation = Eigen::AngleAxisd(terms.heading, Vector3d::UnitZ()) * pose.orientation;
  add_lines(spec, id, mean, terms);
  if (!body.interior_water.empty()) terms.left_out.emplace_back("the water inside the body");
  return terms;
}

bool has_joint(const engine::SimulationSpec& spec, engine::BodyId body) {
  return std::any_of(spec.joints.begin(), spec.joints.end(), [&](const auto& joint) {
    return joint.first == body || joint.second == body;
  });
}

}  // namespace assembly
