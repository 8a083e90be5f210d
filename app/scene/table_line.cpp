#include "app/scene/table_line.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "app/scene/diagnostics.h"

namespace scene {
namespace {

constexpr std::string_view kSpace = " \t\r";
constexpr std::string_view kEnds = " \t\r,;";

}  // namespace

TableLine::TableLine(const std::filesystem::path& file, int number, std::string_view text,
                     std::string_view expected)
    : file_(file), number_(number), text_(text.substr(0, text.find('#'))), expected_(expected) {}

/// Calls `read` at the beginning of each field.
template <class Read>
void TableLine::read_fields(const Read& read) {
  skip_space();
  while (next_ < text_.size()) {
    read();
    skip_space();
    if (next_ < text_.size() && (text_[next_] == ',' || text_[next_] == ';')) {
      ++next_;
      skip_space();
      if (next_ == text_.size()) fail("the line ends with a separator, expected a number");
    }
  }
}

std::vector<double> TableLine::values() {
  std::vector<double> row;
  read_fields([&] { row.push_back(value()); });
  return row;
}

std::vector<std::string> TableLine::words() {
  std::vector<std::string> row;
  read_fields([&] {
    row.emplace_back(word());
    next_ += row.back().size();
  });
  return row;
}

void TableLine::fail(const std::string& message) const {
  throw InputError({Fault{{file_, number_, static_cast<int>(next_) + 1}, "", message}});
}

void TableLine::skip_space() {
  next_ = std::min(text_.find_first_not_of(kSpace, next_), text_.size());
}

std::string_view TableLine::word() {
  const std::size_t end = std::min(text_.find_first_of(kEnds, next_), text_.size());
  return text_.substr(next_, end - next_);
}

double TableLine::value() {
  const std::string_view whole = word();
  std::string_view digits = whole;
  if (digits.starts_with('+')) digits.remove_prefix(1);
  double number = 0;
  const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  const bool good = error == std::errc() && stop == digits.data() + digits.size();
  if (!good || digits.empty() || !std::isfinite(number))
    fail("found '" + std::string(whole) + "', expected " + std::string(expected_));
  next_ += whole.size();
  return number;
}

}  // namespace scene
