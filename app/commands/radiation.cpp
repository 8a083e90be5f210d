#include "app/commands/radiation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/assembly/build.h"
#include "app/assembly/build_radiation.h"
#include "app/assembly/build_start.h"
#include "app/assembly/linear_body.h"
#include "app/assembly/mesh_io.h"
#include "app/base/atomic_file.h"
#include "app/base/console.h"
#include "app/base/exit_code.h"
#include "app/base/json_rows.h"
#include "app/base/quoting.h"
#include "app/base/terminal_reporter.h"
#include "app/commands/radiation_plot.h"
#include "app/databases/write_database.h"
#include "app/hydrostatics/natural_periods.h"
#include "app/scene/diagnostics.h"
#include "hydro/airy_waves.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/statics/equilibrium.h"

namespace app {
namespace {

using Json = nlohmann::ordered_json;
using std::numbers::pi;

constexpr const char* kMotions[] = {"surge", "sway", "heave", "roll", "pitch", "yaw"};

/// A body in the pose in which it floats at rest.
struct Afloat {
  std::string name;
  hydro::TriMesh mesh_B;
  hydro::MeanPose pose;
  double density = 1000;  ///< Density of the water [kg/m^3].
  hydro::LinearWater water;
  /// M, stiffness and locks; none for a body with joints, whose motions are not its own.
  std::optional<assembly::LinearTerms> terms;
  std::shared_ptr<const assembly::RadiationDatabase> database;  ///< Null: it is solved.
};

struct Solved {
  Afloat body;
  assembly::StoredRadiation stored;  ///< Without a solution for a body with a database.

