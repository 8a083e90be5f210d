#pragma once

#include <cstddef>
#include <string_view>

namespace app {

/// Returns the length of the character at the start of a text, which is not empty, by Unicode's
/// table 3-7 [bytes]; 0 if the text does not start with one.
std::size_t utf8_length(std::string_view text);

/// True if a character of UTF-8 is a control character of ASCII or of U+0080 to U+009F.
bool is_control(std::string_view character);

}  // namespace app
