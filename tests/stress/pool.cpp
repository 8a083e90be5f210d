#include "tests/stress/pool.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstring>
#include <stdexcept>

namespace stress {
namespace {

/// A run in progress.
struct Worker {
  RunName run;
  pid_t process = 0;
  int pipe = -1;
  std::string said;
};

[[noreturn]] void work(const RunName& run, int pipe) {
  const rlimit limit{kLongestRun, kLongestRun};
  ::setrlimit(RLIMIT_CPU, &limit);
  const std::string line = to_csv(run_through(run));
  const bool whole = ::write(pipe, line.data(), line.size()) == static_cast<ssize_t>(line.size());
  ::_exit(whole ? 0 : 1);
}

Worker start(const RunName& run) {
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) throw std::runtime_error("no pipe to a run's process");
  std::fflush(nullptr);
  const pid_t process = ::fork();
  if (process < 0) throw std::runtime_error("no process for a run");
  if (process == 0) {
    ::close(ends[0]);
    work(run, ends[1]);
  }
  ::close(ends[1]);
  return {.run = run, .process = process, .pipe = ends[0]};
}

Outcome finish(const Worker& worker) {
  ::close(worker.pipe);
  int status = 0;
  ::waitpid(worker.process, &status, 0);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return outcome_from_csv(worker.said);
  Outcome outcome;
  outcome.fault = WIFSIGNALED(status)
                      ? fmt::format("its process died: {}", ::strsignal(WTERMSIG(status)))
                      : "its process ended without an outcome";
  return outcome;
}

/// Reads the available output of a worker. @returns false at its end.
bool listen(Worker& worker) {
  std::array<char, 4096> buffer{};
  const ssize_t count = ::read(worker.pipe, buffer.data(), buffer.size());
  if (count > 0) worker.said.append(buffer.data(), static_cast<std::size_t>(count));
  return count > 0;
}

/// Waits for output of any worker, and removes workers that have ended.
void wait_for_one(std::vector<Worker>& workers, const Collector& collect) {
  std::vector<pollfd> pipes;
  for (const Worker& worker : workers) pipes.push_back({worker.pipe, POLLIN, 0});
  ::poll(pipes.data(), pipes.size(), -1);
  for (std::size_t i = workers.size(); i-- > 0;) {
    if (pipes[i].revents == 0 || listen(workers[i])) continue;
    collect(workers[i].run, finish(workers[i]));
    workers.erase(workers.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

}  // namespace

void do_all(const std::vector<RunName>& runs, int jobs, const Collector& collect) {
  std::vector<Worker> workers;
  for (const RunName& run : runs) {
    workers.push_back(start(run));
    while (workers.size() >= static_cast<std::size_t>(jobs)) wait_for_one(workers, collect);
  }
  while (!workers.empty()) wait_for_one(workers, collect);
}

}  // namespace stress
