#include "app/hydrostatics/natural_periods.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <optional>

#include "app/assembly/build_added_mass.h"
#include "app/assembly/build_radiation.h"
#include "app/assembly/linear_body.h"
#include "hydro/added_mass/constant_added_mass.h"
#include "hydro/added_mass/deep_added_mass.h"

namespace app {
namespace {

using hydro::Matrix6d;
using hydro::Vector6d;
using Model = scene::AddedMass::Model;

constexpr std::array<const char*, 6> kModeNames = {"surge", "sway",  "heave",
                                                   "roll",  "pitch", "yaw"};

/// Part of the potential energy of a mode from which on a motion names it [-].
constexpr double kNamedShare = 0.2;

NaturalPeriod period_of(const hydro::NaturalMode& mode, const hydro::LinearBody& body,
                        double heading) {
  const Matrix6d turn = hydro::turn_of_heading(heading);
  const Vector6d shape = turn.transpose() * mode.shape;
  const Vector6d load = turn.transpose() * (body.stiffness * mode.shape);
  const Vector6d share = 0.5 * shape.cwiseProduct(load);  // of the energy 1
  std::array<Eigen::Index, 6> order = {0, 1, 2, 3, 4, 5};
  std::ranges::stable_sort(order, [&](auto a, auto b) { return share[a] > share[b]; });
  NaturalPeriod period{.period = 2 * std::numbers::pi / mode.frequency,
                       .shape = shape / shape[order.front()]};
  for (const Eigen::Index i : order)
    if (i == order.front() || share[i] >= kNamedShare)
      period.motions.emplace_back(kModeNames[static_cast<std::size_t>(i)]);
  return period;
}

/// The added mass of a body in a pose, about its centre of mass, in H.
struct KnownAddedMass {
  Matrix6d matrix_H = Matrix6d::Zero();
  std::string source;
};

Matrix6d in_pose(const hydro::AddedMassModel& model, const hydro::MeanPose& pose,
                 const hydro::Sea& sea) {
  const hydro::Sea still{.density = sea.density, .gravity = sea.gravity, .depth = sea.depth};
  const Matrix6d matrix_B =
      model.at({.position = {0, 0, pose.height}, .orientation = pose.orientation}, still, 0);
  Matrix6d turn = Matrix6d::Zero();
  turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() = pose.orientation.toRotationMatrix();
  return turn * matrix_B * turn.transpose();
}

/// The added mass without waves that the scene gives a body, or that is stored.
std::optional<KnownAddedMass> known_added_mass(const scene::Scene& scene,
                                               const assembly::BuiltScene& built, std::size_t i,
                                               const hydro::MeanPose& pose) {
  const scene::AddedMass& added_mass = scene.bodies[i].hydro.added_mass;
  const hydro::TriMesh& mesh_B = engine::outside_B(built.spec.bodies[i]);
  const hydro::Sea& sea = *built.spec.sea;
  if (added_mass.model == Model::none)
    return KnownAddedMass{.source = "no added mass, as the scene has it"};
  if (added_mass.model == Model::matrix)
    return KnownAddedMass{in_pose(hydro::ConstantAddedMass(mesh_B, added_mass.matrix), pose, sea),
                          "the scene's matrix of added mass"};
  assembly::AddedMassStore store(assembly::cache_folder());
  const assembly::CenteredMesh& solid = built.solids[i];
  const auto stored = store.find(solid.mesh_C, {.tolerance = added_mass.tolerance});
  if (!stored) return std::nullopt;
  const hydro::DeepAddedMass model(mesh_B, hydro::moved_origin(*stored->solution, solid.com_C));
  return KnownAddedMass{in_pose(model, pose, sea),
                        "the added mass of the wetted surface, without waves"};
}

std::optional<NaturalPeriods> by_radiation(const assembly::RadiationChoice& choice,
                                           const engine::BodySpec& body, const hydro::Sea& sea,
                                           const assembly::LinearTerms& terms) {
  if (choice.database) {
    const hydro::RadiationData& data = choice.database->found.data;
    return natural_periods(terms.body, terms.heading, sea.density, data.infinite_added_mass,
                           hydro::fit_memory(data));
  }
  assembly::RadiationStore store(assembly::cache_folder());
  const auto stored = store.find(assembly::radiation_problem(choice, body, sea));
  if (!stored) return std::nullopt;
  return natural_periods(terms.body, terms.heading, sea.density,
                         stored->solution->data.infinite_added_mass, *stored->memory);
}

}  // namespace

std::string NaturalPeriod::name(const std::string& between) const {
  return fmt::format("{}", fmt::join(motions, between));
}

NaturalPeriods natural_periods(const hydro::LinearBody& body, double heading,
                               const std::function<Matrix6d(double)>& excess) {
  NaturalPeriods periods;
  for (const hydro::NaturalMode& mode : hydro::natural_modes(body, excess))
    periods.modes.push_back(period_of(mode, body, heading));
  return periods;
}

NaturalPeriods natural_periods(const hydro::LinearBody& body, double heading, double density,
                               const Matrix6d& infinite_added_mass,
                               const hydro::RadiationMemory& memory) {
  const Matrix6d turn = hydro::turn_of_heading(heading);
  hydro::LinearBody wet = body;
  wet.inertia += density * turn * infinite_added_mass * turn.transpose();
  NaturalPeriods periods = natural_periods(wet, heading, [&](double omega) {
    return Matrix6d(density * turn * hydro::memory_mass(hydro::response(memory, omega), omega) *
                    turn.transpose());
  });
  periods.added_mass = "the added mass of each one's own frequency, by radiation";
  return periods;
}

NaturalPeriods known_natural_periods(const scene::Scene& scene, const assembly::BuiltScene& built,
                                     engine::BodyId id, const hydro::MeanPose& rest) {
  if (assembly::has_joint(built.spec, id))
    return {.missing = "the body has a joint, and these are those of a body by itself"};
  const auto i = static_cast<std::size_t>(id);
  const assembly::RadiationChoice& choice = built.radiation[i].choice;
  const hydro::MeanPose pose = choice.pose.value_or(rest);
  assembly::LinearTerms terms = assembly::linear_terms(built.spec, id, pose);
  NaturalPeriods periods;
  if (auto found = choice.pose ? by_radiation(choice, built.spec.bodies[i], *built.spec.sea, terms)
                               : std::nullopt) {
    periods = std::move(*found);
  } else if (const auto known = known_added_mass(scene, built, i, pose)) {
    const Matrix6d turn = hydro::turn_of_heading(terms.heading);
    hydro::LinearBody wet = terms.body;
    wet.inertia += turn * known->matrix_H * turn.transpose();
    periods = natural_periods(wet, terms.heading, nullptr);
    periods.added_mass = known->source;
  } else {
    return {.missing = fmt::format("no added mass is stored for the body; plimsoll {} finds it",
                                   choice.pose ? "radiation, or a run," : "addedmass, or a run,")};
  }
  periods.left_out = std::move(terms.left_out);
  return periods;
}

std::string natural_periods_text(const NaturalPeriods& periods) {
  if (!periods.missing.empty()) return fmt::format("  natural periods: {}\n", periods.missing);
  std::vector<std::string> shown;
  for (const NaturalPeriod& mode : periods.modes)
    shown.push_back(fmt::format("{} {:.4g} s", mode.name(" + "), mode.period));
  std::string text = fmt::format(
      "  natural periods: {}\n    without damping, with {}",
      shown.empty() ? "none, as nothing restores" : fmt::format("{}", fmt::join(shown, ", ")),
      periods.added_mass);
  if (!periods.left_out.empty())
    text += fmt::format("; left out: {}", fmt::join(periods.left_out, ", "));
  return text + '\n';
}

nlohmann::ordered_json natural_periods_json(const NaturalPeriods& periods) {
  using Json = nlohmann::ordered_json;
  Json modes = Json::array();
  for (const NaturalPeriod& mode : periods.modes)
    modes.push_back({{"motion", mode.name(" + ")},
                     {"period", mode.period},
                     {"shape", std::vector<double>(mode.shape.begin(), mode.shape.end())}});
  if (!periods.missing.empty()) return {{"modes", modes}, {"missing", periods.missing}};
  return {{"modes", modes}, {"added_mass", periods.added_mass}, {"left_out", periods.left_out}};
}

}  // namespace app
