#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// @file
/// Files of named arrays: NetCDF, in its classic format and in that on HDF5, and HDF5.

namespace databases {

/// Numbers or texts, row by row.
struct Array {
  std::vector<std::size_t> shape;
  std::vector<std::string> dimensions;  ///< Their names; empty where the file gives none.
  std::vector<double> numbers;          ///< Empty for texts.
  std::vector<std::string> texts;       ///< Empty for numbers.

  std::size_t size() const { return texts.empty() ? numbers.size() : texts.size(); }
};

/// A file that is read array by array.
class ArrayFile {
 public:
  explicit ArrayFile(std::filesystem::path file) : path_(std::move(file)) {}
  virtual ~ArrayFile() = default;

  /// Returns an array; none if the file has none of that name.
  /// @param name   In HDF5 the path `group/array`.
  /// @throws InputError if it cannot be read
  virtual std::optional<Array> find(const std::string& name) const = 0;
  /// As `find`. @throws InputError if there is none
  Array require(const std::string& name) const;
  /// Returns the first number of an array; none if there is no such array, or one of texts.
  std::optional<double> number(const std::string& name) const;
  /// Returns the first text of an array; none if there is no such array, or one of numbers.
  std::optional<std::string> text(const std::string& name) const;

  const std::filesystem::path& path() const { return path_; }
  /// @throws InputError always
  [[noreturn]] void refuse(const std::string& message) const;

 private:
  std::filesystem::path path_;
};

}  // namespace databases
