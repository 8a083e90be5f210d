#include "app/logs/row_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "app/base/output_error.h"
#include "app/scene/diagnostics.h"

namespace app {

RowFile::RowFile(const std::filesystem::path& file, std::string_view header,
                 const std::optional<std::uint64_t>& kept)
    : path_(file), file_(std::fopen(file.c_str(), kept ? "r+" : "w")) {
  if (!file_)
    throw scene::InputError(path_, fmt::format("cannot be written: {}", std::strerror(errno)));
  if (!kept) {
    fmt::print(file_.get(), "{}\n", header);
    return;
  }
  if (std::filesystem::file_size(path_) < *kept)
    throw scene::InputError(path_, "is shorter than when its checkpoint was written");
  std::filesystem::resize_file(path_, *kept);
  std::fseek(file_.get(), 0, SEEK_END);
}

void RowFile::add(const fmt::memory_buffer& rows) {
  const std::size_t written = std::fwrite(rows.data(), 1, rows.size(), file_.get());
  if (written != rows.size() || std::fflush(file_.get()) != 0) fail();
}

std::uint64_t RowFile::save() {
  if (std::fflush(file_.get()) != 0 || ::fdatasync(::fileno(file_.get())) != 0) fail();
  return static_cast<std::uint64_t>(std::ftell(file_.get()));
}

void RowFile::fail() const {
  throw OutputError(fmt::format("{}: cannot be written: {}", path_.string(), std::strerror(errno)));
}

}  // namespace app
