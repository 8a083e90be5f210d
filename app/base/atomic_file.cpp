#include "app/base/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

#include "app/base/locked_file.h"
#include "app/base/open_file.h"

namespace app {
namespace {

namespace fs = std::filesystem;

/// Names of temporary files hold this mark before a number that distinguishes them.
const char* const kPart = ".part-";

[[noreturn]] void fail(const fs::path& file, int error) {
  throw std::runtime_error(
      fmt::format("{} cannot be written: {}", file.string(), std::strerror(error)));
}

/// True if a file is called as a temporary one: `NAME.csv.part-123-0`.
bool is_part(const std::string& name, const std::string& extension) {
  const std::size_t mark = name.rfind(kPart);
  if (mark == std::string::npos || !name.substr(0, mark).ends_with(extension)) return false;
  const std::string numbers = name.substr(mark + std::strlen(kPart));
  const std::size_t dash = numbers.find('-');
  return dash > 0 && dash + 1 < numbers.size() && numbers.rfind('-') == dash &&
         numbers.find_first_not_of("0123456789-") == std::string::npos;
}

bool is_of_yesterday(const fs::path& file) {
  std::error_code error;
  const auto written = fs::last_write_time(file, error);
  return !error && written < fs::file_time_type::clock::now() - std::chrono::hours(24);
}

/// Removes a temporary file unless its process is alive.
void remove_if_left(const fs::path& part) {
  const LockedFile file(::open(part.c_str(), O_WRONLY | O_NOFOLLOW | O_CLOEXEC));
  if (!file.is_open()) return;
  const bool locked = ::flock(file.descriptor(), LOCK_EX | LOCK_NB) == 0;
  if (!locked && (errno == EWOULDBLOCK || !is_of_yesterday(part))) return;
  // It may have been moved to its final name before the lock, and another one may have its name.
  if (!has_name(file.descriptor(), part)) return;
  std::error_code ignored;
  fs::remove(part, ignored);
}

}  // namespace

void remove_left_parts(const fs::path& folder, const std::string& extension) {
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
    if (is_part(entry->path().filename().string(), extension)) remove_if_left(entry->path());
}

PartFile::PartFile(const fs::path& file) : file_(file) {
  remove_left_parts("." / file.parent_path(), file.extension().string());
  // A process on another machine may have the same number.
  for (int i = 0; handle_ < 0; ++i) {
    name_ = fmt::format("{}{}{}-{}", file.string(), kPart, ::getpid(), i);
    if (!make() && errno != EEXIST) fail(file_, errno);
  }
}

bool PartFile::make() {
  constexpr mode_t kAsUmaskLeaves = 0666;
  handle_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kAsUmaskLeaves);
  if (handle_ < 0) return false;
  ::flock(handle_, LOCK_EX);
  if (has_name(handle_, name_)) return true;
  // Another process took it for one that was left, before it was locked.
  ::close(handle_);
  handle_ = -1;
  errno = EEXIST;
  return false;
}

PartFile::~PartFile() {
  if (handle_ >= 0) ::close(handle_);
  if (!renamed_) ::unlink(name_.c_str());
}

void PartFile::write(std::string_view bytes) const {
  while (!bytes.empty()) {
    const ssize_t written = ::write(handle_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) fail(file_, written < 0 ? errno : ENOSPC);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

void PartFile::rename() {
  if (::fsync(handle_) != 0) fail(file_, errno);
  // The lock ends with the handle, and without it others would remove the file.
  if (std::rename(name_.c_str(), file_.c_str()) != 0) fail(file_, errno);
  renamed_ = true;
  ::close(std::exchange(handle_, -1));
}

void write_whole(const fs::path& path, std::string_view bytes) {
  const fs::path file = path.has_parent_path() ? path : "." / path;
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  if (error) fail(file, error.value());
  PartFile part(file);
  part.write(bytes);
  part.rename();
}

}  // namespace app
