#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

/// @file
/// The built program as its users meet it: a process with arguments, streams and an exit code.

namespace support {

inline const std::string kTrajectoryHeader = "time,body,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz\n";

/// How a process ended and what it said.
struct Outcome {
  int code = 0;  ///< Exit code; minus the signal's number if a signal ended it.
  std::string out;
  std::string err;
};

/// A folder for one test, removed with it, in which the program is run.
class Workplace {
 public:
  Workplace();
  ~Workplace();
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;

  std::filesystem::path operator/(const std::filesystem::path& file) const {
    return folder_ / file;
  }

  /// Writes a file. @return its name, as it is given to the program.
  std::string write(const std::string& name, const std::string& text) const;
  /// The content of a file; empty if there is none.
  std::string read(const std::filesystem::path& file) const;

  /// Runs the program to its end. @param variables   `NAME=VALUE`, added to its environment.
  Outcome run(const std::vector<std::string>& arguments,
              const std::vector<std::string>& variables = {}) const;
  /// Runs a shell command to its end; the program is `$PLIMSOLL` there.
  Outcome shell(const std::string& command) const;

  /// Starts the program, saying to the files `out.txt` and `err.txt`, and does not wait.
  pid_t start(const std::vector<std::string>& arguments) const;
  /// Waits for the end of what was started.
  Outcome finish(pid_t process) const;

 private:
  pid_t spawn(const std::vector<std::string>& command,
              const std::vector<std::string>& variables) const;
  std::filesystem::path folder_;
};

/// Waits until the condition holds, for a minute at most. False if it does not.
bool wait_until(const std::function<bool()>& condition);

/// Waits until a file has more bytes than these, for a minute at most. False if it has not.
bool wait_for_bytes(const std::filesystem::path& file, std::uintmax_t bytes);

/// What the program prints within this process, or the fault it throws.
/// @param words   Of the command line, without the program's name.
std::string output_of(std::vector<std::string> words);

/// Values of --threads: without a thread that writes files, and with one.
inline constexpr const char* kWriterThreads[] = {"1", "2"};

/// Lines of a text, without their ends.
std::vector<std::string> lines_of(const std::string& text);

/// What `run` says after what it made of the scene: a line, and more of them that begin with
/// spaces.
std::string after_scene(const std::string& said);

/// A trajectory file of `time,body,x` rows of bodies at y = z = 0, upright.
std::string trajectory(const std::vector<std::string>& rows);

/// A scene of one box, without added mass, that falls into water in steps of 0.01 s, and further
/// keys of the top level.
std::string falling_box(const std::string& duration, const std::string& more = "");

}  // namespace support
