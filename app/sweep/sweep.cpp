#include "app/sweep/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <map>
#include <optional>
#include <thread>
#include <utility>

#include "app/base/atomic_file.h"
#include "app/base/child_process.h"
#include "app/base/console.h"
#include "app/base/exit_code.h"
#include "app/base/interrupt.h"
#include "app/base/progress.h"
#include "app/base/thread_count.h"
#include "app/sweep/ranks.h"
#include "app/sweep/sweep_folder.h"
#include "app/sweep/sweep_outcome.h"
#include "app/sweep/sweep_slurm.h"
#include "app/sweep/sweep_survey.h"

namespace app {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Time between checks of the interrupt and the clock.
constexpr milliseconds kPollInterval(50);
/// Shortest time between two writings of the table.
constexpr milliseconds kTableInterval(1000);
/// Ratio of the rest to the time of writing the table or polling the folders of other ranks. Both
/// take longer with more runs; the ratio bounds their share of the time.
constexpr int kRestsPerLook = 20;

/// Returns true if a run must not be repeated.
bool ended_by_itself(const RunOutcome& outcome) {
  return outcome.code == kDone || outcome.code == kCannotGoOn;
}

/// A run in progress.
struct RunningJob {
  std::size_t run;
  RunSlot folder;
  Clock::time_point start;
};

/// Does runs of a sweep, each in a process of its own, and stores their outcomes.
class Sweep {
 public:
  /// @param runs     Runs to be done by this process, in this order.
  /// @param bodies   Bodies in the table; none: no table is written.
  Sweep(const SweepPlan& plan, const SweepFolder& folder, std::vector<std::size_t> runs, int jobs,
        std::optional<std::vector<std::string>> bodies, bool quiet)
      : plan_(plan),
        folder_(folder),
        jobs_(static_cast<std::size_t>(jobs)),
        bodies_(std::move(bodies)),
        outcomes_(plan.points.size()),
        waiting_(runs.begin(), runs.end()),
        progress_(quiet) {}

  /// Skips runs that have outcomes. @param retry   True: repeat runs that ended otherwise than with
  /// exit codes 0 or 3.
  void resume(bool retry) {
    const auto is_done = [&](std::size_t run) {
      auto outcome = read_outcome(folder_.outcome_file(run));
      if (!outcome || (retry && !ended_by_itself(*outcome))) return false;
      if (outcome->code != kDone) ++failed_;
      outcomes_[run] = std::move(outcome);
      return true;
    };
    const std::size_t all = waiting_.size();
    waiting_.erase(std::remove_if(waiting_.begin(), waiting_.end(), is_done), waiting_.end());
    done_before_ = all - waiting_.size();
    to_do_ = waiting_.size();
  }

  /// Does all waiting runs.
  void execute() {
    write_table();
    while (!waiting_.empty() || !going_.empty()) {
      if (guard_.interrupted()) stop();
      while (!waiting_.empty() && going_.size() < jobs_) start_next();
      if (const auto ended = children_.wait(kPollInterval)) finish(*ended);
      if (Clock::now() >= table_due_) write_table();
      if (progress_.due()) show_progress();
    }
    write_table();
    progress_.clear();
  }

  /// Waits for the runs of other ranks.
  void wait_for_others() {
    for (std::size_t missing = 1; missing > 0 && !guard_.interrupted();) {
      if (Clock::now() >= table_due_) write_table();
      const Clock::time_point start = Clock::now();
      look_at_others();
      const Clock::duration rest = kRestsPerLook * (Clock::now() - start);
      missing = missing_runs();
      if (progress_.due()) progress_.show(fmt::format("{} runs of other ranks to go", missing));
      if (missing > 0) std::this_thread::sleep_for(std::max<Clock::duration>(kPollInterval, rest));
    }
    write_table();
    progress_.clear();
  }

  /// Writes the known outcomes, after reading those of other processes if these do runs, too.
  void write_table() {
    if (!bodies_) return;
    const Clock::time_point start = Clock::now();
    if (others_) look_at_others();
    write_whole(folder_.table_file(),
                table_of(plan_.parameters, plan_.points, *bodies_, outcomes_));
    const Clock::duration time = Clock::now() - start;
    table_due_ = start + std::max<Clock::duration>(kTableInterval, kRestsPerLook * time);
  }

  /// Declares that all other runs are done by other processes.
  void expect_others() { others_ = true; }

  bool interrupted() const { return guard_.interrupted() || run_interrupted_; }
  const std::vector<std::optional<RunOutcome>>& outcomes() const { return outcomes_; }

