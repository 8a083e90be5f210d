#pragma once

#include <cstddef>
#include <string>

/// @file
/// The program's standard streams: results go to the output, everything said about them to the
/// error stream.

namespace app {

/// Opens those of the three standard streams that the caller has closed, on nothing: a file that is
/// written must not take their place.
void open_standard_streams();

/// Writes a line to standard error. Whether anybody reads it does not matter to the program.
void say(const std::string& line);

/// `1 body`, `2 bodies`.
std::string counted(std::size_t count, const std::string& one, const std::string& many);

/// Hands over what was printed to standard output.
/// @throws std::runtime_error if it could not be written
void flush_output();

}  // namespace app
