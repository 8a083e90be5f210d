#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace scene {

/// A line of a table that is parsed from left to right. Fields are separated by commas, semicolons
/// or white space; text after a # is skipped.
class TableLine {
 public:
  /// @param number     Number of the line, from 1, for faults.
  /// @param expected   Description of a number for faults: `a finite number [m]`.
  TableLine(const std::filesystem::path& file, int number, std::string_view text,
            std::string_view expected);

  /// Returns the numbers in the line; none if it is empty. @throws InputError
  std::vector<double> values();
  /// Returns the fields of the line as they are. @throws InputError if the last one is missing.
  std::vector<std::string> words();

  /// Refuses the line at the place that has been reached. @throws InputError always.
  [[noreturn]] void fail(const std::string& message) const;

 private:
  void skip_space();
  std::string_view word();
  double value();
  template <class Read>
  void read_fields(const Read& read);

  const std::filesystem::path& file_;
  int number_;
  std::string_view text_;
  std::string_view expected_;
  std::size_t next_ = 0;
};

}  // namespace scene
