#include "app/sweep/sweep_slurm.h"

#include <fmt/format.h>

#include <filesystem>

#include "app/base/child_process.h"
#include "app/base/quoting.h"

namespace app {
namespace {

/// Template of the script; names in single braces are replaced.
constexpr const char* kScript = R"(#!/bin/bash
# The {runs} runs of a sweep as an array of jobs for Slurm, made by plimsoll sweep --slurm. To hand it
# in, with a job after it that writes the table:
#     bash {script}
# What the cluster wants besides (account, partition) goes below or into SBATCH_ACCOUNT and the like.
# If it allows no such numbers in an array (scontrol show config | grep MaxArraySize), hand in parts:
#     sbatch --array=0-999 {script}; SWEEP_FIRST=1000 sbatch --array=0-999 {script}
#SBATCH --job-name={name}
#SBATCH --array={array}
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=1
#SBATCH --output=/dev/null
cd {folder} || exit
sweep=({command})
if [[ -z ${{SLURM_ARRAY_TASK_ID:-}} ]]; then
  job=$(sbatch --parsable {script}) || exit
  exec sbatch --dependency="afterany:${{job%%;*}}" --job-name={name}-table --ntasks=1 \
    --output={log} --wrap="${{sweep[*]@Q}} --gather"
fi
exec "${{sweep[@]}}" --only $((SLURM_ARRAY_TASK_ID + ${{SWEEP_FIRST:-0}}))
)";

/// Returns the command that defines the same sweep.
std::vector<std::string> command_of(const SweepOptions& options) {
  std::vector<std::string> words = {program_path(), "sweep", options.scene.string()};
  const auto add = [&](const char* option, const std::string& value) {
    words.insert(words.end(), {option, value});
  };
  for (const std::string& varied : options.varied) add("--vary", varied);
  for (const std::string& set : options.sets) add("--set", set);
  if (options.samples) {
    add("--samples", std::to_string(*options.samples));
    add("--seed", std::to_string(options.seed));
  }
  if (options.formats == scene::MeshFormats::any) words.emplace_back("--any-format");
  add("--out", options.out.string());
  return words;
}

/// Returns a name without blanks for the job.
std::string job_name(const std::filesystem::path& scene) {
  std::string name = scene.stem().string();
  for (char& c : name)
    if (shell_word({&c, 1}) != std::string(1, c)) c = '_';
  return name;
}

}  // namespace

std::string shell_words(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + shell_word(word);
  return text;
}

std::string slurm_script(const SweepOptions& options, std::size_t runs) {
  std::string array = fmt::format("0-{}", runs - 1);
  if (options.jobs > 0) array += fmt::format("%{}", options.jobs);
  const auto in_folder = [&](const char* name) {
    return shell_word((options.out / name).string());
  };
  return fmt::format(kScript, fmt::arg("runs", runs), fmt::arg("array", array),
                     fmt::arg("name", job_name(options.scene)),
                     fmt::arg("folder", shell_word(std::filesystem::current_path().string())),
                     fmt::arg("command", shell_words(command_of(options))),
                     fmt::arg("script", in_folder("sweep.sbatch")),
                     fmt::arg("log", in_folder("gather.txt")));
}

}  // namespace app
