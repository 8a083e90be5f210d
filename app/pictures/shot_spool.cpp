#include "app/pictures/shot_spool.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <cmath>
#include <cstdint>
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

/// Numbers at the start of a shot: the time, the flags for frames and video, the numbers of waters,
/// lines, propellers and foils, and how many numbers the nodes of lines and the water have.
constexpr std::size_t kHeadSize = 9;

/// Numbers of the bodies' waves before the heights: cell, origin, heights along a side, and the
/// unit of the heights, which are whole numbers of 16 bits, four in place of a number.
constexpr std::size_t kPatchSize = 5;

/// Numbers of the water in a pocket: the body, a point, the level, and whether it is flooded.
constexpr std::size_t kWaterSize = 6;

/// Numbers of a line: tension, length, whether it is broken, and how many nodes it has. The places
/// of the nodes of all lines follow the foils.
constexpr std::size_t kLineSize = 4;

/// Numbers of a propeller: turn and azimuth.
constexpr std::size_t kPropellerSize = 2;

using Numbers = std::vector<double>;

/// Numbers that heights of a square patch take.
std::size_t numbers_of_heights(std::size_t side) { return (side * side + 3) / 4; }

void add_patch(const hydro::SurfacePatch& patch, Numbers& numbers) {
  const auto side = static_cast<std::size_t>(patch.heights.cols());
  const float unit = std::max(patch.heights.cwiseAbs().maxCoeff(), 1e-30f) / 32767;
  numbers.insert(numbers.end(), {patch.cell, patch.origin.x(), patch.origin.y(),
                                 static_cast<double>(side), static_cast<double>(unit)});
  std::vector<std::int16_t> heights(4 * numbers_of_heights(side));
  std::transform(
      patch.heights.data(), patch.heights.data() + patch.heights.size(), heights.begin(),
      [&](float height) { return static_cast<std::int16_t>(std::lround(height / unit)); });
  numbers.resize(numbers.size() + heights.size() / 4);
  std::memcpy(&numbers[numbers.size() - heights.size() / 4], heights.data(), 2 * heights.size());
}

hydro::SurfacePatch read_patch(const double* numbers) {
  const auto side = static_cast<Eigen::Index>(numbers[3]);
  hydro::SurfacePatch patch{.heights = Eigen::MatrixXf(side, side),
                            .cell = numbers[0],
                            .origin = {numbers[1], numbers[2]}};
  Eigen::Matrix<std::int16_t, Eigen::Dynamic, Eigen::Dynamic> heights(side, side);
  std::memcpy(heights.data(), numbers + kPatchSize,
              sizeof(std::int16_t) * static_cast<std::size_t>(heights.size()));
  patch.heights = heights.cast<float>() * static_cast<float>(numbers[4]);
  return patch;
}

std::size_t count_waters(const render::Interiors& interiors) {
  std::size_t waters = 0;
  for (const auto& pockets : interiors) waters += pockets.size();
  return waters;
}

std::size_t numbers_of_nodes(const DrawnRig& rig) {
  std::size_t numbers = 0;
  for (const DrawnLine& line : rig.lines) numbers += 3 * line.nodes_W.size();
  return numbers;
}

std::size_t count_patch(const Shot& shot) {
  if (!shot.water) return 0;
  return kPatchSize + numbers_of_heights(static_cast<std::size_t>(shot.water->heights.cols()));
}

Numbers numbers_of(const Shot& shot) {
  Numbers numbers = {shot.time,
                     shot.frame ? 1.0 : 0.0,
                     shot.video ? 1.0 : 0.0,
                     static_cast<double>(count_waters(shot.interiors)),
                     static_cast<double>(shot.rig.lines.size()),
                     static_cast<double>(shot.rig.propellers.size()),
                     static_cast<double>(shot.rig.foil_angles.size()),
                     static_cast<double>(numbers_of_nodes(shot.rig)),
                     static_cast<double>(count_patch(shot))};
  for (const hydro::BodyState& state : shot.states) {
    const StateRow row = row_of(state);
    numbers.insert(numbers.end(), row.begin(), row.end());
  }
  for (std::size_t i = 0; i < shot.interiors.size(); ++i)
    for (const render::PocketLook& water : shot.interiors[i])
      numbers.insert(numbers.end(), {static_cast<double>(i), water.at_W.x(), water.at_W.y(),
                                     water.at_W.z(), water.level, water.flooded ? 1.0 : 0.0});
  for (const DrawnLine& line : shot.rig.lines)
    numbers.insert(numbers.end(), {line.tension, line.length, line.broken ? 1.0 : 0.0,
                                   static_cast<double>(line.nodes_W.size())});
  for (const DrawnPropeller& propeller : shot.rig.propellers)
    numbers.insert(numbers.end(), {propeller.turn, propeller.azimuth});
  numbers.insert(numbers.end(), shot.rig.foil_angles.begin(), shot.rig.foil_angles.end());
  for (const DrawnLine& line : shot.rig.lines)
    for (const Eigen::Vector3d& node : line.nodes_W)
      numbers.insert(numbers.end(), node.begin(), node.end());
  if (shot.water) add_patch(*shot.water, numbers);
  return numbers;
}

