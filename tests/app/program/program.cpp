#include "tests/app/program/program.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "app/cli/cli.h"
#include "app/scene/diagnostics.h"
#include "tests/support/files.h"

namespace support {
namespace {

namespace fs = std::filesystem;

/// Pointers to texts, ended by a null, as the system wants them.
std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// This process's environment with more. Graphics drivers keep what they allocated, which the leak
/// checker of AddressSanitizer would report.
std::vector<std::string> environment(const std::vector<std::string>& variables) {
  std::vector<std::string> all = {std::string("PLIMSOLL=") + PLIMSOLL_PROGRAM,
                                  "ASAN_OPTIONS=detect_leaks=0", "LIBGL_ALWAYS_SOFTWARE=1"};
  all.insert(all.end(), variables.begin(), variables.end());
  for (char** entry = environ; *entry != nullptr; ++entry)
    if (!std::string(*entry).starts_with("ASAN_OPTIONS=")) all.push_back(*entry);
  return all;
}

}  // namespace

Workplace::Workplace() {
  const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
  folder_ = fs::path(testing::TempDir()) /
            (std::string("plimsoll_") + test.test_suite_name() + "_" + test.name());
  fs::remove_all(folder_);
  fs::create_directories(folder_);
}

Workplace::~Workplace() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

std::string Workplace::write(const std::string& name, const std::string& text) const {
  fs::create_directories((folder_ / name).parent_path());
  std::ofstream(folder_ / name, std::ios::binary) << text;
  return name;
}

std::string Workplace::read(const fs::path& file) const { return bytes_in(folder_ / file); }

pid_t Workplace::spawn(const std::vector<std::string>& command,
                       const std::vector<std::string>& variables) const {
  std::vector<std::string> words = command;
  std::vector<std::string> names = environment(variables);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder_.c_str());
  const int flags = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "out.txt", flags, 0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "err.txt", flags, 0600);
  // Signals act as on a terminal, whatever started the tests.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  posix_spawnattr_setsigdefault(&attributes, &signals);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
  pid_t process = 0;
  const int error = posix_spawn(&process, words[0].c_str(), &actions, &attributes,
                                pointers(words).data(), pointers(names).data());
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw std::runtime_error(words[0] + " cannot be started");
  return process;
}

Outcome Workplace::finish(pid_t process) const {
  int status = 0;
  ::waitpid(process, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), read("out.txt"),
          read("err.txt")};
}

pid_t Workplace::start(const std::vector<std::string>& arguments) const {
  std::vector<std::string> command = {PLIMSOLL_PROGRAM};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return spawn(command, {});
}

Outcome Workplace::run(const std::vector<std::string>& arguments,
                       const std::vector<std::string>& variables) const {
  std::vector<std::string> command = {PLIMSOLL_PROGRAM};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return finish(spawn(command, variables));
}

Outcome Workplace::shell(const std::string& command) const {
  return finish(spawn({"/bin/sh", "-c", command}, {}));
}

bool wait_until(const std::function<bool()>& condition) {
  for (int i = 0; i < 6000; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

bool wait_for_bytes(const fs::path& file, std::uintmax_t bytes) {
  return wait_until([&] {
    std::error_code error;
    const std::uintmax_t size = fs::file_size(file, error);
    return !error && size > bytes;
  });
}

std::string output_of(std::vector<std::string> words) {
  words.insert(words.begin(), "plimsoll");
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  testing::internal::CaptureStdout();
  std::string fault;
  try {
    EXPECT_EQ(app::command_line(static_cast<int>(argv.size()), argv.data()), 0);
  } catch (const scene::InputError& error) {
    fault = error.what();
  }
  return testing::internal::GetCapturedStdout() + fault;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string after_scene(const std::string& said) {
  std::size_t end = said.find('\n') + 1;
  while (said.compare(end, 2, "  ") == 0) end = said.find('\n', end) + 1;
  return said.substr(end);
}

std::string trajectory(const std::vector<std::string>& rows) {
  std::string text = kTrajectoryHeader;
  for (const std::string& row : rows) text += row + ",0,0,1,0,0,0,0,0,0,0,0,0\n";
  return text;
}

std::string falling_box(const std::string& duration, const std::string& more) {
  return "plimsoll: 1\ntitle: Falling box\nduration: " + duration +
         "\nstep: 0.01\nwater: {}\n"
         "bodies:\n"
         "  - {name: box, box: {size: [1, 1, 1], divisions: 2}, density: 500, "
         "position: [0, 0, 1], hydro: {added_mass: none}}\n" +
         more;
}

}  // namespace support
