#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

/// @file
/// HDF5 files of numbers over time. Only hdf5_file.cpp knows the library. A program that was built
/// without it has hdf5_absent.cpp in its place, where both constructors throw InputError.

namespace app {

/// What to do about a program that was built without the library; empty if it has it.
std::string why_no_hdf5();

/// Rows of numbers over time: a dataset whose first dimension grows.
struct Hdf5Series {
  std::string name;
  std::string units;
  /// Names along the last dimension, if it has more than one number.
  std::vector<std::string> columns;
  std::vector<std::size_t> shape;  ///< Of a row: the further dimensions.
};

/// Texts by their names.
using Hdf5Attributes = std::vector<std::pair<std::string, std::string>>;

/// A file that is written while a run goes on: first its structure, then rows. After `flush` it has
/// all rows before, whatever becomes of the program later, but for a kill within a `flush` itself.
///
/// All but the constructor throw OutputError if the file cannot be written. From then on it is left
/// as the last `flush` has made it.
class Hdf5Writer {
 public:
  enum class Mode {
    replace,  ///< A new file takes the place of one that is there.
    extend    ///< The file is there; its series are found and go on.
  };
  /// @throws InputError if it cannot be written, or is to be extended and is damaged.
  explicit Hdf5Writer(const std::filesystem::path& file, Mode mode = Mode::replace);
  /// Call `close` before, to learn whether it could be.
  ~Hdf5Writer();
  Hdf5Writer(const Hdf5Writer&) = delete;
  Hdf5Writer& operator=(const Hdf5Writer&) = delete;

  void set_attributes(const Hdf5Attributes& attributes);
  /// A dataset of texts.
  void add_texts(const std::string& name, const std::vector<std::string>& texts);
  /// @param chunk   What is compressed and stored as one: rows, and so many of their first
  /// dimension
  ///     at most. @return the series' number, from 0.
  std::size_t add_series(const Hdf5Series& series, const std::array<std::size_t, 2>& chunk);

  /// A series of a file that is extended: its first `rows` rows stay, others go.
  /// @return the series' number. @throws InputError if it is missing or shorter.
  std::size_t find_series(const Hdf5Series& series, std::size_t rows);

  /// Takes room on the disk for so many more bytes of numbers. Where there is none, all rows before
  /// are flushed before it throws.
  void reserve(std::size_t bytes);
  /// @param numbers   Whole rows, a chunk's or in the end fewer: each part of a chunk that comes by
  ///     itself is stored anew.
  void append(std::size_t series, std::span<const double> numbers);
  void flush();
  void close();

 private:
  struct File;
  std::unique_ptr<File> file_;
};

/// Reads what Hdf5Writer has written, also where it was killed.
///
/// All throw InputError if the file is not as expected.
class Hdf5Reader {
 public:
  explicit Hdf5Reader(const std::filesystem::path& file);
  ~Hdf5Reader();
  Hdf5Reader(const Hdf5Reader&) = delete;
  Hdf5Reader& operator=(const Hdf5Reader&) = delete;

  /// True if there is a dataset of that name.
  bool has(const std::string& name) const;
  std::vector<std::string> texts(const std::string& name) const;
  /// All numbers of a series, row by row. @param shape   That its rows must have.
  std::vector<double> numbers(const std::string& name, const std::vector<std::size_t>& shape) const;

 private:
  struct File;
  std::unique_ptr<File> file_;
};

}  // namespace app
