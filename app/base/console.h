#pragma once

#include <cstddef>
#include <string>

/// @file
/// The program's standard streams: results go to standard output, messages to standard error.

namespace app {

/// Opens /dev/null for each standard stream that the caller has closed, so that no output file
/// takes its descriptor.
void open_standard_streams();

/// True if what is written to a standard stream may have colours: it is a terminal, and neither
/// NO_COLOR (no-color.org) nor TERM=dumb asks for none.
/// @param stream   STDOUT_FILENO or STDERR_FILENO.
bool in_color(int stream);

/// Writes a line to standard error and ignores errors. Control characters but line breaks and tabs
/// stand as escapes, here and in what `print` writes, since names and texts of scenes may hold some
/// that a terminal would obey. In colour the words `error:`, `warning:` and `note:` stand out where
/// one begins a line or follows its place.
void say(const std::string& line);

/// Writes a text to standard output; `flush_output` tells of errors.
void print(const std::string& text);

/// Prints a line as `say` writes it.
void print_message(const std::string& line);

/// Returns a count with its noun: `1 body`, `2 bodies`.
std::string counted(std::size_t count, const std::string& one, const std::string& many);

/// Flushes standard output.
/// @throws std::runtime_error if the output could not be written
void flush_output();

}  // namespace app
