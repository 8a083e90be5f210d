#include "app/logs/row_file.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "app/base/open_file.h"
#include "app/base/output_error.h"
#include "app/scene/diagnostics.h"

namespace app {

RowFile::RowFile(const std::filesystem::path& file, std::string_view header,
                 const std::optional<FilePosition>& kept)
    : path_(file), file_(std::fopen(file.c_str(), kept ? "r+" : "w")) {
  if (!file_)
    throw scene::InputError(path_, fmt::format("cannot be written: {}", std::strerror(errno)));
  if (kept) {
    keep(*kept);
    return;
  }
  const std::string line = std::string(header) + "\n";
  std::fputs(line.c_str(), file_.get());
  hash_.add(line);
}

void RowFile::keep(const FilePosition& kept) {
  if (std::filesystem::file_size(path_) < kept.bytes)
    throw scene::InputError(path_, "is shorter than when its checkpoint was written");
  std::array<char, 1 << 16> part;
  for (std::uint64_t left = kept.bytes; left > 0;) {
    const std::size_t read = std::fread(
        part.data(), 1, static_cast<std::size_t>(std::min<std::uint64_t>(left, part.size())),
        file_.get());
    if (read == 0) throw scene::InputError(path_, "cannot be read");
    hash_.add({part.data(), read});
    left -= read;
  }
  if (hash_.value() != kept.hash)
    throw scene::InputError(path_, "has changed since its checkpoint was written");
  std::filesystem::resize_file(path_, kept.bytes);
  std::fseek(file_.get(), 0, SEEK_END);
}

void RowFile::add(const fmt::memory_buffer& rows) {
  const std::size_t written = std::fwrite(rows.data(), 1, rows.size(), file_.get());
  if (written != rows.size() || std::fflush(file_.get()) != 0) fail(std::strerror(errno));
  hash_.add({rows.data(), rows.size()});
}

FilePosition RowFile::save() {
  if (std::fflush(file_.get()) != 0 || ::fdatasync(::fileno(file_.get())) != 0)
    fail(std::strerror(errno));
  check_place();
  return {.bytes = static_cast<std::uint64_t>(std::ftell(file_.get())), .hash = hash_.value()};
}

void RowFile::check_place() const {
  if (!has_name(::fileno(file_.get()), path_)) fail(kGone);
}

void RowFile::fail(const std::string& why) const {
  throw OutputError(fmt::format("{}: cannot be written: {}", path_.string(), why));
}

}  // namespace app
