#include "app/logs/row_file.h"

#include <cerrno>
#include <cstring>

#include "app/base/output_error.h"
#include "app/scene/diagnostics.h"

namespace app {

RowFile::RowFile(const std::filesystem::path& file, std::string_view header)
    : path_(file), file_(std::fopen(file.c_str(), "w")) {
  if (!file_)
    throw scene::InputError(path_, fmt::format("cannot be written: {}", std::strerror(errno)));
  fmt::print(file_.get(), "{}\n", header);
}

void RowFile::add(const fmt::memory_buffer& rows) {
  const std::size_t written = std::fwrite(rows.data(), 1, rows.size(), file_.get());
  if (written != rows.size() || std::fflush(file_.get()) != 0)
    throw OutputError(
        fmt::format("{}: cannot be written: {}", path_.string(), std::strerror(errno)));
}

}  // namespace app
