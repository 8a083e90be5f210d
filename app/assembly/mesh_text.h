#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace assembly {

/// Throws an InputError of a place in a mesh file, counted from 1.
[[noreturn]] void fault_at_line(const std::filesystem::path& file, int line,
                                const std::string& message);
/// Throws an InputError of a place in a binary file. @param byte   Counted from 0.
[[noreturn]] void fault_at_byte(const std::filesystem::path& file, std::uint64_t byte,
                                const std::string& message);

/// Comments and continued lines of a text format.
struct TextStyle {
  char comment = '\0';     ///< Begins a comment to the end of the line; none if 0.
  bool continued = false;  ///< A backslash at the end of a line joins the next one to it.
};

/// A mesh file of text, read line by line and word by word. Lines end with LF, CR LF or CR. The
/// bytes must outlive it. All faults are InputErrors that name the line.
class MeshText {
 public:
  MeshText(const std::filesystem::path& file, std::string_view bytes, TextStyle style = {});

  /// Moves on to the next line that has a word. @return false at the end of the file
  bool next_line();
  /// Takes the next word of the line. @return empty at its end
  std::string_view word();
  /// Takes the next word as a number, which may be infinite or not a number.
  /// @throws InputError if it is none
  double number();
  /// Takes the next word as a whole number. @throws InputError if it is none
  std::int64_t integer();
  /// Takes three numbers. @throws InputError if they are none
  Eigen::Vector3d vector();
  /// True if the line has another word.
  bool has_word();

  int line() const { return line_; }
  /// All bytes after this line.
  std::string_view rest() const;
  [[noreturn]] void fault(const std::string& message) const;

 private:
  bool at_line_end() const;
  void skip_line_end();
  void skip_blanks();
  void skip_line();
  std::size_t after_line_end(std::size_t position) const;

  const std::filesystem::path& file_;
  std::string_view bytes_;
  TextStyle style_;
  std::size_t position_ = 0;
  int line_ = 1;
  bool begun_ = false;
};

/// Returns a word of a file in quotes for a fault, shortened, without bytes that do not print.
std::string in_quotes(std::string_view word);

/// Returns a word in lower-case letters of ASCII.
std::string lower(std::string_view word);

/// Reads all bytes of a file. @throws InputError if it cannot be read
std::string bytes_of_mesh(const std::filesystem::path& file);

}  // namespace assembly