  const hydro::RadiationData& data() const {
    return body.database ? body.database->found.data : stored.solution->data;
  }
  /// None for a body with joints, and where A(ω) is known at given frequencies alone.
  std::optional<NaturalPeriods> natural_periods() const {
    if (!body.terms || !(body.database || stored.memory)) return std::nullopt;
    NaturalPeriods periods = app::natural_periods(
        body.terms->body, body.terms->heading, body.density, data().infinite_added_mass,
        body.database ? hydro::fit_memory(data()) : *stored.memory);
    periods.left_out = body.terms->left_out;
    return periods;
  }
  hydro::Vector6cd excitation(std::size_t frequency, Eigen::Index heading) const {
    return body.density * (data().froude_krylov[frequency].col(heading) +
                           data().diffraction[frequency].col(heading));
  }
};

/// The terms of a uniform body that floats upright, in H.
assembly::LinearTerms uniform_terms(const Afloat& body, const hydro::SolidProperties& solid,
                                    double relative_density) {
  const double density = relative_density * body.density;
  const Eigen::Matrix3d R_HB = body.pose.orientation.toRotationMatrix();
  assembly::LinearTerms terms;
  terms.body.inertia.topLeftCorner<3, 3>() = density * solid.volume * Eigen::Matrix3d::Identity();
  terms.body.inertia.bottomRightCorner<3, 3>() = density * R_HB * solid.inertia * R_HB.transpose();
  terms.body.stiffness =
      assembly::hydrostatic_stiffness(body.mesh_B, body.pose, {.density = body.density});
  return terms;
}

Afloat body_of_mesh(const RadiationCommand& o) {
  if (!o.overrides.empty()) throw scene::InputError("--set", "is for a scene, and this is a mesh");
  if (!(o.density > 0 && std::isfinite(o.density)))
    throw scene::InputError(
        "--density", fmt::format("found {:g}, expected a positive number [kg/m^3]", o.density));
  if (!(o.relative_density > 0 && o.relative_density < 1))
    throw scene::InputError(
        "--relative-density",
        fmt::format("found {:g}, expected a number between 0 and 1", o.relative_density));
  TerminalReporter reporter(false);
  Afloat body{.name = o.file.stem().string(), .density = o.density, .water = {.depth = o.depth}};
  hydro::TriMesh mesh = assembly::read_solid(o.file, reporter, o.formats, o.frame);
  const hydro::SolidProperties solid = hydro::solid_properties(mesh);
  body.mesh_B = hydro::translated(std::move(mesh), -solid.centroid);
  const hydro::Flotation rest = hydro::equilibrium(body.mesh_B, o.relative_density * solid.volume,
                                                   Eigen::Quaterniond::Identity());
  body.pose = {.orientation = hydro::with_heading(rest.orientation, 0), .height = rest.height};
  const Eigen::Matrix3d R_HB = body.pose.orientation.toRotationMatrix();
  const double draught = -(body.pose.height + (R_HB * body.mesh_B.vertices).row(2).minCoeff());
  if (!(o.depth > draught))
    throw scene::InputError("--depth", fmt::format("found {:g}, expected more than the draught of "
                                                   "{:.4g} m",
                                                   o.depth, draught));
  body.terms = uniform_terms(body, solid, o.relative_density);
  return body;
}

std::vector<Afloat> bodies_of_scene(const RadiationCommand& o) {
  assembly::refuse_frame(o.frame);
  const scene::Scene scene = scene::read(o.file, o.overrides, o.formats);
  const assembly::BuiltScene built = assembly::build_without_added_mass(scene);
  std::vector<Afloat> bodies;
  for (std::size_t i = 0; i < built.radiation.size(); ++i) {
    const assembly::RadiationChoice& choice = built.radiation[i].choice;
    if (!choice.pose) continue;
    const engine::BodySpec& body = built.spec.bodies[i];
    const hydro::Sea& sea = *built.spec.sea;
    bodies.push_back({.name = body.name,
                      .mesh_B = body.mesh_B,
                      .pose = *choice.pose,
                      .density = sea.density,
                      .water = {.gravity = sea.gravity, .depth = sea.depth},
                      .terms = {},
                      .database = choice.database});
    const auto id = static_cast<engine::BodyId>(i);
    if (!assembly::has_joint(built.spec, id))
      bodies.back().terms = assembly::linear_terms(built.spec, id, *choice.pose);
  }
  if (!bodies.empty()) return bodies;
  std::string why;
  for (std::size_t i = 0; i < built.radiation.size(); ++i)
    if (!built.radiation[i].choice.reason.empty())
      why = fmt::format("; {}: {}", built.spec.bodies[i].name, built.radiation[i].choice.reason);
  throw scene::InputError(o.file.string(), "no body of the scene makes waves" + why);
}

hydro::RadiationOptions options_of(const RadiationCommand& o) {
  for (std::size_t i = 0; i < o.frequencies.size(); ++i)
    if (!(o.frequencies[i] > (i == 0 ? 0 : o.frequencies[i - 1]) &&
          std::isfinite(o.frequencies[i])))
      throw scene::InputError("--frequencies", "expected positive numbers that ascend [rad/s]");
  return {.frequencies = o.frequencies};
}

Json to_json(const hydro::Loads6cd& loads, double density, bool imaginary) {
  const Eigen::MatrixXd part =
      density * (imaginary ? Eigen::MatrixXd(loads.imag()) : Eigen::MatrixXd(loads.real()));
  Json rows = Json::array();
  for (Eigen::Index h = 0; h < part.cols(); ++h)
    rows.push_back(std::vector<double>(part.col(h).begin(), part.col(h).end()));
  return rows;
}

Json to_json(const Solved& solved) {
  const hydro::RadiationData& data = solved.data();
  const double density = solved.body.density;
  const Eigen::Quaterniond& q = data.pose.orientation;
  Json all = {{"density", density},
              {"gravity", data.water.gravity},
              {"depth", std::isfinite(data.water.depth) ? Json(data.water.depth) : Json()},
              {"assumed", assembly::assumptions(data.water, false)},
              {"displaced_volume", data.volume},
              {"height", data.pose.height},
              {"orientation", {q.w(), q.x(), q.y(), q.z()}},
              {"infinite_added_mass", json_rows(density * data.infinite_added_mass)},
              {"headings", data.headings},
              {"frequencies", Json::array()}};
  if (const auto& database = solved.body.database)
    all.update({{"file", database->file.string()},
                {"format", database->format},
                {"notes", database->found.notes}});
  else
    all.update({{"unknowns", solved.stored.solution->unknowns},
                {"mismatch", solved.stored.solution->mismatch},
                {"from_store", solved.stored.from_store},
                {"solve_seconds", solved.stored.seconds}});
  if (const auto periods = solved.natural_periods())
    all["natural_periods"] = natural_periods_json(*periods);
  for (std::size_t f = 0; f < data.frequencies.size(); ++f) {
    Json row = {{"omega", data.frequencies[f]},
                {"added_mass", json_rows(density * data.added_mass[f])},
                {"damping", json_rows(density * data.damping[f])}};
    if (!data.headings.empty())  // A file may have none.
      row.update({{"froude_krylov_real", to_json(data.froude_krylov[f], density, false)},
                  {"froude_krylov_imag", to_json(data.froude_krylov[f], density, true)},
                  {"diffraction_real", to_json(data.diffraction[f], density, false)},
                  {"diffraction_imag", to_json(data.diffraction[f], density, true)}});
    all["frequencies"].push_back(std::move(row));
  }
  return all;
}

/// One row a number: of matrices two motions, of loads a motion and a heading.
std::string csv_of(const Solved& solved) {
  const hydro::RadiationData& data = solved.data();
  const std::string name = csv_field(solved.body.name);
  std::string text;
  const auto add = [&](double omega, const char* what, int i, const std::string& other,
                       double value) {
    text += fmt::format("{},{},{},{},{},{}\n", name, omega, what, kMotions[i], other, value);
  };
  if (const auto periods = solved.natural_periods())
    for (const NaturalPeriod& mode : periods->modes)
      text += fmt::format("{},{},natural_period,{},,{}\n", name, 2 * pi / mode.period,
                          mode.name(" + "), mode.period);
  for (std::size_t f = 0; f < data.frequencies.size(); ++f) {
    const double omega = data.frequencies[f];
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j) {
        add(omega, "added_mass", i, kMotions[j], solved.body.density * data.added_mass[f](i, j));
        add(omega, "damping", i, kMotions[j], solved.body.density * data.damping[f](i, j));
      }
    for (std::size_t h = 0; h < data.headings.size(); ++h) {
      const hydro::Vector6cd X = solved.excitation(f, static_cast<Eigen::Index>(h));
      const std::string heading = fmt::format("{:g}", data.headings[h] * 180 / pi);
      for (int i = 0; i < 6; ++i) {
        add(omega, "excitation_real", i, heading, X[i].real());
        add(omega, "excitation_imag", i, heading, X[i].imag());
      }
    }
  }
  return text;
}

/// Where the numbers come from.
std::string origin_of(const Solved& solved) {
  const std::size_t frequencies = solved.data().frequencies.size();
  if (const auto& database = solved.body.database)
    return fmt::format("{} frequencies and {} headings of {} ({}, body {})", frequencies,
                       solved.data().headings.size(), database->file.string(), database->format,
                       database->body);
  return fmt::format(
      "{} frequencies on {} unknowns, {:.2f} s{}; damping by pressure and far away differ by "
      "{:.2g} %",
      frequencies, solved.stored.solution->unknowns, solved.stored.seconds,
      solved.stored.from_store ? ", from the store" : "", 100 * solved.stored.solution->mismatch);
}

/// A table of numbers of the six motions, a row each frequency.
template <class Number>
std::string block_of(const std::string& title, const hydro::RadiationData& data,
                     const Number& number) {
  std::string text = fmt::format("\n  {}\n{:>9}{:>10}", title, "omega", "length");
  for (const char* motion : kMotions) text += fmt::format("{:>12}", motion);
  text += fmt::format("\n{:>9}{:>10}\n", "rad/s", "m");
  for (std::size_t f = 0; f < data.frequencies.size(); ++f) {
    const double omega = data.frequencies[f];
    const double k = hydro::wave_number(omega, data.water.depth, data.water.gravity).value();
    text += fmt::format("{:>9.4g}{:>10.4g}", omega, 2 * pi / k);
    for (int i = 0; i < 6; ++i) text += fmt::format("{:>12.4g}", number(f, i));
    text += '\n';
  }
  return text;
}

/// The headings nearest to waves along the body's x axis, and across it.
std::vector<Eigen::Index> shown_headings(const hydro::RadiationData& data) {
  std::vector<Eigen::Index> shown;
  for (const double wanted : {0.0, pi / 2}) {
    if (data.headings.empty()) break;
    const auto nearest = std::ranges::min_element(data.headings, {}, [&](double heading) {
      return std::abs(std::remainder(heading - wanted, 2 * pi));
    });
    const Eigen::Index found = nearest - data.headings.begin();
    if (shown.empty() || shown.front() != found) shown.push_back(found);
  }
  return shown;
}

std::string table_of(const Solved& solved) {
  const hydro::RadiationData& data = solved.data();
  const double density = solved.body.density;
  std::string text = fmt::format(
      "{}: displaced {:.6g} m^3, centre of mass {:.6g} m above the water of {:g} kg/m^3\n  {}\n"
      "  assumed: {}\n",
      solved.body.name, data.volume, data.pose.height, density, origin_of(solved),
      fmt::join(assembly::assumptions(data.water, false), ", "));
  text += block_of("added mass [kg, kg m^2]", data,
                   [&](std::size_t f, int i) { return density * data.added_mass[f](i, i); });
  text += fmt::format("{:>9}{:>10}", "infinite", "0");
  for (int i = 0; i < 6; ++i)
    text += fmt::format("{:>12.4g}", density * data.infinite_added_mass(i, i));
  text += '\n' + block_of("damping [kg/s, kg m^2/s]", data,
                          [&](std::size_t f, int i) { return density * data.damping[f](i, i); });
  for (const Eigen::Index heading : shown_headings(data))
    text += block_of(
        fmt::format("|X| of waves that travel toward {:.4g} deg [N/m, N]",
                    data.headings[static_cast<std::size_t>(heading)] * 180 / pi),
        data, [&](std::size_t f, int i) { return std::abs(solved.excitation(f, heading)[i]); });
  const auto periods = solved.natural_periods();
  return periods ? text + '\n' + natural_periods_text(*periods) : text;
}

/// Data of a body for the files of other programs.
databases::WrittenBody written(const Solved& solved) {
  const hydro::RadiationData& data = solved.data();
  const hydro::TriMesh mesh_H =
      hydro::transformed(solved.body.mesh_B, Eigen::Isometry3d(data.pose.orientation));
  return {.name = solved.body.name,
          .data = data,
          .density = solved.body.density,
          .statics = hydro::hydrostatics(mesh_H, data.pose.height)};
}

void write_files(const RadiationCommand& command, const Solved& solved, Reporter& reporter) {
  const std::string place =
      fmt::format("about the centre of mass, {:.6g} m above the water", solved.data().pose.height);
  if (!command.wamit.empty()) {
    databases::write_wamit(command.wamit, written(solved));
    reporter.note(fmt::format("{}.1, .3 and .hst: {}", command.wamit.string(), place));
  }
  if (!command.plot.empty())
    write_whole(command.plot, radiation_svg(solved.body.name, solved.data(), solved.body.density));
  if (!command.capytaine.empty()) {
    databases::write_capytaine(command.capytaine, written(solved));
    reporter.note(fmt::format("{}: {}", command.capytaine.string(), place));
  }
}

/// Refuses options that do not fit the bodies, and files whose names tell another format.
void check_options(const RadiationCommand& command, const std::vector<Afloat>& bodies) {
  for (const auto& [option, file] :
       {std::pair("--wamit", command.wamit), std::pair("--capytaine", command.capytaine),
        std::pair("--plot", command.plot)})
    if (!file.empty() && bodies.size() > 1)
      throw scene::InputError(option, "is for one body, and the scene has several that make waves");
  for (const auto& [option, file, extension] : {std::tuple("--capytaine", command.capytaine, ".nc"),
                                                std::tuple("--plot", command.plot, ".svg")})
    if (!file.empty() && file.extension() != extension)
      throw scene::InputError(
          option, fmt::format("found {}, expected a file {}", file.string(), extension));
  for (const Afloat& body : bodies)
    if (body.database && !command.frequencies.empty())
      throw scene::InputError("--frequencies",
                              fmt::format("is for bodies that are solved, and those of {} are in "
                                          "its file",
                                          body.name));
}

}  // namespace

int radiation(const RadiationCommand& command) {
  const hydro::RadiationOptions options = options_of(command);
  const std::vector<Afloat> bodies = scene::is_scene_file(command.file)
                                         ? bodies_of_scene(command)
                                         : std::vector{body_of_mesh(command)};
  check_options(command, bodies);
  TerminalReporter reporter(false);
  assembly::RadiationStore store(command.store ? assembly::cache_folder() : std::nullopt);
  Json all = Json::object();
  std::string text = command.csv ? "body,omega,quantity,motion,motion_or_heading_deg,value\n" : "";
  for (const Afloat& body : bodies) {
    Solved solved{body, {}};
    if (!body.database)
      solved.stored = assembly::solved_radiation(
          body.name,
          {.mesh_B = body.mesh_B, .pose = body.pose, .water = body.water, .options = options},
          store, reporter);
    write_files(command, solved, reporter);
    if (command.json)
      all[body.name] = to_json(solved);
    else
      text += command.csv ? csv_of(solved) : table_of(solved);
  }
  print(command.json
            ? Json{{"bodies", all}}.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"
            : text);
  flush_output();
  return kDone;
}

}  // namespace app
