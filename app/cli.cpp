#include "app/cli.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/commands.h"
#include "app/faults.h"

namespace app {
namespace {

std::vector<Override> parse_overrides(const std::vector<std::string>& arguments) {
  std::vector<Override> overrides;
  for (const std::string& argument : arguments) overrides.push_back(parse_override(argument));
  return overrides;
}

/// `position=1e-6,orientation_deg=0.01`
std::map<std::string, double> parse_tolerances(const std::vector<std::string>& arguments) {
  std::map<std::string, double> tolerances;
  for (const std::string& argument : arguments) {
    const std::size_t equals = argument.find('=');
    const std::string value = equals == std::string::npos ? "" : argument.substr(equals + 1);
    char* end = nullptr;
    const double number = std::strtod(value.c_str(), &end);
    if (value.empty() || *end != '\0')
      throw InputError("--tol", fmt::format("found \"{}\", expected QUANTITY=NUMBER", argument));
    tolerances[argument.substr(0, equals)] = number;
  }
  return tolerances;
}

/// What the options of all commands are read into.
struct Arguments {
  RunOptions run;
  CompareOptions compare;
  RenderOptions render;
  std::vector<std::filesystem::path> scenes;
  std::filesystem::path scene;
  std::vector<std::string> sets;
  std::vector<std::string> tolerances;
};

void add_sets(CLI::App* command, Arguments& arguments) {
  command
      ->add_option("--set", arguments.sets,
                   "Replace or add a key of the scene, e.g. bodies[0].density=700")
      ->type_name("KEY.PATH=VALUE")
      ->allow_extra_args(false)
      ->take_all();
}

void add_run(CLI::App& program, Arguments& a) {
  CLI::App* command = program.add_subcommand("run", "Run a scene: trajectory, pictures, summary");
  command->add_option("scene", a.run.scene, "Scene file (YAML)")->required();
  command->add_option("--out", a.run.out, "Folder for the results [out/<scene>]");
  add_sets(command, a);
  command->add_flag_callback(
      "--no-render", [&a] { a.run.render = false; }, "Make no pictures");
  command
      ->add_option("--threads", a.run.threads, "Threads; results do not depend on it [all cores]")
      ->check(CLI::Range(1, 256));
  command->add_flag("--quiet", a.run.quiet, "No progress and no report");
}

void add_others(CLI::App& program, Arguments& a) {
  CLI::App* check =
      program.add_subcommand("check", "Validate scenes and their meshes; run nothing");
  check->add_option("scenes", a.scenes, "Scene files")->required();
  add_sets(check, a);

  CLI::App* probe =
      program.add_subcommand("probe", "Print the forces on every body in its initial state (JSON)");
  probe->add_option("scene", a.scene, "Scene file")->required();
  add_sets(probe, a);

  CLI::App* compare = program.add_subcommand("compare", "Compare two trajectories body by body");
  compare->add_option("a", a.compare.a, "Trajectory (CSV)")->required();
  compare->add_option("b", a.compare.b, "Trajectory (CSV)")->required();
  compare
      ->add_option("--tol", a.tolerances,
                   "Tolerances: position, orientation_deg, linear_velocity, angular_velocity; only "
                   "those named are judged [all: 1e-9]")
      ->type_name("QUANTITY=NUMBER,...")
      ->delimiter(',');

  CLI::App* render = program.add_subcommand("render", "Draw pictures of a trajectory");
  render->add_option("trajectory", a.render.trajectory, "Trajectory (CSV)")->required();
  render->add_option("--scene", a.render.scene, "The scene that it is of")->required();
  render->add_option("--out", a.render.out, "Folder for the pictures")->required();
  add_sets(render, a);
  render->add_flag("--quiet", a.render.quiet, "No progress and no report");
}

/// Names the commands there are if the first word is none of them.
void check_command(const CLI::App& program, int argc, char** argv) {
  const std::string word = argc > 1 ? argv[1] : "";
  if (word.starts_with('-')) return;
  std::string known;
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
    if (command->get_name() == word) return;
    known += (known.empty() ? "" : ", ") + command->get_name();
  }
  throw CLI::ParseError(fmt::format("{}, expected a command: {}",
                                    word.empty() ? "found nothing" : "found " + word, known),
                        CLI::ExitCodes::ExtrasError);
}

int dispatch(const CLI::App& program, Arguments& a) {
  const std::vector<Override> overrides = parse_overrides(a.sets);
  a.run.overrides = a.render.overrides = overrides;
  a.compare.tolerances = parse_tolerances(a.tolerances);
  if (program.got_subcommand("run")) return run(a.run);
  if (program.got_subcommand("check")) return check(a.scenes, overrides);
  if (program.got_subcommand("probe")) return probe(a.scene, overrides);
  if (program.got_subcommand("compare")) return compare(a.compare);
  return render_trajectory(a.render);
}

}  // namespace

int command_line(int argc, char** argv) {
  CLI::App program("Plimsoll, a maritime sandbox: triangle-mesh bodies in height-field water.",
                   "plimsoll");
  program.set_version_flag("--version", "plimsoll " PLIMSOLL_VERSION);
  program.require_subcommand(1);
  Arguments arguments;
  add_run(program, arguments);
  add_others(program, arguments);
  try {
    check_command(program, argc, argv);
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? kDone : kWrongInput;
  }
  return dispatch(program, arguments);
}

}  // namespace app
