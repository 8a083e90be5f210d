#include "app/assembly/solution_files.h"

#include <fmt/format.h>

#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <system_error>

#include "app/base/atomic_file.h"
#include "app/base/checked_file.h"

namespace assembly {
namespace {

namespace fs = std::filesystem;

/// Returns the value of an environment variable; none if it is unset or empty.
std::optional<std::string> variable(const char* name) {
  const char* value = std::getenv(name);
  if (value == nullptr || *value == '\0') return std::nullopt;
  return value;
}

}  // namespace

fs::path SolutionFiles::file_of(const std::string& identity, const char* kind) const {
  return folder_ ? *folder_ / fmt::format("{:016x}.{}", app::hash_of(identity), kind) : fs::path();
}

std::optional<std::string> SolutionFiles::read(const std::string& identity, const char* kind,
                                               std::optional<std::size_t> size,
                                               app::Reporter& reporter) const {
  if (!folder_) return std::nullopt;
  const fs::path file = file_of(identity, kind);
  try {
    return app::read_checked(file, identity, size);
  } catch (const std::runtime_error& error) {
    reporter.warning(fmt::format("{} {}; {} is computed anew", file.string(), error.what(), what_));
  }
  return std::nullopt;
}

void SolutionFiles::write(const std::string& identity, const char* kind, const std::string& content,
                          app::Reporter& reporter) const {
  if (!folder_) return;
  try {
    app::write_whole(file_of(identity, kind), app::checked(identity, content));
  } catch (const std::exception& error) {
    reporter.warning(fmt::format("{} is not kept for later runs: {}", what_, error.what()));
  }
}

void append_mesh(std::string& bytes, const hydro::TriMesh& mesh) {
  app::append(bytes, static_cast<std::int64_t>(mesh.vertex_count()));
  app::append(bytes, static_cast<std::int64_t>(mesh.face_count()));
  const Eigen::Matrix3Xd vertices = mesh.vertices.array() + 0.0;  // −0 is 0
  app::append(bytes, vertices.data(), static_cast<std::size_t>(vertices.size()));
  app::append(bytes, mesh.faces.data(), static_cast<std::size_t>(mesh.faces.size()));
}

bool is_there(const fs::path& file) {
  std::error_code ignored;
  return !file.empty() && fs::exists(file, ignored);
}

std::optional<fs::path> cache_folder() {
  if (const auto folder = variable("PLIMSOLL_CACHE")) return *folder;
  const auto cache = variable("XDG_CACHE_HOME");
  if (cache && fs::path(*cache).is_absolute()) return fs::path(*cache) / "plimsoll";
  if (const auto home = variable("HOME")) return fs::path(*home) / ".cache" / "plimsoll";
  return std::nullopt;
}

}  // namespace assembly
