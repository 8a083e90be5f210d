#include "app/cli/cli.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <map>

#include "app/base/console.h"
#include "app/base/exit_code.h"
#include "app/cli/analysis_cli.h"
#include "app/cli/common_options.h"
#include "app/cli/completion.h"
#include "app/cli/mesh_cli.h"
#include "app/cli/run_cli.h"
#include "app/cli/sweep_cli.h"
#include "app/cli/usage_faults.h"
#include "app/commands/check.h"
#include "app/commands/new_scene.h"
#include "app/commands/probe.h"
#include "app/commands/render_trajectory.h"
#include "app/commands/schema_command.h"
#include "app/compare/compare.h"
#include "app/export/export.h"
#include "app/fmu/export_unit.h"
#include "app/report/report.h"
#include "app/scene/diagnostics.h"
#include "app/view/view.h"

namespace app {
namespace {

const char* const kTrajectory = "Trajectory (CSV or HDF5), or the folder of a run";

std::vector<scene::Override> parse_overrides(const std::vector<std::string>& arguments) {
  std::vector<scene::Override> overrides;
  for (const std::string& argument : arguments)
    overrides.push_back(scene::parse_override(argument));
  return overrides;
}

/// Values of the options of all commands.
struct Arguments {
  RunArguments run;
  CompareOptions compare;
  RenderOptions render;
  ExportOptions exported;
  ViewOptions view;
  ReportOptions report;
  AnalysisArguments analysis;
  MeshCommand mesh;
  SweepOptions sweep;
  std::vector<std::filesystem::path> scenes;
  bool expand = false;
  std::filesystem::path scene;
  std::vector<std::string> sets;
  scene::MeshFormats formats = scene::MeshFormats::common;  ///< Formats for `check` and `probe`.
  bool markdown = false;
  std::string shell;
};

void add_others(CLI::App& program, Arguments& a) {
  CLI::App* starter = program.add_subcommand("new", "Write a commented scene to start from");
  starter->add_option("name", a.scene, "Name of the scene, with or without .yaml")
      ->type_name("NAME")
      ->required();

  CLI::App* check =
      program.add_subcommand("check", "Validate scenes and their meshes; run nothing");
  check->add_option("scenes", a.scenes, "Scene files")->type_name("FILE")->required();
  add_sets(check, a.sets);
  check->add_flag("--expand", a.expand,
                  "Print the scenes without includes, variables and repeated entries, and check "
                  "nothing else");
  add_any_format(check, a.formats);

  CLI::App* probe =
      program.add_subcommand("probe", "Print the forces on every body in its initial state (JSON)");
  probe->add_option("scene", a.scene, "Scene file")->type_name("FILE")->required();
  add_sets(probe, a.sets);
  add_any_format(probe, a.formats);

  CLI::App* render = program.add_subcommand("render", "Draw pictures of a logged trajectory");
  render->add_option("trajectory", a.render.trajectory, kTrajectory)->type_name("FILE")->required();
  render->add_option("--scene", a.render.scene, "Scene of the trajectory [that of its run]")
      ->type_name("SCENE");
  render->add_option("--out", a.render.out, "Folder for the pictures")
      ->type_name("DIR")
      ->required();
  add_video(render, a.render.video);
  add_sets(render, a.sets);
  add_any_format(render, a.render.formats);
  render->add_flag("--quiet", a.render.quiet, "Print no progress and no report");
}

void add_export(CLI::App& program, ExportOptions& o, std::vector<std::string>& sets) {
  CLI::App* command = program.add_subcommand(
      "export",
      "Write a run as an animated scene (glTF) for Blender, three.js and others, or a scene as a "
      "unit for co-simulation (FMI 3.0)");
  command->add_option("run", o.run, std::string(kTrajectory) + "; for a unit the file of a scene")
      ->type_name("RUN")
      ->required();
  command->add_option("out", o.out, "File to write, .glb, or .fmu for a unit")
      ->type_name("FILE")
      ->required();
  command->add_option("--fps", o.fps, "Poses per second, 1 to 120 [25]")
      ->check(CLI::Range(1, 120).description(""))
      ->type_name("N");
  command
      ->add_option("--water", o.animation.water_cells,
                   "Cells of the water's surface along a side, 0 for no water [64]")
      ->check(CLI::Range(0, 512).description(""))
      ->type_name("CELLS");
  command->add_option("--scene", o.scene, "Scene of the trajectory [that of its run]")
      ->type_name("SCENE");
  add_sets(command, sets);
  add_any_format(command, o.formats);
  command->add_flag("--quiet", o.quiet, "Print no report");
}

/// Writes a run, or a scene as a unit, by the extension of the file.
int export_run_or_scene(const CLI::App& command, const ExportOptions& o) {
  if (o.out.extension() != ".fmu") return export_run(o);
  for (const char* option : {"--fps", "--water", "--scene"})
    if (command.count(option) > 0)
      throw scene::InputError(o.out, std::string("is a unit, for which there is no ") + option);
  return fmu::export_unit(
      {.scene = {o.run, o.overrides, o.formats}, .out = o.out, .quiet = o.quiet});
}

void add_view(CLI::App& program, Arguments& a) {
  CLI::App* command = program.add_subcommand("view", "Play a scene in a window, in real time");
  command->add_option("scene", a.view.scene, "Scene file")->type_name("SCENE")->required();
  add_sets(command, a.sets);
  add_any_format(command, a.view.formats);
  add_threads(command, a.view.threads);
  CLI::Option* snapshot =
      command->add_option("--snapshot", a.view.snapshot, "Save a picture of the window and quit")
          ->type_name("FILE");
  command->add_option("--after", a.view.after, "Simulated time of the snapshot [s] [0]")
      ->check(CLI::Range(0.0, 1e6).description(""))
      ->type_name("SECONDS")
      ->needs(snapshot);
}

void add_compare(CLI::App& program, CompareOptions& o) {
  const char* const what = "Run: its folder, or a trajectory (CSV or HDF5); or a folder of runs";
  CLI::App* command = program.add_subcommand(
      "compare", "Compare two runs, or the runs of two folders, body by body and table by table");
  command->add_option("a", o.a, what)->type_name("A")->required();
  command->add_option("b", o.b, what)->type_name("B")->required();
  command->add_option("more", o.more, "With --learn: further runs")->type_name("RUN");
  CLI::Option* tolerances =
      command
          ->add_option("--tol", o.tolerances,
                       "Tolerances of position, orientation_deg, linear_velocity, "
                       "angular_velocity, or of tables, as forces.buoyancy; of the peak, or "
                       "position.rms, position.relative; only those given are judged [1e-9]")
          ->type_name("QUANTITY=NUMBER,...")
          ->delimiter(',');
  CLI::Option* file =
      command
          ->add_option("--tolerances", o.tolerance_file,
                       "Read the tolerances from a YAML file [tolerances.yaml in A or B]")
          ->type_name("FILE")
          ->excludes(tolerances);
  CLI::Option* json = command->add_flag("--json", o.json, "Print JSON");
  CLI::Option* junit =
      command->add_option("--junit", o.junit, "Write a JUnit report, for CI servers")
          ->type_name("FILE");
  CLI::Option* html =
      command->add_option("--html", o.html, "Write one page with plots, for a browser")
          ->type_name("FILE");
  CLI::Option* learn =
      command
          ->add_option("--learn", o.learn,
                       "Compare nothing: write the tolerances within which the runs agree with A")
          ->type_name("FILE");
  for (CLI::Option* other : {tolerances, file, json, junit, html}) learn->excludes(other);
  command->add_option("--margin", o.margin, "With --learn: tolerances over the largest differences")
      ->check(CLI::Range(1.0, 1e6).description(""))
      ->type_name("NUMBER")
      ->capture_default_str()
      ->needs(learn);
}

void add_report(CLI::App& program, Arguments& a) {
  CLI::App* command =
      program.add_subcommand("report",
                             "Write a run as one page for a browser, DIR/report.html (plots, 3-D "
                             "replay), or lay the plots "
                             "of several over each other");
  command->add_option("runs", a.report.runs, "Folders of runs")->type_name("DIR")->required();
  command->add_option("--out", a.report.out, "The page [DIR/report.html; of several runs.html]")
      ->type_name("FILE");
  command
      ->add_option("--scene", a.report.scene,
                   "Present place of its scene and meshes [that of the run]")
      ->type_name("SCENE");
  add_any_format(command, a.report.formats);
}

void add_schema(CLI::App& program, Arguments& a) {
  program.add_subcommand("schema", "Print the JSON Schema of scenes, for editors")
      ->add_flag("--markdown", a.markdown, "Print the tables of keys of scenes/KEYS.md instead");
}

void add_completion(CLI::App& program, Arguments& a) {
  program.add_subcommand("completion", "Print a completion script for a shell")
      ->add_option("shell", a.shell, "bash or zsh")
      ->check(CLI::IsMember({"bash", "zsh"}))
      ->required();
}

int dispatch(const CLI::App& program, Arguments& a) {
  const std::vector<scene::Override> overrides = parse_overrides(a.sets);
  a.run.options.overrides = a.view.overrides = a.render.overrides = overrides;
  a.exported.overrides = overrides;
  if (program.got_subcommand("run")) return run_scenes(a.run);
  if (program.got_subcommand("view")) return view(a.view);
  if (program.got_subcommand("sweep")) return sweep(a.sweep);
  if (program.got_subcommand("new")) return new_scene(a.scene);
  if (program.got_subcommand("check"))
    return a.expand ? print_expanded(a.scenes, overrides) : check(a.scenes, overrides, a.formats);
  if (program.got_subcommand("probe")) return probe(a.scene, overrides, a.formats);
  if (program.got_subcommand("compare")) return compare(a.compare);
  if (program.got_subcommand("report")) return report(a.report);
  if (program.got_subcommand("export"))
    return export_run_or_scene(*program.get_subcommand("export"), a.exported);
  if (program.got_subcommand("completion")) return completion(program, a.shell);
  if (program.got_subcommand("mesh")) return mesh_command(a.mesh);
  if (program.got_subcommand("schema")) return schema(a.markdown);
  if (const auto code = run_analysis(program, a.analysis, overrides)) return *code;
  return render_trajectory(a.render);
}

}  // namespace

int command_line(int argc, char** argv) {
  CLI::App program("Plimsoll, a maritime sandbox: triangle-mesh bodies in height-field water.",
                   "plimsoll");
  program.set_version_flag("--version", "plimsoll " PLIMSOLL_VERSION);
  program.require_subcommand(1);
  Arguments arguments;
  add_run(program, arguments.run, arguments.sets);
  add_others(program, arguments);
  add_export(program, arguments.exported, arguments.sets);
  add_view(program, arguments);
  add_compare(program, arguments.compare);
  add_report(program, arguments);
  add_analyses(program, arguments.analysis, arguments.sets);
  add_sweep(program, arguments.sweep);
  add_mesh(program, arguments.mesh);
  add_schema(program, arguments);
  add_completion(program, arguments);
  try {
    check_command(program, {argv + 1, argv + argc});
    program.parse(argc, argv);
  } catch (const CLI::ExtrasError& error) {
    say_unexpected(program, error);
    return kWrongInput;
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? kDone : kWrongInput;
  }
  return dispatch(program, arguments);
}

}  // namespace app
