#include "app/sweep/sweep_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "app/base/atomic_file.h"
#include "app/base/checked_file.h"
#include "app/logs/run_files.h"
#include "app/scene/diagnostics.h"
#include "app/sweep/sweep_outcome.h"

namespace app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Result files in the folder of a run.
constexpr const char* kResults[] = {kOutcomeFile, kTrajectoryLog, kForceLog, kSummaryFile};

/// Returns a hash of a file's content; a missing file counts as empty.
std::string fingerprint(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  return fmt::format("{:016x}", hash_of(bytes));
}

/// Returns the identity as JSON, with keys that messages can name. The scene is represented by its
/// content, not its path.
Json to_json(const SweepIdentity& identity) {
  return {{"scene", fingerprint(identity.scene)},
          {"--set", identity.sets},
          {"--vary", identity.varied},
          {"--samples", identity.samples ? Json(*identity.samples) : Json(nullptr)},
          {"--seed", identity.samples ? Json(identity.seed) : Json(nullptr)}};
}

/// Returns the first part in which a manifest differs; empty if there is none.
std::string changed_part(const Json& manifest, const SweepIdentity& identity) {
  if (!manifest.is_object() || !manifest.contains("sweep") || !manifest.contains("files"))
    return "all, or is cut off";
  const Json asked = to_json(identity);
  for (const auto& [part, value] : asked.items())
    if (manifest["sweep"].value(part, Json()) != value) return part;
  for (const auto& [file, value] : manifest["files"].items())
    if (fingerprint(file) != value) return file;
  return "";
}

}  // namespace

RunSlot::RunSlot(fs::path path) : path_(std::move(path)) {
  std::error_code error;
  fs::create_directories(path_, error);
  if (error) throw scene::InputError(path_, fmt::format("cannot be made: {}", error.message()));
  constexpr mode_t kReadByAll = 0644;
  messages_ = LockedFile(
      ::open(messages_file().c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, kReadByAll));
  if (!messages_.is_open())
    throw scene::InputError(messages_file(),
                            fmt::format("cannot be written: {}", std::strerror(errno)));
  if (!messages_.try_lock(LockedFile::Lock::exclusive))
    throw scene::InputError(path_, "another sweep is doing this run");
  for (const char* result : kResults) fs::remove(path_ / result, error);
  if (::ftruncate(messages(), 0) != 0)
    throw scene::InputError(messages_file(),
                            fmt::format("cannot be written: {}", std::strerror(errno)));
}

SweepFolder::SweepFolder(const fs::path& path, OutputFolder::Use use)
    : folder_(path, use), alone_(use == OutputFolder::Use::alone) {}

fs::path SweepFolder::run_folder(std::size_t run) const { return path() / "runs" / run_name(run); }

fs::path SweepFolder::outcome_file(std::size_t run) const { return run_folder(run) / kOutcomeFile; }

void SweepFolder::clear() const {
  if (!fs::exists(manifest_file())) return;
  std::error_code error;
  for (const fs::path& path :
       {this->path() / "runs", table_file(), script_file(), manifest_file()}) {
    fs::remove_all(path, error);
    if (error) throw scene::InputError(path, fmt::format("cannot be removed: {}", error.message()));
  }
}

bool SweepFolder::holds(const SweepIdentity& identity) const {
  if (!fs::exists(manifest_file())) return false;
  std::ifstream stream(manifest_file());
  const std::string changed = changed_part(Json::parse(stream, nullptr, false), identity);
  if (changed.empty()) return true;
  throw scene::InputError(
      path(), fmt::format("holds a sweep that differs from this one in {}; --fresh removes it and "
                          "starts anew, another --out keeps it",
                          changed));
}

void SweepFolder::begin(const SweepIdentity& identity, const std::set<fs::path>& files) const {
  std::error_code error;
  // In a shared folder the runs may be those of another process that has begun the same sweep.
  if (alone_ && !fs::is_empty(path() / "runs", error) && !error)
    throw scene::InputError(path() / "runs", "holds what no sweep has written; name another --out");
  Json manifest = {
      {"scene", identity.scene.string()}, {"sweep", to_json(identity)}, {"files", Json::object()}};
  for (const fs::path& file : files) manifest["files"][file.string()] = fingerprint(file);
  write_whole(manifest_file(), manifest.dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
}

}  // namespace app
