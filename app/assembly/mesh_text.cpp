#include "app/assembly/mesh_text.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <system_error>

#include "app/scene/diagnostics.h"

namespace assembly {
namespace {

namespace fs = std::filesystem;

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
bool is_line_end(char c) { return c == '\n' || c == '\r'; }

/// Value of a number that from_chars refuses for its size: 0 if too small, else infinity.
double out_of_range(std::string_view text) {
  const std::size_t exponent = text.find_first_of("eE");
  const bool small = exponent == std::string_view::npos
                         ? text.find_first_of("123456789") > text.find('.')
                         : text.substr(exponent + 1).starts_with('-');
  return small ? 0 : HUGE_VAL;
}

}  // namespace

void fault_at_line(const fs::path& file, int line, const std::string& message) {
  throw scene::InputError({scene::Fault{{.file = file, .line = line}, "", message}});
}

void fault_at_byte(const fs::path& file, std::uint64_t byte, const std::string& message) {
  throw scene::InputError(file, fmt::format("at byte {}: {}", byte, message));
}

MeshText::MeshText(const fs::path& file, std::string_view bytes, TextStyle style)
    : file_(file), bytes_(bytes), style_(style) {
  if (bytes_.starts_with("\xEF\xBB\xBF")) position_ = 3;  // byte order mark
}

void MeshText::fault(const std::string& message) const { fault_at_line(file_, line_, message); }

std::size_t MeshText::after_line_end(std::size_t position) const {
  if (position >= bytes_.size()) return position;
  return position + (bytes_.substr(position).starts_with("\r\n") ? 2 : 1);
}

void MeshText::skip_line_end() {
  position_ = after_line_end(position_);
  ++line_;
}

bool MeshText::at_line_end() const {
  if (position_ >= bytes_.size()) return true;
  const char c = bytes_[position_];
  return is_line_end(c) || (style_.comment != '\0' && c == style_.comment);
}

void MeshText::skip_blanks() {
  for (; position_ < bytes_.size(); ++position_) {
    if (is_blank(bytes_[position_])) continue;
    if (!style_.continued || bytes_[position_] != '\\') return;
    if (position_ + 1 >= bytes_.size() || !is_line_end(bytes_[position_ + 1])) return;
    position_ = after_line_end(position_ + 1) - 1;
    ++line_;
  }
}

void MeshText::skip_line() {
  while (position_ < bytes_.size() && !is_line_end(bytes_[position_])) ++position_;
}

bool MeshText::next_line() {
  if (begun_) {
    // A continued line ends where the last of its lines does.
    while (style_.continued && has_word()) word();
    skip_line();
    skip_line_end();
  }
  begun_ = true;
  while (position_ < bytes_.size()) {
    if (has_word()) return true;
    skip_line();
    if (position_ < bytes_.size()) skip_line_end();
  }
  return false;
}

bool MeshText::has_word() {
  skip_blanks();
  return !at_line_end();
}

std::string_view MeshText::word() {
  if (!has_word()) return {};
  const std::size_t first = position_;
  while (position_ < bytes_.size() && !is_blank(bytes_[position_]) && !at_line_end()) {
    const bool joins = style_.continued && bytes_[position_] == '\\' &&
                       position_ + 1 < bytes_.size() && is_line_end(bytes_[position_ + 1]);
    if (joins) break;
    ++position_;
  }
  return bytes_.substr(first, position_ - first);
}

double MeshText::number() {
  const std::string_view found = word();
  const bool plus = found.size() > 1 && found[0] == '+' && found[1] != '-';
  const std::string_view digits = found.substr(plus ? 1 : 0);  // from_chars accepts no plus
  const char* const end = digits.data() + digits.size();
  double value = 0;
  const auto [stop, error] = std::from_chars(digits.data(), end, value);
  if (error == std::errc::invalid_argument || stop != end)
    fault(found.empty() ? "the line ends where a number is expected"
                        : fmt::format("found {}, expected a number", in_quotes(found)));
  if (error == std::errc::result_out_of_range)
    value = digits.starts_with('-') ? -out_of_range(digits) : out_of_range(digits);
  return value;
}

std::int64_t MeshText::integer() {
  const std::string_view found = word();
  const std::string_view digits = found.substr(found.starts_with('+') ? 1 : 0);
  const char* const end = digits.data() + digits.size();
  std::int64_t value = 0;
  const auto [stop, error] = std::from_chars(digits.data(), end, value);
  if (error != std::errc{} || stop != end)
    fault(found.empty() ? "the line ends where a whole number is expected"
                        : fmt::format("found {}, expected a whole number", in_quotes(found)));
  return value;
}

Eigen::Vector3d MeshText::vector() {
  const double x = number(), y = number(), z = number();
  return {x, y, z};
}

std::string_view MeshText::rest() const {
  std::size_t end = position_;
  while (end < bytes_.size() && !is_line_end(bytes_[end])) ++end;
  return bytes_.substr(after_line_end(end));
}

std::string in_quotes(std::string_view word) {
  constexpr std::size_t kLongest = 40;
  std::string text(word.substr(0, kLongest));
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7e) c = '?';
  return fmt::format("'{}{}'", text, word.size() > kLongest ? "..." : "");
}

std::string lower(std::string_view word) {
  std::string text(word);
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

std::string bytes_of_mesh(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::error_code error;
  std::string bytes(static_cast<std::size_t>(fs::file_size(file, error)), '\0');
  if (error || !in.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
    throw scene::InputError(file, "the file cannot be read");
  return bytes;
}

}  // namespace assembly
