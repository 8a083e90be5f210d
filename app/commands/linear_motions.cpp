#include "app/commands/linear_motions.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "app/base/words.h"
#include "engine/rig/line_pull.h"
#include "hydro/airy_waves.h"
#include "hydro/radiation/froude_krylov.h"
#include "hydro/statics/hydrostatics.h"

namespace app {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using hydro::cross_matrix;
using hydro::Matrix6d;
using std::numbers::pi;

/// −∂(F, M)/∂ξ of a hydrostatic body in H.
Matrix6d restoring(const hydro::TriMesh& mesh_B, const hydro::MeanPose& pose,
                   const hydro::Sea& sea) {
  const hydro::TriMesh mesh_H = hydro::transformed(mesh_B, Eigen::Isometry3d(pose.orientation));
  Matrix6d stiffness = Matrix6d::Zero();
  stiffness.block<3, 3>(2, 2) =
      sea.density * sea.gravity *
      hydro::restoring_stiffness(hydro::hydrostatics(mesh_H, pose.height));
  return stiffness;
}

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
               const hydro::BodyState& mean, LinearMotions& motions) {
  for (const engine::LineSpec& line : spec.lines) {
    const bool first = line.first.body == body, second = line.second.body == body;
    if (first == second) continue;  // A line within the body does not move it.
    add_stiffness(line, body, mean, spec, motions.body);
    if (line.first.body != engine::kWorld && line.second.body != engine::kWorld)
      motions.left_out.push_back(fmt::format("motion of the other body that {} holds", line.name));
  }
  if (spec.moordyn && std::any_of(spec.moordyn->points.begin(), spec.moordyn->points.end(),
                                  [&](const auto& point) { return point.body == body; }))
    motions.left_out.emplace_back("lines of MoorDyn");
}

bool has_joint(const engine::SimulationSpec& spec, engine::BodyId body) {
  return std::any_of(spec.joints.begin(), spec.joints.end(), [&](const auto& joint) {
    return joint.first == body || joint.second == body;
  });
}

LinearMotions motions_of(const assembly::BuiltScene& built, std::size_t i,
                         assembly::RadiationStore& store, Reporter& reporter) {
  const engine::BodySpec& spec = built.spec.bodies[i];
  const assembly::RadiationChoice& choice = built.radiation[i].choice;
  const hydro::WaveFrame frame{.R_WH =
                                   spec.initial.orientation * choice.pose->orientation.conjugate()};
  LinearMotions motions{.name = spec.name,
                        .mesh_B = engine::outside_B(spec),
                        .pose = *choice.pose,
                        .sea = *built.spec.sea,
                        .heading = frame.heading()};
  const hydro::Sea& sea = motions.sea;
  assembly::StoredRadiation stored;
  if (!choice.database)
    stored = assembly::solved_radiation(spec.name,
                                        {.mesh_B = motions.mesh_B,
                                         .pose = motions.pose,
                                         .water = {.gravity = sea.gravity, .depth = sea.depth}},
                                        store, reporter);
  const hydro::RadiationData& data =
      choice.database ? choice.database->found.data : stored.solution->data;
  if (data.headings.empty())
    throw scene::InputError(choice.database->file.string(),
                            spec.name + ": has no loads of waves, by which bodies respond");
  motions.memory = stored.memory ? *stored.memory : hydro::fit_memory(data);
  motions.diffraction = std::make_shared<const hydro::DiffractionLoad>(data);

  const Matrix6d turn = hydro::turn_of_heading(motions.heading);
  const Matrix3d R_HB = motions.pose.orientation.toRotationMatrix();
  Matrix6d inertia = sea.density * data.infinite_added_mass;
  inertia.topLeftCorner<3, 3>() += spec.mass * Matrix3d::Identity();
  inertia.bottomRightCorner<3, 3>() += R_HB * spec.inertia_B * R_HB.transpose();
  motions.body.inertia = turn * inertia * turn.transpose();
  motions.body.stiffness = turn * restoring(motions.mesh_B, motions.pose, sea) * turn.transpose();
  motions.body.locked = spec.locked;
  hydro::BodyState mean = spec.initial;
  mean.position.z() = sea.level + motions.pose.height;
  mean.orientation =
      Eigen::AngleAxisd(motions.heading, Vector3d::UnitZ()) * motions.pose.orientation;
  add_lines(built.spec, static_cast<engine::BodyId>(i), mean, motions);
  if (!spec.interior_water.empty()) motions.left_out.emplace_back("the water inside the body");
  return motions;
}

