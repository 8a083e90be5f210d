#pragma once

#include <string>
#include <string_view>

/// @file
/// Texts of the user, such as names and paths, inside files with a syntax of their own.

namespace app {

/// Returns a text with U+FFFD for each byte that does not belong to UTF-8.
std::string valid_utf8(std::string_view text);

/// Returns a text that a terminal shows and does not obey: a control character stands as `\n`,
/// `\x1b` or, beyond ASCII's first 32, `\u009b`, which JSON understands as well; a byte that does
/// not belong to UTF-8 stands as `\xff`.
/// @param kept   Control characters of ASCII that stay.
std::string shown(std::string_view text, std::string_view kept = "");

/// Returns a text for the content of an element of XML or an attribute in double quotes. Characters
/// that XML cannot hold, such as control characters, become U+FFFD.
std::string xml_text(std::string_view text);

/// Returns a text as a field of CSV by RFC 4180: in double quotes, doubled inside, where it has a
/// comma, a double quote or a line break.
std::string csv_field(std::string_view text);

/// Returns a word that a shell takes literally, on one line: in quotes if it has other characters
/// than letters, digits and `_@%+:,./-`. Control characters, which could begin a new line in a
/// comment, are written as in `$'\n'`, which bash and zsh understand.
std::string shell_word(std::string_view word);

}  // namespace app
