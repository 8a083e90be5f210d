#include "app/base/quoting.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/base/utf8.h"

namespace app {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

bool is_ascii_control(char c) { return is_control(std::string_view(&c, 1)); }

/// U+FFFE and U+FFFF are no characters of XML.
bool fits_in_xml(std::string_view character) {
  if (character.size() == 1)
    return !is_control(character) || character[0] == '\n' || character[0] == '\t';
  return character != "\xEF\xBF\xBE" && character != "\xEF\xBF\xBF";
}

/// Returns the escape of a control character.
std::string escape_of(std::string_view control) {
  const auto last = static_cast<unsigned char>(control.back());
  switch (last) {
    case '\n':
      return "\\n";
    case '\r':
      return "\\r";
    case '\t':
      return "\\t";
    default:
      return last < 0x20 ? fmt::format("\\x{:02x}", last) : fmt::format("\\u{:04x}", last);
  }
}

std::string_view entity_of(char c) {
  switch (c) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\n':
      return "&#10;";
    case '\t':
      return "&#9;";
    default:
      return "";
  }
}

}  // namespace

std::string valid_utf8(std::string_view text) {
  std::string valid;
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    valid += length > 0 ? text.substr(0, length) : kReplacement;
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return valid;
}

std::string shown(std::string_view text, std::string_view kept) {
  std::string safe;
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    const std::string_view character = text.substr(0, std::max<std::size_t>(length, 1));
    if (length == 0)
      safe += fmt::format("\\x{:02x}", static_cast<unsigned char>(text[0]));
    else if (is_control(character) && kept.find(character) == std::string_view::npos)
      safe += escape_of(character);
    else
      safe += character;
    text.remove_prefix(character.size());
  }
  return safe;
}

std::string xml_text(std::string_view text) {
  std::string safe;
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    const std::string_view character = text.substr(0, std::max<std::size_t>(length, 1));
    const std::string_view entity = entity_of(character[0]);
    if (length == 0 || !fits_in_xml(character))
      safe += kReplacement;
    else
      safe += entity.empty() ? character : entity;
    text.remove_prefix(character.size());
  }
  return safe;
}

std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

std::string shell_word(std::string_view word) {
  const bool plain = !word.empty() && word.find_first_not_of(
                                          "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                          "0123456789_@%+:,./-") == std::string_view::npos;
  if (plain) return std::string(word);
  const bool controls = std::ranges::any_of(word, is_ascii_control);
  std::string text = controls ? "$'" : "'";
  for (const char c : word) {
    if (is_ascii_control(c))
      text += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    else if (controls && (c == '\'' || c == '\\'))
      text += std::string("\\") + c;
    else
      text += c == '\'' ? "'\\''" : std::string(1, c);
  }
  return text + "'";
}

}  // namespace app
