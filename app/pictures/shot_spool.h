#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <vector>

#include "hydro/spatial.h"

namespace app {

/// States of all bodies at a time that is to be drawn.
struct Shot {
  double time = 0;  ///< [s]
  std::vector<hydro::BodyState> states;
  bool frame = true;   ///< Of those in `frames/` and on the sheet.
  bool video = false;  ///< Of the video.

  bool operator==(const Shot&) const = default;
};

/// Shots of a sequence, all of the same bodies. They wait in a file, so that the memory of a run
/// does not grow with its length: one without a name, which goes with the process whatever becomes
/// of it, or a named one, which a resumed run finds again.
class ShotSpool {
 public:
  ShotSpool() = default;
  /// Keeps the shots in a named file, whose first `kept` shots of `bodies` bodies stay.
  /// @throws InputError if that file cannot be opened or has fewer
  ShotSpool(const std::filesystem::path& file, std::size_t kept, std::size_t bodies);

  /// @throws OutputError if there is no room.
  void add(const Shot& shot);

  /// Has the system put all shots on the disk. @throws OutputError
  void save();

  std::size_t size() const { return size_; }
  std::size_t frames() const { return frames_; }      ///< Of the shots.
  std::size_t of_video() const { return of_video_; }  ///< Of the shots.
  /// The shot as it was added, by its number from 0. @throws OutputError if it cannot be read.
  Shot at(std::size_t number) const;

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Close> file_;  ///< None before the first.
  std::size_t bodies_ = 0;
  std::size_t size_ = 0, frames_ = 0, of_video_ = 0;
};

}  // namespace app
