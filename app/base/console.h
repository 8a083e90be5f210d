#pragma once

#include <cstddef>
#include <string>

/// @file
/// The program's standard streams: results go to standard output, messages to standard error.

namespace app {

/// Opens /dev/null for each standard stream that the caller has closed, so that no output file
/// takes its descriptor.
void open_standard_streams();

/// Writes a line to standard error and ignores errors.
void say(const std::string& line);

/// Returns a count with its noun: `1 body`, `2 bodies`.
std::string counted(std::size_t count, const std::string& one, const std::string& many);

/// Flushes standard output.
/// @throws std::runtime_error if the output could not be written
void flush_output();

}  // namespace app
