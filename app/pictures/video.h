#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/base/atomic_file.h"
#include "app/base/piped_program.h"
#include "app/render/image.h"

/// @file
/// Videos of a run's pictures, encoded by a separate ffmpeg process: .mp4 (H.264), .webm (VP9) and
/// .gif.

namespace app {

/// Video that the command line asks for.
struct VideoOptions {
  std::filesystem::path file;  ///< Empty: no video. With several cameras see video_by.
  int fps = 25;                ///< Pictures per second.
  std::string camera = {};     ///< The only camera that makes a video; empty: each makes one.

  bool wanted() const { return !file.empty(); }
  /// Returns the pictures per second of simulated time; 0 without a video.
  int pictures_a_second() const { return wanted() ? fps : 0; }
};

/// Properties of the pictures that an encoder must know.
struct VideoShape {
  int width = 0;
  int height = 0;
  int fps = 25;
  int threads = 1;  ///< Threads that the encoder may use.
};

/// Returns the extension of a file in lower case: `.mp4`.
std::string video_ending(const std::filesystem::path& file);
/// Returns the extensions of the supported video formats.
std::vector<std::string> video_endings();

/// A video that is being encoded, in a temporary file until it is complete. An incomplete video
/// leaves no file.
class Video {
 public:
  /// Starts the encoder. @param file   Video with one of the extensions.
  /// @throws std::runtime_error if it cannot be started
  Video(const std::filesystem::path& file, const VideoShape& shape);

  /// Encodes the next picture; may wait for the encoder.
  /// @throws OutputError with the encoder's message
  void add(const render::Image& picture);

  /// Completes the video under its own name. @throws OutputError with the encoder's message
  void finish();

 private:
  [[noreturn]] void fail();

  std::filesystem::path file_;
  PartFile part_;
  PipedProgram encoder_;
};

/// Returns why the encoder cannot make a video of one blank picture; empty if it can.
std::string encoder_fault(const std::filesystem::path& file, const VideoShape& shape);

}  // namespace app
