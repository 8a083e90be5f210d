#include "app/base/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>
#include <system_error>

namespace app {
namespace {

namespace fs = std::filesystem;

/// Names of temporary files hold this mark before a number that distinguishes them.
const char* const kPart = ".part-";

[[noreturn]] void fail(const fs::path& file, int error) {
  throw std::runtime_error(
      fmt::format("{} cannot be written: {}", file.string(), std::strerror(error)));
}

/// Removes the old temporary files of killed processes for files with the same extension.
void remove_old_parts(const fs::path& file) {
  const std::string mark = file.extension().string() + kPart;
  const auto yesterday = fs::file_time_type::clock::now() - std::chrono::hours(24);
  std::error_code error;
  for (fs::directory_iterator entry("." / file.parent_path(), error), end; !error && entry != end;
       entry.increment(error)) {
    if (entry->path().filename().string().find(mark) == std::string::npos) continue;
    std::error_code ignored;
    if (entry->last_write_time(ignored) < yesterday && !ignored) fs::remove(entry->path(), ignored);
  }
}

}  // namespace

PartFile::PartFile(const fs::path& file) : file_(file) {
  constexpr mode_t kAsUmaskLeaves = 0666;
  remove_old_parts(file);
  // A process on another machine may have the same number.
  for (int i = 0; handle_ < 0; ++i) {
    name_ = fmt::format("{}{}{}-{}", file.string(), kPart, ::getpid(), i);
    handle_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kAsUmaskLeaves);
    if (handle_ < 0 && errno != EEXIST) fail(file_, errno);
  }
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
  const int closed = ::close(handle_);
  handle_ = -1;
  if (closed != 0 || std::rename(name_.c_str(), file_.c_str()) != 0) fail(file_, errno);
  renamed_ = true;
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
