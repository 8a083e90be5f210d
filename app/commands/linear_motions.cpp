#include "app/commands/linear_motions.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <utility>

#include "app/assembly/linear_body.h"
#include "app/base/words.h"
#include "hydro/airy_waves.h"
#include "hydro/radiation/froude_krylov.h"
#include "hydro/radiation/long_waves.h"

namespace app {
namespace {

using hydro::Matrix6d;
using std::numbers::pi;

LinearMotions motions_of(const assembly::BuiltScene& built, std::size_t i,
                         assembly::RadiationStore& store, Reporter& reporter) {
  const engine::BodySpec& spec = built.spec.bodies[i];
  const assembly::RadiationChoice& choice = built.radiation[i].choice;
  assembly::LinearTerms terms =
      assembly::linear_terms(built.spec, static_cast<engine::BodyId>(i), *choice.pose);
  LinearMotions motions{.name = spec.name,
                        .body = terms.body,
                        .mesh_B = engine::outside_B(spec),
                        .pose = *choice.pose,
                        .sea = *built.spec.sea,
                        .heading = terms.heading,
                        .left_out = std::move(terms.left_out)};
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
  motions.diffraction = std::make_shared<const hydro::DiffractionLoad>(
      hydro::balanced_diffraction(data, motions.memory));

  const Matrix6d turn = hydro::turn_of_heading(motions.heading);
  motions.body.inertia += turn * (sea.density * data.infinite_added_mass) * turn.transpose();
  return motions;
}

/// Why a body has no motions; empty if it has.
std::string reason_against(const assembly::BuiltScene& built, std::size_t i) {
  const assembly::RadiationChoice& choice = built.radiation[i].choice;
  if (choice.pose)
    return assembly::has_joint(built.spec, static_cast<engine::BodyId>(i))
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