/// Why a body has no motions; empty if it has.
std::string reason_against(const assembly::BuiltScene& built, std::size_t i) {
  const assembly::RadiationChoice& choice = built.radiation[i].choice;
  if (choice.pose)
    return has_joint(built.spec, static_cast<engine::BodyId>(i))
               ? "it has a joint, and its motions are those of a body by itself"
               : "";
  return choice.reason.empty() ? "its radiation or added_mass is switched off" : choice.reason;
}

}  // namespace

RegularWave regular_wave(const hydro::Sea& sea, double period, double heading) {
  const double frequency = 2 * pi / period;
  const double along = sea.current.x() * std::cos(heading) + sea.current.y() * std::sin(heading);
  const auto k = hydro::wave_number(frequency, sea.depth, sea.gravity, along);
  if (!k)
    throw scene::InputError(
        "--periods", fmt::format("found {:g} s, and the current of {:g} m/s stops such a wave of "
                                 "heading {:g} deg",
                                 period, along, heading * 180 / pi));
  return {.period = period,
          .heading = heading,
          .frequency = frequency,
          .intrinsic = hydro::intrinsic_frequency(*k, sea.depth, sea.gravity),
          .wave_number = *k};
}

hydro::Loads6cd LinearMotions::in(const std::vector<RegularWave>& waves) const {
  hydro::Loads6cd found(6, static_cast<Eigen::Index>(waves.size()));
  if (waves.empty()) return found;
  std::vector<double> intrinsic;
  for (const RegularWave& wave : waves) intrinsic.push_back(wave.intrinsic);
  const double from_bow = waves.front().heading - heading;
  const std::vector<hydro::Loads6cd> froude_krylov = hydro::froude_krylov(
      mesh_B, pose, {.gravity = sea.gravity, .depth = sea.depth}, intrinsic, {from_bow});
  const hydro::Matrix6cd turn = hydro::turn_of_heading(heading).cast<std::complex<double>>();
  for (std::size_t w = 0; w < waves.size(); ++w) {
    const hydro::Vector6cd scattered = waves[w].frequency / waves[w].intrinsic *
                                       diffraction->coefficients(waves[w].intrinsic, from_bow);
    const hydro::Vector6cd load = sea.density * (froude_krylov[w].col(0) + scattered);
    const hydro::Matrix6cd waves_W =
        sea.density * turn * hydro::response(memory, waves[w].frequency) * turn.adjoint();
    found.col(static_cast<Eigen::Index>(w)) =
        turn.adjoint() * hydro::linear_response(body, waves_W, waves[w].frequency, turn * load);
  }
  return found;
}

std::vector<LinearMotions> linear_motions(const std::filesystem::path& file,
                                          const assembly::BuiltScene& built,
                                          const std::string& only, assembly::RadiationStore& store,
                                          Reporter& reporter) {
  std::vector<LinearMotions> bodies;
  std::string why;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < built.radiation.size(); ++i) {
    const std::string& name = built.spec.bodies[i].name;
    names.push_back(name);
    if (!only.empty() && name != only) continue;
    const std::string reason = reason_against(built, i);
    if (reason.empty())
      bodies.push_back(motions_of(built, i, store, reporter));
    else
      why += fmt::format("; {}: {}", name, reason);
  }
  if (!only.empty() && std::find(names.begin(), names.end(), only) == names.end())
    throw scene::InputError("--body", fmt::format("found {}, expected a body of the scene{}", only,
                                                  did_you_mean(only, names)));
  if (bodies.empty()) throw scene::InputError(file, "no body has motions by linear theory" + why);
  return bodies;
}

}  // namespace app
