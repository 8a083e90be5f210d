#include "app/base/console.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>

#include "app/base/quoting.h"

namespace app {
namespace {

/// Control characters that lines and columns are made of.
constexpr const char* kLayout = "\n\t";

}  // namespace

void open_standard_streams() {
  for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream)
    if (::fcntl(stream, F_GETFD) < 0 && ::open("/dev/null", O_RDWR) < 0) return;
}

void say(const std::string& line) {
  const std::string text = shown(line, kLayout) + '\n';
  std::fflush(stdout);  // Earlier output stands before it; `flush_output` tells of faults.
  std::fwrite(text.data(), 1, text.size(), stderr);
}

void print(const std::string& text) {
  const std::string safe = shown(text, kLayout);
  std::fwrite(safe.data(), 1, safe.size(), stdout);
}

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

void flush_output() {
  if (std::fflush(stdout) != 0 || std::ferror(stdout))
    throw std::runtime_error(
        fmt::format("standard output cannot be written: {}", std::strerror(errno)));
}

}  // namespace app
