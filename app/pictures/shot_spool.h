#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "app/pictures/drawn_rig.h"
#include "app/render/interior_look.h"
#include "hydro/spatial.h"
#include "hydro/water/simulated_water.h"

namespace app {

/// States of all bodies at a time for which pictures are drawn.
struct Shot {
  double time = 0;  ///< [s]
  std::vector<hydro::BodyState> states;
  bool frame = true;                 ///< True: the shot is drawn for `frames/` and the sheet.
  bool video = false;                ///< True: the shot is drawn for the video.
  render::Interiors interiors = {};  ///< The water in the bodies' hollows; empty: they are dry.
  DrawnRig rig = {};                 ///< Lines and machines.
  std::optional<hydro::SurfacePatch> water = {};  ///< The bodies' waves; none: the water is still.

  bool operator==(const Shot&) const = default;
};

/// Shots of a sequence, all with the same bodies. They are stored in a file, so that the memory of
/// a run does not grow with its length. An unnamed file disappears with the process; a named file
/// is found again by a resumed run.
class ShotSpool {
 public:
  ShotSpool() = default;
  /// Stores the shots in a named file and retains its first `kept` shots of `bodies` bodies.
  /// @throws InputError if that file cannot be opened or has fewer shots
  ShotSpool(const std::filesystem::path& file, std::size_t kept, std::size_t bodies);

  /// @throws OutputError if the disk is full.
  void add(const Shot& shot);

  /// Flushes all shots to the disk. @throws OutputError
  void save();

  std::size_t size() const { return size_; }
  std::size_t frames() const { return frames_; }      ///< Number of shots for frames.
  std::size_t of_video() const { return of_video_; }  ///< Number of shots for the video.
  /// Returns a shot by its number from 0. @throws OutputError if it cannot be read.
  Shot at(std::size_t number) const;

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::vector<double> read(long place, std::size_t count) const;
  long end_of(std::size_t number) const;

  std::unique_ptr<std::FILE, Close> file_;  ///< None before the first shot.
  std::size_t bodies_ = 0;
  std::vector<long> places_ = {0};  ///< Places of the shots in the file, and its end [bytes].
  std::size_t size_ = 0, frames_ = 0, of_video_ = 0;
};

}  // namespace app