 private:
  void look_at_others() {
    for (std::size_t run = 0; run < outcomes_.size(); ++run)
      if (!outcomes_[run]) outcomes_[run] = read_outcome(folder_.outcome_file(run));
  }

  std::size_t missing_runs() const {
    return static_cast<std::size_t>(
        std::count_if(outcomes_.begin(), outcomes_.end(),
                      [](const std::optional<RunOutcome>& outcome) { return !outcome; }));
  }

  void start_next() {
    const std::size_t run = waiting_.front();
    waiting_.pop_front();
    RunSlot run_folder(folder_.run_folder(run));
    std::vector<std::string> words = {
        "run",         plan_.scene.string(), "--out", run_folder.path().string(),
        "--no-render", "--threads",          "1"};
    if (plan_.formats == scene::MeshFormats::any) words.emplace_back("--any-format");
    for (const scene::Override& override : plan_.overrides_of(run))
      words.insert(words.end(), {"--set", override.key_path + '=' + override.value});
    const pid_t process = children_.start(words, run_folder.messages());
    going_.emplace(process, RunningJob{run, std::move(run_folder), Clock::now()});
  }

  void finish(const EndedProcess& ended) {
    const auto found = going_.find(ended.process);
    if (found == going_.end()) return;  // a child of the process that exec'ed this program
    const RunningJob& going = found->second;
    // An interrupted run has no outcome, so that it is repeated next time.
    const bool by_signal = ended.code > EndedProcess::kSignalBase && guard_.interrupted();
    if (ended.code == kInterrupted || by_signal) {
      run_interrupted_ = true;
    } else {
      const RunOutcome outcome = collect_outcome(going.folder.path(), going.folder.messages_file(),
                                                 ended.code, seconds_since(going.start));
      write_outcome(outcome, folder_.outcome_file(going.run));
      outcomes_[going.run] = outcome;
      ++done_;
      if (outcome.code != kDone) ++failed_;
    }
    going_.erase(found);
  }

  /// Starts no more runs, and asks the runs in progress to end.
  void stop() {
    waiting_.clear();
    if (std::exchange(stopped_, true)) return;
    for (const auto& [process, going] : going_) ::kill(process, SIGTERM);
  }

  void show_progress() {
    const double wall = seconds_since(start_);
    std::string line = fmt::format("{}: {} of {} runs", plan_.scene.stem().string(),
                                   done_before_ + done_, done_before_ + to_do_);
    if (failed_ > 0) line += fmt::format(", {} failed", failed_);
    if (done_ > 0)
      line += fmt::format(", {:.0f} s left",
                          wall / static_cast<double>(done_) * static_cast<double>(to_do_ - done_));
    progress_.show(line);
  }

