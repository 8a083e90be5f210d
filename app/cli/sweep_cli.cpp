#include "app/cli/sweep_cli.h"

#include <CLI/CLI.hpp>

#include "app/cli/common_options.h"
#include "app/sweep/sweep_parameters.h"

namespace app {
namespace {

/// Adds the options for sampling and running.
void add_manner(CLI::App* command, SweepOptions& o) {
  CLI::Option* samples =
      command
          ->add_option(
              "--samples", o.samples,
              "Draw N runs as a Latin hypercube instead of all combinations; FIRST:LAST is "
              "then a continuous range")
          ->check(CLI::Range(std::size_t{1}, kMostRuns).description(""))
          ->type_name("N");
  command->add_option("--seed", o.seed, "Seed of the samples")
      ->type_name("N")
      ->capture_default_str()
      ->needs(samples);
  command
      ->add_option(
          "-j,--jobs", o.jobs,
          "Number of runs at a time, each on one thread [all cores; 1 per rank under mpirun "
          "or srun]")
      ->check(CLI::Range(1, 4096).description(""))
      ->type_name("N");
}

}  // namespace

void add_sweep(CLI::App& program, SweepOptions& o) {
  CLI::App* command = program.add_subcommand("sweep",
                                             "Run a scene with many values of its keys; repeat the "
                                             "command to resume");
  command->add_option("scene", o.scene, "Scene file (YAML)")->type_name("FILE")->required();
  command
      ->add_option("--vary", o.varied,
                   "A key of the scene and its values, e.g. bodies[0].density=200:1000:100")
      ->type_name("KEY.PATH=FIRST:LAST:STEP|VALUE,VALUE,...")
      ->allow_extra_args(false)
      ->take_all()
      ->required();
  command->add_option("--out", o.out, "Folder for the table sweep.csv and the runs")
      ->type_name("DIR")
      ->required();
  add_sets(command, o.sets, "Replace or add a key of the scene in all runs");
  add_any_format(command, o.formats);
  add_manner(command, o);
  CLI::Option* fresh = command->add_flag("--fresh", o.fresh, "Remove earlier results first");
  CLI::Option* slurm = command->add_flag(
      "--slurm", o.slurm, "Run nothing; write DIR/sweep.sbatch, an array of jobs (-j at a time)");
  CLI::Option* only =
      command->add_option("--only", o.only, "Do only this run, counted from 0, and write no table")
          ->check(CLI::Range(std::size_t{0}, kMostRuns - 1).description(""))
          ->type_name("INDEX");
  CLI::Option* gather = command->add_flag("--gather", o.gather,
                                          "Run nothing; write the table of the runs that are done");
  CLI::Option* jobs = command->get_option("--jobs");
  only->excludes(slurm)->excludes(gather)->excludes(fresh)->excludes(jobs);
  gather->excludes(slurm)->excludes(fresh)->excludes(jobs);
  command->add_flag("--quiet", o.quiet, "Print no progress and no report");
}

}  // namespace app
