#include "app/base/piped_program.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace app {
namespace {

namespace fs = std::filesystem;

/// The streams and signal settings that the program starts with.
class Surroundings {
 public:
  Surroundings(int input, int messages) {
    ::posix_spawn_file_actions_init(&actions_);
    ::posix_spawn_file_actions_adddup2(&actions_, input, STDIN_FILENO);
    ::posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_adddup2(&actions_, messages, STDERR_FILENO);
    // A process in a group of its own receives no Ctrl-C from the terminal.
    ::posix_spawnattr_init(&attributes_);
    ::posix_spawnattr_setpgroup(&attributes_, 0);
    sigset_t none;
    sigemptyset(&none);
    ::posix_spawnattr_setsigmask(&attributes_, &none);
    ::posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
  }
  ~Surroundings() {
    ::posix_spawnattr_destroy(&attributes_);
    ::posix_spawn_file_actions_destroy(&actions_);
  }
  Surroundings(const Surroundings&) = delete;
  Surroundings& operator=(const Surroundings&) = delete;

  /// @return 0, or the number of the error
  int start(std::vector<std::string> words, pid_t& process) const {
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    return ::posix_spawn(&process, pointers[0], &actions_, &attributes_, pointers.data(), environ);
  }

 private:
  posix_spawn_file_actions_t actions_;
  posix_spawnattr_t attributes_;
};

}  // namespace

fs::path find_program(const std::string& name) {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (folder.empty()) continue;
    const fs::path file = fs::path(folder) / name;
    std::error_code error;
    if (fs::is_regular_file(file, error) && ::access(file.c_str(), X_OK) == 0) return file;
  }
  return {};
}

PipedProgram::PipedProgram(const fs::path& program, const std::vector<std::string>& arguments) {
  std::vector<std::string> words = {program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::array<int, 2> ends = {-1, -1};
  int error = ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) == 0 ? 0 : errno;
  messages_ = ::memfd_create("messages", MFD_CLOEXEC);
  if (messages_ < 0 && error == 0) error = errno;
  if (error == 0) error = Surroundings(ends[1], messages_).start(words, process_);
  if (ends[1] >= 0) ::close(ends[1]);
  input_ = ends[0];
  if (error == 0) return;
  if (input_ >= 0) ::close(input_);
  if (messages_ >= 0) ::close(messages_);
  throw std::runtime_error(
      fmt::format("{} cannot be started: {}", program.string(), std::strerror(error)));
}

PipedProgram::~PipedProgram() {
  if (process_ > 0) {
    ::kill(process_, SIGKILL);
    finish();
  }
  ::close(messages_);
}

bool PipedProgram::write(std::span<const std::uint8_t> bytes) const {
  while (!bytes.empty()) {
    // A write to a socket, unlike one to a pipe, can avoid SIGPIPE when there is no reader.
    const ssize_t written = ::send(input_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return true;
}

bool PipedProgram::finish() {
  ::close(input_);
  int status = 0;
  while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) continue;
  process_ = 0;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

std::vector<std::string> PipedProgram::messages() const {
  std::string text;
  std::array<char, 4096> part = {};
  ssize_t size = 0;
  while ((size = ::pread(messages_, part.data(), part.size(), static_cast<off_t>(text.size()))) > 0)
    text.append(part.data(), static_cast<std::size_t>(size));
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);)
    if (!line.empty()) lines.push_back(line);
  return lines;
}

}  // namespace app
