#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

/// @file
/// HDF5 files of numbers over time. hdf5_file.cpp and hdf5_reader.cpp use the library. A program
/// built without it has hdf5_absent.cpp instead, where both constructors throw InputError.

namespace app {

/// Returns advice for a program that was built without the library; empty if it has the library.
std::string why_no_hdf5();

/// Rows of numbers over time: a dataset whose first dimension grows.
struct Hdf5Series {
  std::string name;
  std::string units;
  /// Names of the numbers along the last dimension, if it has more than one.
  std::vector<std::string> columns;
  std::vector<std::size_t> shape;  ///< Dimensions of a row.
};

/// Pairs of a name and a text.
using Hdf5Attributes = std::vector<std::pair<std::string, std::string>>;

/// A file that is written during a run: first its structure, then rows. `flush` saves all earlier
/// rows: whenever the program is killed, the file holds at least those of the last `flush` that has
/// ended. A failure of power may damage the file.
///
/// All functions but the constructor throw OutputError if the file cannot be written, and `flush`
/// if it has been removed or replaced. The file then keeps the state of the last `flush`.
class Hdf5Writer {
 public:
  enum class Mode {
    replace,  ///< A new file replaces an existing one; it has its name from the first flush on.
    extend    ///< The file exists and its series are continued.
  };
  /// @throws InputError if the file cannot be written, or cannot be extended because it is damaged.
  explicit Hdf5Writer(const std::filesystem::path& file, Mode mode = Mode::replace);
  /// Leaves the file as the last `flush` or `close` made it.
  ~Hdf5Writer();
  Hdf5Writer(const Hdf5Writer&) = delete;
  Hdf5Writer& operator=(const Hdf5Writer&) = delete;

  void set_attributes(const Hdf5Attributes& attributes);
  /// Adds a dataset of texts.
  void add_texts(const std::string& name, const std::vector<std::string>& texts);
  /// Adds an empty series.
  /// @param chunk   Size of a chunk, which is compressed and stored as a unit: rows, and at most so
  ///     many entries of a row's first dimension.
  /// @return the series' number, from 0.
  std::size_t add_series(const Hdf5Series& series, const std::array<std::size_t, 2>& chunk);

  /// Finds a series of a file that is extended. The rows that are appended follow its first `rows`
  /// rows; they replace others that come after these, which remain until then. (Dropping rows would
  /// write over data that the structure on the disk refers to until the next flush.)
  /// @param hash   Result of `hash_of` for these rows.
  /// @return the series' number. @throws InputError if it is missing or shorter, or has other
  /// numbers
  std::size_t find_series(const Hdf5Series& series, std::size_t rows, std::uint64_t hash);

  /// Returns the RunningHash of the rows of a series.
  std::uint64_t hash_of(std::size_t series) const;

  /// Reserves disk space for `bytes` more bytes of numbers. If there is none, all earlier rows are
  /// flushed before the function throws.
  void reserve(std::size_t bytes);
  /// Adds rows to a series.
  /// @param numbers   Whole rows, of one chunk only. If they do not fill it, they are written
  ///     again, elsewhere, with the next rows of the chunk.
  void append(std::size_t series, std::span<const double> numbers);
  void flush();
  void close();

 private:
  struct File;
  std::unique_ptr<File> file_;
};

}  // namespace app
