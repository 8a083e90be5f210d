#include "app/pictures/shot_spool.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <cstring>
#include <tuple>

#include "app/base/output_error.h"
#include "app/logs/trajectory.h"
#include "app/scene/diagnostics.h"

namespace app {
namespace {

constexpr std::size_t kStateSize = std::tuple_size_v<StateRow>;

[[noreturn]] void refuse(const char* what) {
  throw OutputError(fmt::format("{} the states to be drawn: {}", what, std::strerror(errno)));
}

/// Returns the count of numbers in a shot: the time, the flags for frames and video, and the
/// states.
std::size_t numbers_in(std::size_t bodies) { return 3 + bodies * kStateSize; }

}  // namespace

ShotSpool::ShotSpool(const std::filesystem::path& file, std::size_t kept, std::size_t bodies)
    : file_(std::fopen(file.c_str(), kept > 0 ? "r+b" : "w+b")), bodies_(bodies) {
  if (!file_)
    throw scene::InputError(file, fmt::format("cannot be opened: {}", std::strerror(errno)));
  const std::size_t bytes = kept * numbers_in(bodies) * sizeof(double);
  if (std::filesystem::file_size(file) < bytes)
    throw scene::InputError(file, "is shorter than when its checkpoint was written");
  std::filesystem::resize_file(file, bytes);
  for (size_ = 0; size_ < kept;) {
    ++size_;
    const Shot shot = at(size_ - 1);
    frames_ += shot.frame;
    of_video_ += shot.video;
  }
}

void ShotSpool::save() {
  if (file_ && ::fdatasync(::fileno(file_.get())) != 0) refuse("cannot keep");
}

void ShotSpool::add(const Shot& shot) {
  if (!file_) {
    file_.reset(std::tmpfile());
    if (!file_) refuse("cannot keep");
    bodies_ = shot.states.size();
  }
  assert(shot.states.size() == bodies_);
  std::vector<double> numbers = {shot.time, shot.frame ? 1.0 : 0.0, shot.video ? 1.0 : 0.0};
  for (const hydro::BodyState& state : shot.states) {
    const StateRow row = row_of(state);
    numbers.insert(numbers.end(), row.begin(), row.end());
  }
  if (std::fseek(file_.get(), 0, SEEK_END) != 0 ||
      std::fwrite(numbers.data(), sizeof(double), numbers.size(), file_.get()) != numbers.size() ||
      std::fflush(file_.get()) != 0)
    refuse("cannot keep");
  ++size_;
  frames_ += shot.frame;
  of_video_ += shot.video;
}

Shot ShotSpool::at(std::size_t number) const {
  assert(number < size_);
  std::vector<double> numbers(numbers_in(bodies_));
  const auto place = static_cast<long>(number * numbers.size() * sizeof(double));
  if (std::fseek(file_.get(), place, SEEK_SET) != 0 ||
      std::fread(numbers.data(), sizeof(double), numbers.size(), file_.get()) != numbers.size())
    refuse("cannot read");
  Shot shot{.time = numbers[0], .states = {}, .frame = numbers[1] != 0, .video = numbers[2] != 0};
  for (std::size_t i = 0; i < bodies_; ++i) {
    StateRow row;
    std::copy_n(&numbers[numbers_in(i)], kStateSize, row.begin());
    shot.states.push_back(state_of(row));
  }
  return shot;
}

}  // namespace app
