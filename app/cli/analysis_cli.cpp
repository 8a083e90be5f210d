#include "app/cli/analysis_cli.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>

#include "app/cli/common_options.h"
#include "app/cli/number_series.h"
#include "app/scene/diagnostics.h"

namespace app {
namespace {

/// Parses `0:60:5` to 0, 5 … 60 degrees, in radians.
std::vector<double> parse_heels(const std::string& argument) {
  double first = 0, last = 0, step = 0;
  int end = 0;
  const bool read = std::sscanf(argument.c_str(), "%lf:%lf:%lf%n", &first, &last, &step, &end) == 3;
  // NaN fails every comparison.
  const bool fits = std::abs(first) <= 180 && std::abs(last) <= 180 && step >= 0.01;
  if (!read || argument.size() != static_cast<std::size_t>(end) || !fits || first > last)
    throw scene::InputError("--heel",
                            fmt::format("found {}, expected FIRST:LAST:STEP within -180 and 180 "
                                        "degrees, FIRST <= LAST and STEP >= 0.01",
                                        argument));
  std::vector<double> heels;
  const long count = std::lround(std::floor((last - first) / step + 1e-9));
  for (long i = 0; i <= count; ++i)
    heels.push_back((first + static_cast<double>(i) * step) * std::numbers::pi / 180);
  return heels;
}

void add_hydrostatics(CLI::App& program, AnalysisArguments& a, std::vector<std::string>& sets) {
  CLI::App* command = program.add_subcommand(
      "hydrostatics",
      "Floating position, stability and righting arms of a mesh or of a scene's bodies");
  HydrostaticsOptions& o = a.hydrostatics;
  command->add_option("file", o.file, "Mesh, or scene (.yaml)")->type_name("FILE")->required();
  command->add_option("--mass", o.mass, "Mass of a mesh [kg]")->type_name("KG");
  command
      ->add_option("--draught", a.draughts,
                   "Draught of the upright mesh, from its lowest point or --keel, instead of the "
                   "mass [m]; a "
                   "range or a list A,B,… gives the curves of form")
      ->type_name("M|FIRST:LAST:STEP");
  command->add_option("--trim", a.trim, "Trim of the curves of form, +x end down [deg] [0]")
      ->type_name("DEG");
  command
      ->add_option("--keel", o.keel,
                   "Height in the mesh frame from which a draught counts [m] [the lowest point]")
      ->type_name("Z");
  command->add_option("--density", o.density, "Density of the water, for a mesh [kg/m^3] [1000]")
      ->type_name("RHO");
  command->add_option("--com", a.center_of_mass, "Centre of mass in the mesh frame [m] [centroid]")
      ->type_name("X,Y,Z")
      ->delimiter(',')
      ->expected(3);
  command
      ->add_option("--water", o.water,
                   "Water in the hollows of the upright mesh, shared by their volume [m^3] [none]")
      ->type_name("M3");
  command
      ->add_option("--heel", a.heels,
                   "Heel angles of the righting arms, or of cross curves over the draught [deg]")
      ->type_name("FIRST:LAST:STEP")
      ->capture_default_str();
  add_mesh_frame(command, o.frame);
  add_sets(command, sets);
  add_any_format(command, o.formats);
  command->add_flag("--json", o.json, "Print JSON");
  command->add_flag("--csv", o.csv, "Print CSV, one number per row");
  command->add_option("--plot", o.plot, "Draw the righting arms, or the curves of form, as SVG")
      ->type_name("FILE");
}

void add_addedmass(CLI::App& program, AnalysisArguments& a, std::vector<std::string>& sets) {
  CLI::App* command = program.add_subcommand(
      "addedmass", "Added mass of a mesh or a scene's bodies, wholly submerged");
  AddedMassCommand& o = a.addedmass;
  command->add_option("file", o.file, "Mesh, or scene (.yaml)")->type_name("FILE")->required();
  command->add_option("--density", o.density,
                      "Density of the water [kg/m^3] [that of the scene, or 1000]");
  command->add_option("--tolerance", o.options.tolerance, "Largest estimated relative error")
      ->capture_default_str();
  command
      ->add_option(
          "--method", o.options.method,
          "galerkin: quadratic elements on adapted panels; constant: collocation on the faces")
      ->transform(CLI::CheckedTransformer(std::map<std::string, hydro::AddedMassMethod>{
          {"galerkin", hydro::AddedMassMethod::galerkin},
          {"constant", hydro::AddedMassMethod::constant}}));
  add_mesh_frame(command, o.frame);
  add_sets(command, sets);
  add_any_format(command, o.formats);
  command->add_flag_callback(
      "--no-store", [&o] { o.store = false; }, "Solve anew and keep nothing for later runs");
  command->add_flag("--json", o.json, "Print JSON");
}

void add_radiation(CLI::App& program, AnalysisArguments& a, std::vector<std::string>& sets) {
  CLI::App* command = program.add_subcommand(
      "radiation", "Added mass, damping and loads of waves on a floating mesh or a scene's bodies");
  RadiationCommand& o = a.radiation;
  command->add_option("file", o.file, "Mesh, or scene (.yaml)")->type_name("FILE")->required();
  command->add_option("--density", o.density, "Density of the water about a mesh [kg/m^3]")
      ->capture_default_str();
  command->add_option("--depth", o.depth, "Depth of the water about a mesh [m] [deep]");
  command
      ->add_option("--relative-density", o.relative_density,
                   "Density of a mesh's body, which is uniform, over the water's")
      ->capture_default_str();
  command
      ->add_option("--frequencies", o.frequencies,
                   "Frequencies [rad/s], ascending [sixteen, chosen for the body]")
      ->delimiter(',');
  add_mesh_frame(command, o.frame);
  add_sets(command, sets);
  add_any_format(command, o.formats);
  command->add_flag_callback(
      "--no-store", [&o] { o.store = false; }, "Solve anew and keep nothing for later runs");
  CLI::Option* json = command->add_flag("--json", o.json, "Print JSON");
  command->add_flag("--csv", o.csv, "Print CSV, one number per row")->excludes(json);
  command->add_option("--wamit", o.wamit, "Write STEM.1, STEM.3 and STEM.hst as WAMIT does")
      ->type_name("STEM");
  command->add_option("--capytaine", o.capytaine, "Write a dataset .nc as Capytaine does")
      ->type_name("FILE");
  command->add_option("--plot", o.plot, "Draw added mass, damping and loads of waves as SVG")
      ->type_name("FILE");
}

void add_rao(CLI::App& program, AnalysisArguments& a, std::vector<std::string>& sets) {
  CLI::App* command = program.add_subcommand(
      "rao", "Response amplitude operators of a scene's bodies by linear theory and in runs");
  RaoCommand& o = a.rao;
  command->add_option("scene", o.scene, "Scene file (YAML)")->type_name("FILE")->required();
  command
      ->add_option("--headings", a.headings,
                   "Directions in which the waves travel, from +x [deg], or a list A,B,…")
      ->type_name("FIRST:LAST:STEP")
      ->capture_default_str();
  command->add_option("--periods", a.periods, "Periods of the waves [s], or a list A,B,…")
      ->type_name("FIRST:LAST:STEP")
      ->capture_default_str();
  command->add_option("--body", o.body, "The only body to be taken [all that make waves]")
      ->type_name("NAME");
  command->add_flag("--runs", o.runs,
                    "Measure them in runs, too, with drag and all nonlinear loads");
  command->add_option("--slope", o.slope, "Amplitude times wave number of the waves of runs")
      ->type_name("KA")
      ->capture_default_str();
  add_sets(command, sets);
  add_any_format(command, o.formats);
  command->add_flag_callback(
      "--no-store", [&o] { o.store = false; }, "Solve anew and keep nothing for later runs");
  CLI::Option* json = command->add_flag("--json", o.json, "Print JSON");
  command->add_flag("--csv", o.csv, "Print CSV, one wave per row")->excludes(json);
  command->add_option("--out", o.out, "Write the CSV to a file")->type_name("FILE");
}

void add_analyse(CLI::App& program, AnalyseOptions& o) {
  CLI::App* command = program.add_subcommand(
      "analyse", "Statistics, spectra, decays and responses to waves of a run");
  command->add_option("run", o.run, "Folder of a run, or a trajectory (CSV or HDF5)")
      ->type_name("RUN")
      ->required();
  command->add_option("--from", o.from, "Leave out the rows before this time")
      ->type_name("SECONDS");
  command->add_option("--to", o.to, "Leave out the rows after this time")->type_name("SECONDS");
  command
      ->add_option("--segment", o.segment,
                   "Length of the segments of spectra [that of eight, which overlap by half]")
      ->type_name("SECONDS");
  command
      ->add_option("--wave", o.wave,
                   "Respond to the elevation at this probe [to the irregular sea of the scene]")
      ->type_name("PROBE");
  command->add_flag("--json", o.json, "Print JSON, with all spectra");
}

}  // namespace

void add_analyses(CLI::App& program, AnalysisArguments& a, std::vector<std::string>& sets) {
  add_hydrostatics(program, a, sets);
  add_addedmass(program, a, sets);
  add_radiation(program, a, sets);
  add_rao(program, a, sets);
  add_analyse(program, a.analyse);
}

std::optional<int> run_analysis(const CLI::App& program, AnalysisArguments& a,
                                const std::vector<scene::Override>& overrides) {
  a.hydrostatics.overrides = a.addedmass.overrides = overrides;
  a.radiation.overrides = a.rao.overrides = overrides;
  if (program.got_subcommand("addedmass")) return addedmass(a.addedmass);
  if (program.got_subcommand("analyse")) return analyse(a.analyse);
  if (program.got_subcommand("radiation")) return radiation(a.radiation);
  if (program.got_subcommand("rao")) {
    a.rao.headings = parse_series("--headings", a.headings);
    a.rao.periods = parse_series("--periods", a.periods);
    return rao(a.rao);
  }
  if (!program.got_subcommand("hydrostatics")) return std::nullopt;
  const std::vector<double>& com = a.center_of_mass;
  a.hydrostatics.heels = parse_heels(a.heels);
  a.hydrostatics.heels_given = program.get_subcommand("hydrostatics")->count("--heel") > 0;
  if (a.trim) a.hydrostatics.trim = *a.trim * std::numbers::pi / 180;
  if (!a.draughts.empty()) {
    const std::vector<double> draughts = parse_series("--draught", a.draughts);
    if (a.draughts.find_first_of(":,") == std::string::npos)
      a.hydrostatics.draught = draughts.front();
    else
      a.hydrostatics.draughts = draughts;
  }
  if (com.size() == 3) a.hydrostatics.center_of_mass = Eigen::Vector3d(com[0], com[1], com[2]);
  return hydrostatics(a.hydrostatics);
}

}  // namespace app
