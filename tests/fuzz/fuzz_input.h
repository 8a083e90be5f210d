#pragma once

#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

#include "app/scene/diagnostics.h"

/// @file
/// What the targets of libFuzzer share. A reader may accept an input or throw InputError with at
/// least one fault; anything else ends the process, which libFuzzer reports.

namespace fuzz {

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// A file in memory, for readers that take a path. It is written anew for each input.
class InputFile {
 public:
  explicit InputFile(const std::string& name)
      : path_(std::filesystem::path("/dev/shm") /
              ("plimsoll_fuzz_" + std::to_string(::getpid()) + "_" + name)) {}
  ~InputFile() { std::remove(path_.c_str()); }
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  const std::filesystem::path& holding(std::string_view bytes) const {
    std::FILE* const file = std::fopen(path_.c_str(), "wb");
    if (file == nullptr || std::fwrite(bytes.data(), 1, bytes.size(), file) != bytes.size())
      std::abort();
    std::fclose(file);
    return path_;
  }

 private:
  std::filesystem::path path_;
};

/// Calls a reader. Faults must name the file they are found in.
template <class Read>
void expect_content_or_faults(const std::string& name, const Read& read) {
  try {
    read();
  } catch (const scene::InputError& error) {
    if (error.faults().empty()) std::abort();
    for (const scene::Fault& fault : error.faults())
      if (to_string(fault).find(name) == std::string::npos) std::abort();
  }
}

}  // namespace fuzz