  const SweepPlan& plan_;
  const SweepFolder& folder_;
  std::size_t jobs_;
  std::optional<std::vector<std::string>> bodies_;
  std::vector<std::optional<RunOutcome>> outcomes_;  ///< Outcomes per run of the sweep.
  std::deque<std::size_t> waiting_;
  std::map<pid_t, RunningJob> going_;
  std::size_t done_before_ = 0;
  std::size_t to_do_ = 0;
  std::size_t done_ = 0;
  std::size_t failed_ = 0;
  bool stopped_ = false;
  bool run_interrupted_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point table_due_ = start_;
  bool others_ = false;
  ProgressLine progress_;
  InterruptGuard guard_;
  ChildProcesses children_;
};

SweepPlan plan_of(const SweepOptions& options) {
  SweepPlan plan = {.scene = options.scene, .formats = options.formats};
  for (const std::string& set : options.sets) plan.overrides.push_back(scene::parse_override(set));
  for (const std::string& varied : options.varied) {
    plan.parameters.push_back(parse_sweep_parameter(varied));
    const std::string& key = plan.parameters.back().key_path;
    const auto same = [&](const SweepParameter& other) { return other.key_path == key; };
    if (std::count_if(plan.parameters.begin(), plan.parameters.end(), same) > 1)
      throw scene::InputError({scene::Fault{{kVaryPlace}, key, "is varied twice, expected once"}});
  }
  plan.points = options.samples ? latin_hypercube(plan.parameters, *options.samples, options.seed)
                                : grid(plan.parameters);
  if (options.only && *options.only >= plan.points.size())
    throw scene::InputError("--only", fmt::format("found {}, expected a run from 0 to {}",
                                                  *options.only, plan.points.size() - 1));
  return plan;
}

/// Prints the state of the sweep. @return the exit code
int report(const SweepOptions& options, const SweepPlan& plan,
           const std::vector<std::optional<RunOutcome>>& outcomes, bool interrupted) {
  std::size_t done = 0, failed = 0, first_failed = 0;
  for (std::size_t run = 0; run < outcomes.size(); ++run) {
    if (!outcomes[run]) continue;
    ++done;
    if (outcomes[run]->code != kDone && failed++ == 0) first_failed = run;
  }
  const bool all = done == plan.points.size();
  const char* rest = all              ? "; the table is sweep.csv"
                     : options.gather ? "; the table sweep.csv has their rows"
                                      : "; repeat the command to resume";
  if (!options.quiet) {
    if (failed > 0)
      say(fmt::format("{} run{} failed, the first of them {}: {}", failed, failed == 1 ? "" : "s",
                      run_name(first_failed), outcomes[first_failed]->message));
    say(fmt::format("{}: {}{} of {} runs are done{}", options.out.string(),
                    interrupted ? "interrupted; " : "", done, plan.points.size(), rest));
  }
  if (interrupted) return kInterrupted;
  return all && failed == 0 ? kDone : kCannotGoOn;
}

int do_one(const SweepOptions& options, const SweepPlan& plan, const SweepFolder& folder) {
  Sweep one(plan, folder, {*options.only}, 1, std::nullopt, options.quiet);
  one.resume(true);
  one.execute();
  if (one.interrupted()) return kInterrupted;
  return one.outcomes()[*options.only]->code == kDone ? kDone : kCannotGoOn;
}

/// Does the part of a rank. Ranks other than the first end with code 0 even if runs have failed,
/// since launchers end all ranks if one ends otherwise.
int do_part(const SweepOptions& options, const SweepPlan& plan, const SweepFolder& folder,
            SweepSurvey survey, Rank rank) {
  std::vector<std::size_t> runs;
  for (std::size_t i = rank.number; i < survey.order.size(); i += rank.size)
    runs.push_back(survey.order[i]);
  const bool alone = rank.size == 1;
  const bool first = rank.number == 0;
  const int jobs = options.jobs > 0 || alone ? thread_count(options.jobs) : 1;
  std::optional<std::vector<std::string>> bodies;
  if (first) bodies = std::move(survey.bodies);
  Sweep part(plan, folder, std::move(runs), jobs, std::move(bodies), options.quiet || !first);
  if (!alone) part.expect_others();
  part.resume(alone);
  part.execute();
  if (!first) return part.interrupted() ? kInterrupted : kDone;
  if (!alone && !part.interrupted()) part.wait_for_others();
  return report(options, plan, part.outcomes(), part.interrupted());
}

int gather(const SweepOptions& options, const SweepPlan& plan, const SweepFolder& folder,
           SweepSurvey survey) {
  Sweep done(plan, folder, {}, 1, std::move(survey.bodies), options.quiet);
  done.expect_others();
  done.write_table();
  return report(options, plan, done.outcomes(), false);
}

int write_script(const SweepOptions& options, const SweepPlan& plan, const SweepFolder& folder) {
  write_whole(folder.script_file(), slurm_script(options, plan.points.size()));
  if (!options.quiet)
    say(fmt::format("{} runs; submit them with: bash {}", plan.points.size(),
                    shell_words({folder.script_file().string()})));
  return kDone;
}

}  // namespace

int sweep(const SweepOptions& options) {
  const SweepPlan plan = plan_of(options);
  const bool divisible = !options.only && !options.gather && !options.slurm;
  const Rank rank = divisible ? launched_rank().value_or(Rank{}) : Rank{};
  if (rank.size > 1 && options.fresh)
    throw scene::InputError("--fresh",
                            "cannot be combined with several ranks; remove the folder first");
  const bool is_part = options.only || rank.size > 1;
  const SweepIdentity identity = {options.scene, options.sets, options.varied, options.samples,
                                  options.seed};
  std::optional<SweepSurvey> surveyed;
  if (!options.only || options.fresh) surveyed = survey(plan);  // a wrong scene makes no folder
  const SweepFolder folder(options.out,
                           is_part ? OutputFolder::Use::shared : OutputFolder::Use::alone);
  if (options.fresh) folder.clear();
  if (!folder.holds(identity)) {
    if (options.gather)
      throw scene::InputError(options.out, "holds no sweep, expected the folder of one");
    if (!surveyed) surveyed = survey(plan);
    folder.begin(identity, surveyed->files);
  }
  if (options.slurm) return write_script(options, plan, folder);
  if (options.only) return do_one(options, plan, folder);
  if (options.gather) return gather(options, plan, folder, std::move(*surveyed));
  return do_part(options, plan, folder, std::move(*surveyed), rank);
}

}  // namespace app
