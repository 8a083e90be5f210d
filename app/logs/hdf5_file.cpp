#include "app/logs/hdf5_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <optional>
#include <stdexcept>

#include "app/base/atomic_file.h"
#include "app/base/hdf5_library.h"
#include "app/base/open_file.h"
#include "app/base/output_error.h"
#include "app/base/running_hash.h"
#include "app/scene/diagnostics.h"

namespace app {
namespace {

namespace fs = std::filesystem;
using hdf5::Handle;
using hdf5::last_error;
using hdf5::prepare_library;
using hdf5::text_type;

/// Compression level of zlib. Most of a number's digits are noise that no level compresses.
constexpr unsigned kDeflateLevel = 1;

/// Largest growth of the chunk tables of all datasets between two reservations [bytes].
constexpr std::size_t kStructureRoom = std::size_t{1} << 20;

/// Returns properties that disable the library's own locks, which some file systems refuse; a run
/// locks its folder instead. The library writes the file's structure only in a flush, so that the
/// file is complete after each.
Handle file_access() {
  Handle access = hdf5::access_without_locks();
  H5AC_cache_config_t cache;
  cache.version = H5AC__CURR_CACHE_CONFIG_VERSION;
  H5Pget_mdc_config(access, &cache);
  cache.evictions_enabled = false;
  cache.incr_mode = H5C_incr__off;
  cache.flash_incr_mode = H5C_flash_incr__off;
  cache.decr_mode = H5C_decr__off;
  H5Pset_mdc_config(access, &cache);
  return access;
}

/// Writes the file's structure from a copy of this process, which ends as a kill of this one does
/// not end it. The structure refers to parts of itself, so that half of it is none; whoever writes
/// the same bytes again cannot damage it. If there is no copy, nothing is written.
void flush_in_copy(hid_t file) {
  const pid_t copy = ::fork();
  if (copy == 0) {
    ::setsid();  // A kill of the whole group does not end it either.
    H5Fflush(file, H5F_SCOPE_LOCAL);
    ::_exit(0);
  }
  while (copy > 0 && ::waitpid(copy, nullptr, 0) < 0 && errno == EINTR) {
  }
}

using Extents = std::vector<hsize_t>;

/// Returns the extents of rows with the shape `row`.
Extents shape_of(hsize_t rows, const std::vector<std::size_t>& row) {
  Extents shape = {rows};
  shape.insert(shape.end(), row.begin(), row.end());
  return shape;
}

Handle space_of(const Extents& shape, const hsize_t* most = nullptr) {
  return {H5Screate_simple(static_cast<int>(shape.size()), shape.data(), most), H5Sclose};
}

/// Returns properties without a creation time, so that equal runs have equal files.
Handle dataset_properties() {
  Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(properties, false);
  return properties;
}

/// Returns properties that disable the chunk cache, since each chunk is written once.
Handle write_through() {
  Handle access(H5Pcreate(H5P_DATASET_ACCESS), H5Pclose);
  H5Pset_chunk_cache(access, 1, 0, H5D_CHUNK_CACHE_W0_DEFAULT);
  return access;
}

std::vector<const char*> pointers(const std::vector<std::string>& texts) {
  std::vector<const char*> pointers;
  for (const std::string& text : texts) pointers.push_back(text.c_str());
  return pointers;
}

bool write_attribute(hid_t object, const std::string& name, hid_t space,
                     const std::vector<std::string>& texts) {
  const Handle type = text_type();
  const Handle attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose);
  return attribute >= 0 && H5Awrite(attribute, type, pointers(texts).data()) >= 0;
}

bool write_text(hid_t object, const std::string& name, const std::string& text) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  return write_attribute(object, name, space, {text});
}

std::span<const char> bytes_of(std::span<const double> numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes()};
}

}  // namespace

std::string why_no_hdf5() { return ""; }

struct Hdf5Writer::File {
  struct Series {
    Handle dataset;
    std::vector<std::size_t> shape;  ///< Shape of a row.
    std::size_t numbers = 1;         ///< Numbers of a row.
    hsize_t rows = 0;                ///< Rows that have been appended or kept.
    hsize_t in_file = 0;             ///< Rows in the file: `rows` or more.
    RunningHash hash;                ///< Hash of the first `rows` rows.

    /// Selects a part of the rows in the file.
    Handle part(hsize_t from, hsize_t count) const {
      Extents first(shape.size() + 1, 0);
      first[0] = from;
      Handle space(H5Dget_space(dataset), H5Sclose);
      H5Sselect_hyperslab(space, H5S_SELECT_SET, first.data(), nullptr,
                          shape_of(count, shape).data(), nullptr);
      return space;
    }

