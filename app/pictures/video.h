#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/base/atomic_file.h"
#include "app/base/piped_program.h"
#include "app/render/image.h"

/// @file
/// Videos of a run's pictures, made by the ffmpeg program beside it: .mp4 (H.264), .webm (VP9) and
/// .gif.

namespace app {

/// What the command line asks for.
struct VideoOptions {
  std::filesystem::path file;  ///< Empty: no video. That of one of several cameras: video_file.
  int fps = 25;                ///< Pictures in a second.

  bool wanted() const { return !file.empty(); }
  /// Pictures in a second of simulated time; 0 without a video.
  int pictures_a_second() const { return wanted() ? fps : 0; }
};

/// What an encoder must know of the pictures.
struct VideoShape {
  int width = 0;
  int height = 0;
  int fps = 25;
  int threads = 1;  ///< That it may use.
};

/// The ending of a name, in small letters: `.mp4`.
std::string video_ending(const std::filesystem::path& file);
/// Those of videos that can be made.
std::vector<std::string> video_endings();

/// A video that is being made, in a file beside its own until it is done: what is not done leaves
/// nothing.
class Video {
 public:
  /// Starts the encoder. @param file   With one of the endings.
  /// @throws std::runtime_error if that is not possible
  Video(const std::filesystem::path& file, const VideoShape& shape);

  /// The next picture. It may wait for the encoder, and is not kept.
  /// @throws OutputError with what the encoder says
  void add(const render::Image& picture);

  /// Puts the video in its place. @throws OutputError with what the encoder says
  void finish();

 private:
  [[noreturn]] void fail();

  std::filesystem::path file_;
  PartFile part_;
  PipedProgram encoder_;
};

/// What keeps the encoder from making a video of one blank picture; empty if nothing does.
std::string encoder_fault(const std::filesystem::path& file, const VideoShape& shape);

}  // namespace app
