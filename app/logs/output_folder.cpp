#include "app/logs/output_folder.h"

#include <fcntl.h>
#include <fmt/format.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <system_error>
#include <thread>

#include "app/base/atomic_file.h"
#include "app/base/open_file.h"
#include "app/base/output_error.h"
#include "app/scene/diagnostics.h"

namespace app {
namespace {

/// A killed run may still be writing what it has begun (Hdf5Writer::flush).
constexpr std::chrono::seconds kPatience(1);

}  // namespace

OutputFolder::OutputFolder(const std::filesystem::path& path, Use use) : path_(path) {
  std::error_code error;
  std::filesystem::create_directories(path_, error);
  if (error) throw scene::InputError(path_, fmt::format("cannot be made: {}", error.message()));
  lock_ = LockedFile(::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!lock_.is_open())
    throw scene::InputError(path_, fmt::format("cannot be opened: {}", std::strerror(errno)));
  using Lock = LockedFile::Lock;
  const Lock lock = use == Use::alone ? Lock::exclusive : Lock::shared;
  const auto patient_until = std::chrono::steady_clock::now() + kPatience;
  while (!lock_.try_lock(lock)) {
    if (std::chrono::steady_clock::now() < patient_until) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      continue;
    }
    throw scene::InputError(path_,
                            "another run is writing to this folder; name another with --out");
  }
  remove_left_parts(path_);
}

bool OutputFolder::is_in_place() const { return has_name(lock_.descriptor(), path_); }

void OutputFolder::check_place() const {
  if (!is_in_place())
    throw OutputError(fmt::format("{}: cannot be written: {}", path_.string(), kGone));
}

}  // namespace app