    /// Adds the rows that are kept to the hash. @return false if they cannot be read
    bool hash_rows() {
      constexpr hsize_t kMostNumbers = 1 << 17;
      const hsize_t most = std::max<hsize_t>(1, kMostNumbers / std::max<std::size_t>(1, numbers));
      std::vector<double> read;
      for (hsize_t row = 0; row < rows; row += most) {
        const hsize_t count = std::min(most, rows - row);
        read.resize(count * numbers);
        if (H5Dread(dataset, H5T_NATIVE_DOUBLE, space_of(shape_of(count, shape)), part(row, count),
                    H5P_DEFAULT, read.data()) < 0)
          return false;
        hash.add(bytes_of(read));
      }
      return true;
    }
  };

  /// Gives up all objects without closing them, because the library would write more.
  void abandon() {
    for (Series& each : series) each.dataset.release();
    file.release();
  }

  void check(bool done) {
    if (!done) fail(last_error());
  }

  [[noreturn]] void fail(const std::string& why) {
    abandon();
    throw OutputError(fmt::format("{}: cannot be written: {}", path.string(), why));
  }

  /// Returns the size of the file as the library sees it [bytes].
  off_t size() {
    hsize_t bytes = 0;
    check(H5Fget_filesize(file, &bytes) >= 0);
    return static_cast<off_t>(bytes);
  }

  int descriptor() {
    void* pointer = nullptr;
    check(H5Fget_vfd_handle(file, H5P_DEFAULT, &pointer) >= 0);
    return *static_cast<int*>(pointer);
  }

  /// Frees the disk space that was reserved and is not used.
  void give_back() {
    if (::ftruncate(descriptor(), size()) != 0) fail(std::strerror(errno));
  }

  /// Reserves disk space for the file's present size and `more` bytes.
  /// @return 0, or the error if there is no space. Other errors appear when data is written.
  int reserve(std::size_t more) {
    const off_t end = size() + static_cast<off_t>(more);
    if (end <= reserved) return 0;
    const int error = ::posix_fallocate(descriptor(), reserved, end - reserved);
    if (error == ENOSPC || error == EFBIG || error == EDQUOT) return error;
    reserved = end;
    return 0;
  }

  /// Gives the file its name, once it has a structure.
  void name_it() {
    if (!part) return;
    try {
      part->rename();
    } catch (const std::runtime_error& error) {
      abandon();
      throw OutputError(error.what());
    }
    part.reset();
  }

  fs::path path;
  std::optional<PartFile> part;  ///< Until the file has its name.
  Handle file;
  std::vector<Series> series;  ///< Declared after the file so that they are closed before it.
  off_t reserved = 0;          ///< File size for which disk space is reserved [bytes].
};

Hdf5Writer::Hdf5Writer(const fs::path& file, Mode mode) : file_(std::make_unique<File>()) {
  prepare_library();
  const Handle properties(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  H5Pset_obj_track_times(properties, false);
  // A chunk that grows moves. The structure on the disk refers to its old place until the next
  // flush, so nothing may be written there.
  H5Pset_file_space_strategy(properties, H5F_FSPACE_STRATEGY_AGGR, false, 1);
  file_->path = file;
  if (mode == Mode::replace) {
    std::error_code ignored;
    fs::remove(file, ignored);
    try {
      file_->part.emplace(file);
    } catch (const std::runtime_error&) {
      throw scene::InputError(file, "cannot be written: its folder takes no new files");
    }
    file_->file = Handle(
        H5Fcreate(file_->part->name().c_str(), H5F_ACC_TRUNC, properties, file_access()), H5Fclose);
  } else {
    file_->file = Handle(H5Fopen(file.c_str(), H5F_ACC_RDWR, file_access()), H5Fclose);
  }
  if (file_->file < 0)
    throw scene::InputError(file, fmt::format("cannot be written: {}", last_error()));
}

Hdf5Writer::~Hdf5Writer() { file_->abandon(); }

void Hdf5Writer::set_attributes(const Hdf5Attributes& attributes) {
  prepare_library();
  for (const auto& [name, text] : attributes) file_->check(write_text(file_->file, name, text));
}

void Hdf5Writer::add_texts(const std::string& name, const std::vector<std::string>& texts) {
  prepare_library();
  const Handle type = text_type();
  const Handle dataset(H5Dcreate2(file_->file, name.c_str(), type, space_of({texts.size()}),
                                  H5P_DEFAULT, dataset_properties(), H5P_DEFAULT),
                       H5Dclose);
  file_->check(dataset >= 0 &&
               H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, pointers(texts).data()) >= 0);
}

