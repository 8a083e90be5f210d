#include "app/base/console.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "app/base/quoting.h"

namespace app {
namespace {

/// Control characters that lines and columns are made of.
constexpr const char* kLayout = "\n\t";

/// Words that tell what a line is, and the codes of their colours on a terminal: bold red, bold
/// yellow and cyan.
constexpr std::pair<std::string_view, std::string_view> kMarks[] = {
    {"error:", "1;31"}, {"warning:", "1;33"}, {"note:", "36"}};

/// Colours the mark that begins a line or follows its place.
std::string marked(const std::string& line) {
  std::size_t first = std::string::npos;
  std::string_view mark, code;
  for (const auto& [word, color] : kMarks) {
    const std::size_t place = line.starts_with(word) ? 0 : line.find(": " + std::string(word));
    if (place >= first) continue;
    first = place;
    mark = word;
    code = color;
  }
  if (first == std::string::npos) return line;
  if (!line.starts_with(mark)) first += 2;
  return fmt::format("{}\033[{}m{}\033[0m{}", line.substr(0, first), code, mark,
                     line.substr(first + mark.size()));
}

/// Returns a message of several lines as a stream shows it.
std::string message(const std::string& text, int stream) {
  const std::string safe = shown(text, kLayout);
  if (!in_color(stream)) return safe;
  std::string all;
  for (std::size_t begin = 0; begin <= safe.size();) {
    const std::size_t end = std::min(safe.find('\n', begin), safe.size());
    all += (begin > 0 ? "\n" : "") + marked(safe.substr(begin, end - begin));
    begin = end + 1;
  }
  return all;
}

}  // namespace

void open_standard_streams() {
  for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream)
    if (::fcntl(stream, F_GETFD) < 0 && ::open("/dev/null", O_RDWR) < 0) return;
}

bool in_color(int stream) {
  const auto is = [](const char* name, std::string_view value) {
    const char* const found = std::getenv(name);
    return found != nullptr && (value.empty() ? *found != '\0' : found == value);
  };
  return ::isatty(stream) != 0 && !is("NO_COLOR", "") && !is("TERM", "dumb");
}

void say(const std::string& line) {
  const std::string text = message(line, STDERR_FILENO) + '\n';
  std::fflush(stdout);  // Earlier output stands before it; `flush_output` tells of faults.
  std::fwrite(text.data(), 1, text.size(), stderr);
}

void print(const std::string& text) {
  const std::string safe = shown(text, kLayout);
  std::fwrite(safe.data(), 1, safe.size(), stdout);
}

void print_message(const std::string& line) {
  const std::string text = message(line, STDOUT_FILENO) + '\n';
  std::fwrite(text.data(), 1, text.size(), stdout);
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