std::size_t count_of(double number) { return static_cast<std::size_t>(number); }

void read_rig(const double* head, const double* next, DrawnRig& rig) {
  for (std::size_t i = 0; i < count_of(head[4]); ++i, next += kLineSize) {
    rig.lines.push_back({.tension = next[0], .length = next[1], .broken = next[2] != 0});
    rig.lines.back().nodes_W.resize(count_of(next[3]));
  }
  for (std::size_t i = 0; i < count_of(head[5]); ++i, next += kPropellerSize)
    rig.propellers.push_back({.turn = next[0], .azimuth = next[1]});
  rig.foil_angles.assign(next, next + count_of(head[6]));
  next += count_of(head[6]);
  for (DrawnLine& line : rig.lines)
    for (Eigen::Vector3d& node : line.nodes_W) {
      node = Eigen::Vector3d(next);
      next += 3;
    }
}

/// Fills in what follows the head of a shot.
void read_rest(const double* head, const double* end, std::size_t bodies, Shot& shot) {
  const double* next = head + kHeadSize;
  const std::size_t waters = count_of(head[3]);
  for (std::size_t i = 0; i < bodies; ++i, next += kStateSize) {
    StateRow row;
    std::copy_n(next, kStateSize, row.begin());
    shot.states.push_back(state_of(row));
  }
  if (waters > 0) shot.interiors.resize(bodies);
  for (std::size_t i = 0; i < waters; ++i, next += kWaterSize)
    shot.interiors[static_cast<std::size_t>(next[0])].push_back(
        {.at_W = {next[1], next[2], next[3]}, .level = next[4], .flooded = next[5] != 0});
  read_rig(head, next, shot.rig);
  if (head[8] > 0) shot.water = read_patch(end - count_of(head[8]));
}

}  // namespace

ShotSpool::ShotSpool(const std::filesystem::path& file, std::size_t kept, std::size_t bodies)
    : file_(std::fopen(file.c_str(), kept > 0 ? "r+b" : "w+b")), bodies_(bodies) {
  if (!file_)
    throw scene::InputError(file, fmt::format("cannot be opened: {}", std::strerror(errno)));
  const std::uintmax_t size = std::filesystem::file_size(file);
  const auto refuse_short = [&](long needed) {
    if (size < static_cast<std::uintmax_t>(needed))
      throw scene::InputError(file, "is shorter than when its checkpoint was written");
  };
  while (size_ < kept) {
    refuse_short(places_.back() + static_cast<long>(kHeadSize * sizeof(double)));
    places_.push_back(end_of(size_));
    refuse_short(places_.back());
    const Shot shot = at(size_++);
    frames_ += shot.frame;
    of_video_ += shot.video;
  }
  std::filesystem::resize_file(file, static_cast<std::uintmax_t>(places_.back()));
}

/// Reads numbers of the file. @throws OutputError
std::vector<double> ShotSpool::read(long place, std::size_t count) const {
  std::vector<double> numbers(count);
  if (std::fseek(file_.get(), place, SEEK_SET) != 0 ||
      std::fread(numbers.data(), sizeof(double), count, file_.get()) != count)
    refuse("cannot read");
  return numbers;
}

/// Place of the end of a shot, by its head.
long ShotSpool::end_of(std::size_t number) const {
  const Numbers head = read(places_[number], kHeadSize);
  const std::size_t numbers = kHeadSize + bodies_ * kStateSize + count_of(head[3]) * kWaterSize +
                              count_of(head[4]) * kLineSize + count_of(head[5]) * kPropellerSize +
                              count_of(head[6]) + count_of(head[7]) + count_of(head[8]);
  return places_[number] + static_cast<long>(numbers * sizeof(double));
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
  const Numbers numbers = numbers_of(shot);
  if (std::fseek(file_.get(), 0, SEEK_END) != 0 ||
      std::fwrite(numbers.data(), sizeof(double), numbers.size(), file_.get()) != numbers.size() ||
      std::fflush(file_.get()) != 0)
    refuse("cannot keep");
  places_.push_back(places_.back() + static_cast<long>(numbers.size() * sizeof(double)));
  ++size_;
  frames_ += shot.frame;
  of_video_ += shot.video;
}

Shot ShotSpool::at(std::size_t number) const {
  assert(number + 1 < places_.size());
  const auto count =
      static_cast<std::size_t>(places_[number + 1] - places_[number]) / sizeof(double);
  const Numbers numbers = read(places_[number], count);
  Shot shot{.time = numbers[0], .states = {}, .frame = numbers[1] != 0, .video = numbers[2] != 0};
  read_rest(numbers.data(), numbers.data() + numbers.size(), bodies_, shot);
  return shot;
}

}  // namespace app