std::size_t Hdf5Writer::add_series(const Hdf5Series& series,
                                   const std::array<std::size_t, 2>& chunk) {
  prepare_library();
  const Extents none = shape_of(0, series.shape);
  const Extents most = shape_of(H5S_UNLIMITED, series.shape);
  Extents part = shape_of(chunk[0], series.shape);
  if (part.size() > 1) part[1] = std::min<hsize_t>(part[1], chunk[1]);
  const Handle properties = dataset_properties();
  H5Pset_chunk(properties, static_cast<int>(part.size()), part.data());
  H5Pset_shuffle(properties);
  H5Pset_deflate(properties, kDeflateLevel);
  Handle dataset(H5Dcreate2(file_->file, series.name.c_str(), H5T_IEEE_F64LE,
                            space_of(none, most.data()), H5P_DEFAULT, properties, write_through()),
                 H5Dclose);
  file_->check(dataset >= 0 && write_text(dataset, "units", series.units));
  if (!series.columns.empty())
    file_->check(
        write_attribute(dataset, "columns", space_of({series.columns.size()}), series.columns));
  std::size_t numbers = 1;
  for (const std::size_t length : series.shape) numbers *= length;
  file_->series.push_back({std::move(dataset), series.shape, numbers});
  return file_->series.size() - 1;
}

std::size_t Hdf5Writer::find_series(const Hdf5Series& series, std::size_t rows,
                                    std::uint64_t hash) {
  prepare_library();
  Handle dataset(H5Dopen2(file_->file, series.name.c_str(), write_through()), H5Dclose);
  const auto refuse = [&](const char* why) {
    throw scene::InputError(file_->path, fmt::format("the dataset {} {}", series.name, why));
  };
  if (dataset < 0) refuse("is missing");
  const Handle space(H5Dget_space(dataset), H5Sclose);
  Extents shape(series.shape.size() + 1);
  if (H5Sget_simple_extent_ndims(space) != static_cast<int>(shape.size()) ||
      H5Sget_simple_extent_dims(space, shape.data(), nullptr) < 0 || shape[0] < rows)
    refuse("is not that of the checkpoint");
  std::size_t numbers = 1;
  for (const std::size_t length : series.shape) numbers *= length;
  file_->series.push_back({std::move(dataset), series.shape, numbers, rows, shape[0], {}});
  if (!file_->series.back().hash_rows()) refuse("cannot be read");
  if (file_->series.back().hash.value() != hash)
    refuse("has changed since its checkpoint was written");
  return file_->series.size() - 1;
}

std::uint64_t Hdf5Writer::hash_of(std::size_t series) const {
  return file_->series[series].hash.value();
}

void Hdf5Writer::append(std::size_t number, std::span<const double> numbers) {
  prepare_library();
  File::Series& series = file_->series[number];
  const hsize_t rows = numbers.size() / series.numbers;
  const hsize_t first = series.rows;
  series.rows += rows;
  series.in_file = std::max(series.in_file, series.rows);
  file_->check(H5Dset_extent(series.dataset, shape_of(series.in_file, series.shape).data()) >= 0);
  file_->check(H5Dwrite(series.dataset, H5T_NATIVE_DOUBLE, space_of(shape_of(rows, series.shape)),
                        series.part(first, rows), H5P_DEFAULT, numbers.data()) >= 0);
  series.hash.add(bytes_of(numbers));
}

void Hdf5Writer::reserve(std::size_t bytes) {
  prepare_library();
  const int error = file_->reserve(bytes + kStructureRoom);
  if (error == 0) return;
  flush();
  file_->give_back();
  file_->fail(std::strerror(error));
}

void Hdf5Writer::flush() {
  prepare_library();
  if (const int error = file_->reserve(0); error != 0) file_->fail(std::strerror(error));
  flush_in_copy(file_->file);
  file_->check(H5Fflush(file_->file, H5F_SCOPE_LOCAL) >= 0);
  file_->name_it();
  if (!has_name(file_->descriptor(), file_->path)) file_->fail(kGone);
}

void Hdf5Writer::close() {
  flush();
  file_->give_back();
  for (File::Series& series : file_->series) file_->check(series.dataset.close());
  file_->check(file_->file.close());
}

}  // namespace app
